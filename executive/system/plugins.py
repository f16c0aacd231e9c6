"""The groups of plug-ins, and what loads each: the room that it is for."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Final

from tandem.skills.ports.plugins import Group, Loaded


def _tasks(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.trees.registry import plugged  # noqa: PLC0415 - each process loads what it needs

    return plugged(left_out)


def _nodes(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.trees.nodes import plugged  # noqa: PLC0415

    return plugged(left_out)


def _roles(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.executive.system.roles.registry import plugged_roles  # noqa: PLC0415

    return plugged_roles(left_out)


def _skills(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.executive.system.roles.registry import plugged_skills  # noqa: PLC0415

    return plugged_skills(left_out)


def _robots(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.sim.robots.registry import plugged  # noqa: PLC0415

    return plugged(left_out)


def _sites(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.skills.site import plugged  # noqa: PLC0415

    return plugged(left_out)


def _detectors(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.skills.perception.detectors import plugged  # noqa: PLC0415

    return plugged(left_out)


def _reflexes(left_out: Mapping[str, str]) -> Loaded[object]:
    from tandem.skills.reflex_owners import plugged  # noqa: PLC0415

    return plugged(left_out)


GROUPS: Final[Mapping[Group, Callable[[Mapping[str, str]], Loaded[object]]]] = MappingProxyType(
    {
        Group.TASKS: _tasks,
        Group.ROLES: _roles,
        Group.SKILLS: _skills,
        Group.ROBOTS: _robots,
        Group.SITES: _sites,
        Group.NODES: _nodes,
        Group.DETECTORS: _detectors,
        Group.REFLEXES: _reflexes,
    }
)
"""Each returns the plug-ins of its group, without those that are known not to load."""
