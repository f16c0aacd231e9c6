"""Finds the base's reflexes: the files beside this one, and the entry points ``tandem.reflexes``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, Final

from tandem.skills.base.reflexes import approach, avoid_collision, base_guard, bumper, cliff
from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.ports.plugins import UNTRIED, Group, Loaded, installed, load
from tandem.skills.ports.reflex import BASE
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.reflexes import Chosen, ReflexType, chosen

BaseReflex = ReflexType[BaseSurroundings, Any]
"""A reflex of the base, whatever its parameters."""

SHIPPED: Final[Mapping[str, BaseReflex]] = MappingProxyType(
    {each.REFLEX.name: each.REFLEX for each in (cliff, bumper, base_guard, avoid_collision, approach)}
)
"""Those that come along, by name."""


def reflexes(left_out: Mapping[str, str] | None = UNTRIED) -> tuple[BaseReflex, ...]:
    """Return the base's reflexes, those that come along first.

    Args:
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.
    """
    others = {} if left_out is None else plugged(left_out).found
    return (*SHIPPED.values(), *others.values())


def chosen_for(
    types: Sequence[BaseReflex], robot: RobotDescription, site: Site, site_called: str
) -> list[Chosen[BaseSurroundings]]:
    """Return the reflexes of a robot's base, as its description and then the site declare them.

    Args:
        types: the reflexes there are.
        robot: its description.
        site: where it is.
        site_called: what to call the site's file in an error.

    Raises:
        DocumentError: as ``tandem.skills.reflexes.chosen``.
    """
    declared = [
        *((f"robot {robot.name}: reflexes.{at}", each) for at, each in enumerate(robot.reflexes)),
        *((f"{site_called}: reflexes.{at}", each) for at, each in enumerate(site.reflexes)),
    ]
    elsewhere = [each.name for each in installed(Group.REFLEXES)]
    return chosen(types, robot, (BASE,), declared, elsewhere=elsewhere)


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Loaded[BaseReflex]:
    """Return the reflexes of other packages."""
    return load(Group.REFLEXES, _checked, taken=SHIPPED, left_out=left_out)


def _checked(name: str, value: object) -> BaseReflex:
    if not isinstance(value, ReflexType):
        raise TypeError(f"expected a ReflexType; found {type(value).__name__}")
    if value.name != name:
        raise TypeError(
            f"the entry point is called {name!r} and its reflex {value.name!r}; expected one name"
        )
    if value.resources != (BASE,):
        raise TypeError(f"reflex {name!r}: expected the resource {BASE!r}; found {value.resources}")
    return value
