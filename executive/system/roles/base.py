"""The base: localisation, driving, and the guard that brakes before an obstacle."""

from __future__ import annotations

from collections.abc import Sequence

from tandem.executive.config.extras import SKILLS
from tandem.executive.system.roles.role import Role, Surroundings, skill_rights
from tandem.skills.ports.node import Node
from tandem.skills.ports.whereabouts import Neighbours


def _nodes(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.base.process import build  # noqa: PLC0415

    return build(
        at.bus,
        at.clocks,
        at.description,
        at.site,
        charge=at.charge,
        left_out=at.left_out,
        neighbours=Neighbours(at.commons, at.clocks, at.robot),
    )


ROLES = (
    Role(
        name="base",
        starts=40,
        kind="skills",
        extra=SKILLS,
        nodes=_nodes,
        rights=skill_rights(tells=("world/**", "hw/base/velocity")),
    ),
)
