"""Finds the robots: the files beside this one, and those that an installed package declares.

A package declares one under the entry points ``tandem.robots``; its name there is what a scenario names.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

from pydantic import ValidationError

from tandem.sim import robots
from tandem.sim.model import RobotModel
from tandem.sim.robots.model_check import check_model
from tandem.sim.robots.robot import Robot
from tandem.skills.ports.plugins import UNTRIED, Group, Loaded, installed, load
from tandem.skills.ports.plugins import in_words as raised_in_words
from tandem.skills.ports.problems import in_words, problems_of
from tandem.skills.ports.sources import DocumentError


class RobotError(DocumentError):
    """A robot that can't be used. The text names it, and what was expected."""


@cache
def shipped() -> Mapping[str, Robot]:
    """Return the robots whose files are here, by name."""
    found: dict[str, Robot] = {}
    for module in sorted(pkgutil.iter_modules(robots.__path__), key=lambda each: each.name):
        made = getattr(importlib.import_module(f"{robots.__name__}.{module.name}"), "ROBOT", None)
        if isinstance(made, Robot):
            found[made.name] = made
    return MappingProxyType(found)


def names() -> tuple[str, ...]:
    """Return the names of all robots there are, those of plug-ins last."""
    return tuple(dict.fromkeys((*shipped(), *(each.name for each in installed(Group.ROBOTS)))))


@cache
def robot_model(name: str) -> RobotModel:
    """Put a robot together.

    Raises:
        RobotError: as ``robot_named``; when it can't be put together (a package with its URDF or meshes is
            not installed, a joint has no such name), and when its description does not take the room that
            it declares.
        DescriptionError: when its parts don't fit each other.
    """
    robot = robot_named(name)
    made = _composed(robot)
    if made.description.name != name:
        raise RobotError(
            f"robot {name!r}: expected a description of that name; found {made.description.name!r}"
        )
    told = (made.description.footprint_radius, made.description.height)
    if told != (robot.footprint_radius, robot.height):
        raise RobotError(
            f"robot {name!r}: expected a description with a footprint_radius of {robot.footprint_radius:g} m "
            f"and a height of {robot.height:g} m, as it declares; found {told[0]:g} and {told[1]:g} m"
        )
    check_model(made)
    return made


def _composed(robot: Robot) -> RobotModel:
    """Put a robot together; whatever its file raises is told in words, with the place in it."""
    try:
        made: object = robot.compose()
    except ValidationError as error:
        raise RobotError(f"robot {robot.name!r}: {in_words(problems_of(error))}") from error
    except Exception as error:
        raise RobotError(f"robot {robot.name!r} can't be put together: {raised_in_words(error)}") from error
    if not isinstance(made, RobotModel):
        raise RobotError(f"robot {robot.name!r}: expected compose to return a RobotModel; found {made!r}")
    return made


def robot_named(name: str) -> Robot:
    """Return the robot of a name.

    Raises:
        RobotError: when there is none, naming those there are, or when its package has a mistake.
    """
    shipped_here = shipped()
    if name in shipped_here:
        return shipped_here[name]
    loaded = plugged()
    if name in loaded.found:
        return loaded.found[name]
    why = "".join(f"; {each}" for each in loaded.broken if each.plugin.name == name)
    raise RobotError(f"no robot {name!r}; expected one of {', '.join((*shipped_here, *loaded.found))}{why}")


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Loaded[Robot]:
    """Return the robots of other packages.

    Args:
        left_out: plug-ins that are known not to load (``tandem.skills.ports.plugins.load``).
    """
    return load(Group.ROBOTS, _checked, taken=shipped(), left_out=left_out)


def _checked(name: str, value: object) -> Robot:
    if not isinstance(value, Robot):
        raise TypeError(f"expected a Robot; found {type(value).__name__}")
    if value.name != name:
        raise TypeError(f"the entry point is called {name!r} and its robot {value.name!r}; expected one name")
    return value
