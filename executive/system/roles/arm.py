"""An arm with its gripper: planning, motion, and the watch over what the hand holds."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from tandem.executive.config.extras import SKILLS
from tandem.executive.system.roles.role import Role, Surroundings, skill_rights
from tandem.skills.ports.hardware import RobotDescription
from tandem.skills.ports.node import Node
from tandem.skills.ports.world import SIDES, Side


def _nodes(side: Side, at: Surroundings) -> Sequence[Node]:
    from tandem.skills.arm.process import nodes as arm_nodes  # noqa: PLC0415
    from tandem.skills.gripper.process import nodes as gripper_nodes  # noqa: PLC0415

    group = at.description.end_effector(side).group
    return [
        *arm_nodes(
            at.bus,
            at.clocks,
            at.description,
            [group],
            seed=at.seed,
            charge=at.charge,
            compute=at.compute,
        ),
        *gripper_nodes(at.bus, at.clocks, at.description, side, charge=at.charge),
    ]


def _needed(side: Side, description: RobotDescription) -> bool:
    return any(each.side == side for each in description.end_effectors)


ROLES = tuple(
    Role(
        name=f"arm_{side}",
        starts=60 + place,
        kind="skills",
        extra=SKILLS,
        needed=partial(_needed, side),
        nodes=partial(_nodes, side),
        rights=skill_rights(
            tells=("hw/group/*/setpoint",),
            asks=("hw/group/*/goal", "hw/group/*/cancel", "hw/gripper/*/command"),
        ),
    )
    for place, side in enumerate(SIDES)
)
