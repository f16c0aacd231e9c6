"""The world model: items, what is in which hand, the planning scene."""

from __future__ import annotations

from collections.abc import Sequence

from tandem.executive.system.roles.role import Role, Surroundings, skill_rights
from tandem.skills.ports.node import Node


def _nodes(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.world.process import nodes  # noqa: PLC0415

    return nodes(at.bus, at.clocks, at.site, at.description.hands, at.journal, charge=at.charge)


ROLES = (
    Role(
        name="keeper",
        starts=20,
        kind="skills",
        nodes=_nodes,
        calm="always",
        rights=skill_rights(tells=("world/**",)),
    ),
)
