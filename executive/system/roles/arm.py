"""An arm with its gripper: planning, motion, their reflexes, and the watch over what the hand holds."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from tandem.executive.config.extras import SKILLS
from tandem.executive.system.roles.role import Family, Role, Surroundings, skill_rights
from tandem.skills.ports.message import HandName
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription


def _nodes(side: HandName, at: Surroundings) -> Sequence[Node]:
    from tandem.skills.arm.planning.settings import PlannerSettings  # noqa: PLC0415
    from tandem.skills.arm.process import nodes as arm_nodes  # noqa: PLC0415
    from tandem.skills.arm.reflexes.registry import OWNER  # noqa: PLC0415
    from tandem.skills.gripper.process import nodes as gripper_nodes  # noqa: PLC0415
    from tandem.skills.kinematics.described import check_reach, load_hulls  # noqa: PLC0415
    from tandem.skills.limbs import Limb, arm  # noqa: PLC0415
    from tandem.skills.ports.reflex import ARM, HAND  # noqa: PLC0415

    hulls = load_hulls(at.description, at.seed)
    check_reach(at.description, hulls)
    group = at.description.end_effector(side).group
    choice = OWNER.chosen_for(
        OWNER.types(at.left_out), at.description, at.site, f"site {at.site.name}", part=side
    )
    limb = Limb(arm(at.bus, at.clocks, at.description, side), choice)
    return [
        limb,
        *arm_nodes(
            at.bus,
            at.clocks,
            at.description,
            [group],
            hulls=hulls,
            settings=PlannerSettings(planner=at.site.arm_planner),
            seed=at.seed,
            charge=at.charge,
            compute=at.compute,
            pipelines={group: limb.pipeline(ARM)},
        ),
        *gripper_nodes(
            at.bus, at.clocks, at.description, side, charge=at.charge, pipeline=limb.pipeline(HAND)
        ),
    ]


def _role(side: HandName) -> Role:
    return Role(
        name=f"arm_{side}",
        starts=60,
        kind="skills",
        extra=SKILLS,
        nodes=partial(_nodes, side),
        calm="between goals",  # the watch over the hand tells what it sees 50 ms later, at the most
        rights=skill_rights(
            tells=("hw/group/*/setpoint",),
            asks=("hw/group/*/goal", "hw/group/*/cancel", "hw/gripper/*/command"),
        ),
    )


def _hands(description: RobotDescription) -> Sequence[HandName]:
    return description.hands


FAMILY = Family(prefix="arm_", parts=_hands, role=_role)
