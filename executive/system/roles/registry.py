"""Finds the roles: the files beside this one, and the entry points ``tandem.roles`` and ``tandem.skills``.

A campaign has a role played by code of its own: ``played_by`` of a process's settings names it.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterable, Mapping
from functools import cache
from types import MappingProxyType, ModuleType
from typing import Final

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.security.rights import Rights
from tandem.executive.security.role import Part
from tandem.executive.system import roles
from tandem.executive.system.roles.role import Family, Kind, Role
from tandem.executive.system.roles.skill_type import SkillType
from tandem.skills.ports.plugins import UNTRIED, Group, Loaded, installed, load
from tandem.skills.ports.robot_description import RobotDescription

_PART: Final[Mapping[Kind, Part]] = MappingProxyType(
    {
        "router": "router",
        "hardware": "hardware",
        "skills": "skills",
        "observer": "skills",
        "recorder": "supervisor",
        "executive": "executive",
    }
)


@cache
def _modules() -> tuple[ModuleType, ...]:
    return tuple(
        importlib.import_module(f"{roles.__name__}.{module.name}")
        for module in pkgutil.iter_modules(roles.__path__)
    )


@cache
def shipped() -> Mapping[str, Role]:
    """Return the roles whose files are here, but those of families, in the order of their start."""
    found = [role for module in _modules() for role in getattr(module, "ROLES", ())]
    return MappingProxyType({role.name: role for role in _in_order(found)})


@cache
def families() -> tuple[Family, ...]:
    """Return the families whose files are here."""
    return tuple(module.FAMILY for module in _modules() if hasattr(module, "FAMILY"))


def plugged_roles(left_out: Mapping[str, str] = UNTRIED) -> Loaded[Role]:
    """Return the roles of other packages."""
    return load(Group.ROLES, _checked_role, taken=_taken(), left_out=left_out)


def plugged_skills(left_out: Mapping[str, str] = UNTRIED) -> Loaded[Role]:
    """Return the skills of other packages, each as the role of the process that serves it."""
    taken = {*_taken(), *plugged_roles(left_out).found}
    return load(Group.SKILLS, _checked_skill, taken=taken, left_out=left_out)


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Mapping[str, Role]:
    """Return the roles that other packages add, with those of their skills, in the order of their start."""
    found = {**plugged_roles(left_out).found, **plugged_skills(left_out).found}
    return MappingProxyType({role.name: role for role in _in_order(found.values())})


def every(left_out: Mapping[str, str] = UNTRIED) -> Mapping[str, Role]:
    """Return all roles but those of families, in the order in which they are started."""
    found = _in_order((*shipped().values(), *plugged(left_out).values()))
    return MappingProxyType({role.name: role for role in found})


def needed_roles(
    description: RobotDescription, left_out: Mapping[str, str] | None = None
) -> tuple[Role, ...]:
    """Return the roles of a robot's whole system, in the order in which they are started.

    Args:
        description: of the robot.
        left_out: also those of plug-ins, but for these; None: only those that ship.
    """
    found = shipped() if left_out is None else every(left_out)
    fixed = [role for role in found.values() if not role.on_request and role.needed(description)]
    parts = [family.role(part) for family in families() for part in family.parts(description)]
    return tuple(_in_order([*fixed, *parts]))


def names(description: RobotDescription, left_out: Mapping[str, str] | None = None) -> tuple[str, ...]:
    """Return the names of the roles of a robot's whole system, as ``needed_roles`` does."""
    return tuple(role.name for role in needed_roles(description, left_out))


def skill_roles(description: RobotDescription, left_out: Mapping[str, str] | None = None) -> tuple[Role, ...]:
    """Return the roles of skills that a robot needs, in the order in which lockstep steps them."""
    return tuple(role for role in needed_roles(description, left_out) if role.kind == "skills")


def role_named(name: str, left_out: Mapping[str, str] | None = None) -> Role | None:
    """Return the role of a name, or None; with ``left_out`` also those of plug-ins, but for these."""
    found = shipped() if left_out is None else every(left_out)
    of_families = (family.named(name) for family in families())
    return found.get(name) or next((role for role in of_families if role is not None), None)


def known_names(left_out: Mapping[str, str] | None = None) -> tuple[str, ...]:
    """Return what roles may be called, for people; ``arm_NAME`` stands for one of each hand."""
    found = shipped() if left_out is None else every(left_out)
    return (*found, *(f"{family.prefix}NAME" for family in families()))


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
    role = role_named(settings.role) or role_named(settings.role, settings.left_out)
    if role is None:
        broken = (*plugged_roles(settings.left_out).broken, *plugged_skills(settings.left_out).broken)
        why = "".join(f"; {each}" for each in broken if each.plugin.name == settings.role)
        known = ", ".join(known_names(settings.left_out))
        raise LookupError(f"role {settings.role!r}: expected one of {known}{why}")
    return role


def part_of(role: Role) -> Part:
    """Return the part of the robot whose certificate the role shows."""
    return _PART[role.kind]


def rights_of_parts(left_out: Mapping[str, str] = UNTRIED) -> Mapping[Part, Rights]:
    """Return what each part of the robot may do: all that any of its roles may, plug-ins' with them."""
    found: dict[Part, Rights] = {}
    of_families = [family.role("any") for family in families()]
    for role in (*every(left_out).values(), *of_families):
        found[part_of(role)] = found.get(part_of(role), Rights()).also(role.rights)
    return MappingProxyType(found)


def _in_order(found: Iterable[Role]) -> list[Role]:
    return sorted(found, key=lambda each: each.starts)


def _taken() -> frozenset[str]:
    """Return the names that plug-ins can't have: roles that ship, and what a family calls one of its own."""
    asked = {each.name for group in (Group.ROLES, Group.SKILLS) for each in installed(group)}
    ours = {name for name in asked if any(family.named(name) is not None for family in families())}
    return frozenset({*shipped(), *ours})


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
