"""What needs both arms at once: the reflex against crossing arms, coordination, two hands on one thing."""

from __future__ import annotations

import importlib
from collections.abc import Sequence

from tandem.executive.config.extras import SKILLS
from tandem.executive.system.roles.role import Role, Surroundings, skill_rights
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription


def _nodes(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.bimanual.process import nodes  # noqa: PLC0415
    from tandem.skills.kinematics.described import load_hulls  # noqa: PLC0415
    from tandem.skills.reflex.process import nodes as reflexes  # noqa: PLC0415

    hulls = load_hulls(at.description, at.seed)
    return [
        *reflexes(at.bus, at.description, at.site, hulls),
        *nodes(
            at.bus,
            at.clocks,
            at.description,
            site=at.site,
            compute=at.compute,
            hulls=hulls,
            charge=at.charge,
        ),
    ]


def _load() -> None:
    importlib.import_module("tandem.skills.bimanual.process")


def _needed(description: RobotDescription) -> bool:
    return set(PAIR) <= set(description.hands)


ROLES = (
    Role(
        name="bimanual",
        starts=50,
        kind="skills",
        extra=SKILLS,
        needed=_needed,
        nodes=_nodes,
        ahead=_load,
        worker="once",  # the workspace zones are found at the start
        rights=skill_rights(
            tells=("hw/group/*/setpoint",),
            asks=("hw/group/*/goal", "hw/group/*/cancel", "hw/gripper/*/command"),
        ),
    ),
)
