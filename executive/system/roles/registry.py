"""Finds the roles: the files beside this one, and the entry points ``tandem.roles`` and ``tandem.skills``.

A campaign has a role played by code of its own: ``played_by`` of a process's settings names it.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType
from typing import Final

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.security.rights import Rights
from tandem.executive.security.role import Part
from tandem.executive.system import roles
from tandem.executive.system.roles.role import Kind, Role
from tandem.executive.system.roles.skill_type import SkillType
from tandem.skills.ports.hardware import RobotDescription
from tandem.skills.ports.plugins import NONE, Group, Loaded, load

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
    return MappingProxyType({role.name: role for role in _in_order(found)})


def plugged_roles(left_out: Mapping[str, str] = NONE) -> Loaded[Role]:
    """Return the roles of other packages."""
    return load(Group.ROLES, _checked_role, taken=shipped(), left_out=left_out)


def plugged_skills(left_out: Mapping[str, str] = NONE) -> Loaded[Role]:
    """Return the skills of other packages, each as the role of the process that serves it."""
    taken = {*shipped(), *plugged_roles(left_out).found}
    return load(Group.SKILLS, _checked_skill, taken=taken, left_out=left_out)


def plugged(left_out: Mapping[str, str] = NONE) -> Mapping[str, Role]:
    """Return the roles that other packages add, with those of their skills, in the order of their start."""
    found = {**plugged_roles(left_out).found, **plugged_skills(left_out).found}
    return MappingProxyType({role.name: role for role in _in_order(found.values())})


def every(left_out: Mapping[str, str] = NONE) -> Mapping[str, Role]:
    """Return all roles, in the order in which they are started."""
    found = _in_order((*shipped().values(), *plugged(left_out).values()))
    return MappingProxyType({role.name: role for role in found})


def names(*, on_request: bool = False, left_out: Mapping[str, str] | None = None) -> tuple[str, ...]:
    """Return the roles of a whole system.

    Args:
        on_request: also those that nothing needs.
        left_out: also those of plug-ins, but for these; None: only those that ship.
    """
    found = shipped() if left_out is None else every(left_out)
    return tuple(role.name for role in found.values() if on_request or not role.on_request)


def skill_roles(description: RobotDescription, left_out: Mapping[str, str] | None = None) -> tuple[Role, ...]:
    """Return the roles of skills that a robot needs, in the order in which lockstep steps them.

    Args:
        description: of the robot.
        left_out: as for ``names``.
    """
    found = shipped() if left_out is None else every(left_out)
    return tuple(role for role in found.values() if role.kind == "skills" and role.needed(description))


def role_of(settings: WorkerSettings) -> Role:
    """Return the role that a process is to play.

    Raises:
        LookupError: naming the roles that there are.
    """
    if settings.played_by:
        module, attribute = settings.played_by.split(":")
        named = getattr(importlib.import_module(module), attribute)
        assert isinstance(named, Role), f"{settings.played_by} is no role"
        return named
    if settings.role in shipped():
        return shipped()[settings.role]
    found = every(settings.left_out)
    if settings.role not in found:
        broken = (*plugged_roles(settings.left_out).broken, *plugged_skills(settings.left_out).broken)
        why = "".join(f"; {each}" for each in broken if each.plugin.name == settings.role)
        raise LookupError(f"role {settings.role!r}: expected one of {', '.join(found)}{why}")
    return found[settings.role]


def part_of(role: Role) -> Part:
    """Return the part of the robot whose certificate the role shows."""
    return _PART[role.kind]


def rights_of_parts(left_out: Mapping[str, str] = NONE) -> Mapping[Part, Rights]:
    """Return what each part of the robot may do: all that any of its roles may, plug-ins' with them."""
    found: dict[Part, Rights] = {}
    for role in every(left_out).values():
        found[part_of(role)] = found.get(part_of(role), Rights()).also(role.rights)
    return MappingProxyType(found)


def _in_order(found: Iterable[Role]) -> list[Role]:
    return sorted(found, key=lambda each: each.starts)


def _checked_role(name: str, value: object) -> Role:
    if not isinstance(value, Role):
        raise TypeError(f"expected a Role; found {type(value).__name__}")
    if value.name != name:
        raise TypeError(f"the entry point is called {name!r} and its role {value.name!r}; expected one name")
    if value.kind not in {"skills", "observer"}:
        raise TypeError(f"expected a role of the kind skills or observer; found {value.kind}")
    if (value.nodes is None) == (value.play is None) or value.route is not None:
        raise TypeError("expected a role with either nodes or play")
    return value


def _checked_skill(name: str, value: object) -> Role:
    if not isinstance(value, SkillType):
        raise TypeError(f"expected a SkillType; found {type(value).__name__}")
    if value.name != name:
        raise TypeError(f"the entry point is called {name!r} and its skill {value.name!r}; expected one name")
    return value.role()
