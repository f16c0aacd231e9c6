"""Perception: the head camera's pictures, tags and clutter. It turns the head."""

from __future__ import annotations

import importlib
from collections.abc import Sequence

from tandem.executive.config.extras import SKILLS
from tandem.executive.system.roles.role import Role, Surroundings, skill_rights
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription


def _nodes(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.perception.detectors import detectors  # noqa: PLC0415
    from tandem.skills.perception.process import nodes  # noqa: PLC0415

    seen_by = detectors(at.left_out)
    return nodes(
        at.bus,
        at.clocks,
        at.description,
        at.site,
        at.compute,
        detectors=seen_by,
        charge=at.charge,
        map_file=at.map_file,
        left_out=at.left_out,
    )


def _load() -> None:
    importlib.import_module("tandem.skills.perception.process")


def _needed(description: RobotDescription) -> bool:
    return bool(description.cameras)


ROLES = (
    Role(
        name="perception",
        starts=30,
        kind="skills",
        extra=SKILLS,
        needed=_needed,
        pictures=True,
        calm="always",
        nodes=_nodes,
        ahead=_load,
        worker="forked",
        rights=skill_rights(tells=("world/**",), asks=("hw/group/*/goal", "hw/group/*/cancel")),
    ),
)
