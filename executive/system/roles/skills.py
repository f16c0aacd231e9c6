"""All skills that ship in one process, for small robots: one clock to hear, one set of hulls to load.

It is started in place of the skills' own processes (``tandem up --processes few``). Those of plug-ins keep
theirs, so that one that can't be trusted takes no other with it.
"""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Sequence
from typing import Final

from tandem.executive.config.extras import SKILLS
from tandem.executive.system.roles.role import Role, Surroundings, skill_rights
from tandem.skills.ports.node import Node

NAME: Final = "skills"


def gathered(names: Iterable[str]) -> tuple[str, ...]:
    """Return what is started instead of these roles when the skills that ship share a process."""
    from tandem.executive.system.roles.registry import role_named  # noqa: PLC0415 - it loads this file

    started: dict[str, None] = {}
    for name in names:
        role = role_named(name)  # of plug-ins it knows nothing
        started[NAME if role is not None and role.kind == "skills" else name] = None
    return tuple(started)


def _nodes(at: Surroundings) -> Sequence[Node]:
    from tandem.executive.system.roles.registry import skill_roles  # noqa: PLC0415 - it loads this file

    return [node for role in skill_roles(at.description) if role.nodes is not None for node in role.nodes(at)]


def _load() -> None:
    importlib.import_module("tandem.skills.perception.process")
    importlib.import_module("tandem.skills.bimanual.process")


ROLES = (
    Role(
        name=NAME,
        starts=20,
        kind="skills",
        extra=SKILLS,
        pictures=True,
        nodes=_nodes,
        ahead=_load,
        worker="forked",
        rights=skill_rights(),  # all that any role of skills may: they share a certificate
        on_request=True,
    ),
)
