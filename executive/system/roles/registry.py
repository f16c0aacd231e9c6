"""Finds the roles: the files beside this one, and those that an installed package declares.

A package declares one under the entry points ``tandem.roles``; its name there is what ``played_by`` of a
process's settings names.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping
from functools import cache
from importlib.metadata import entry_points
from types import MappingProxyType
from typing import Final

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.security.rights import Rights
from tandem.executive.security.role import Part
from tandem.executive.system import roles
from tandem.executive.system.roles.role import Kind, Role
from tandem.skills.ports.hardware import RobotDescription

GROUP: Final = "tandem.roles"
_PART: Final[Mapping[Kind, Part]] = MappingProxyType(
    {
        "router": "router",
        "hardware": "hardware",
        "skills": "skills",
        "observer": "skills",
        "executive": "executive",
    }
)


@cache
def shipped() -> Mapping[str, Role]:
    """Return the roles whose files are here, in the order in which they are started."""
    found: list[Role] = []
    for module in pkgutil.iter_modules(roles.__path__):
        loaded = importlib.import_module(f"{roles.__name__}.{module.name}")
        found.extend(getattr(loaded, "ROLES", ()))
    return MappingProxyType({role.name: role for role in sorted(found, key=lambda each: each.starts)})


@cache
def names(*, on_request: bool = False) -> tuple[str, ...]:
    """Return the roles of a whole system; with ``on_request`` also those that nothing needs."""
    return tuple(role.name for role in shipped().values() if on_request or not role.on_request)


def skill_roles(description: RobotDescription) -> tuple[Role, ...]:
    """Return the roles of skills that a robot needs, in the order in which lockstep steps them."""
    return tuple(role for role in shipped().values() if role.kind == "skills" and role.needed(description))


def role_of(settings: WorkerSettings) -> Role:
    """Return the role that a process is to play.

    Raises:
        LookupError: naming the roles that there are.
    """
    if not settings.played_by and settings.role in shipped():
        return shipped()[settings.role]
    return _declared(settings.played_by or settings.role)


@cache  # a supervisor asks each time it looks at its processes, and entry points are read from files
def _declared(name: str) -> Role:
    for entry in entry_points(group=GROUP, name=name):
        loaded = entry.load()
        if isinstance(loaded, Role):
            return loaded
    known = ", ".join((*names(on_request=True), *sorted(entry_points(group=GROUP).names)))
    raise LookupError(f"role {name!r}: expected one of {known}")


def part_of(role: Role) -> Part:
    """Return the part of the robot whose certificate the role shows."""
    return _PART[role.kind]


def rights_of_parts() -> Mapping[Part, Rights]:
    """Return what each part of the robot may do: all that any of its roles may."""
    found: dict[Part, Rights] = {}
    for role in shipped().values():
        found[part_of(role)] = found.get(part_of(role), Rights()).also(role.rights)
    return MappingProxyType(found)
