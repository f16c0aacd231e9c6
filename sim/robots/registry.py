"""Finds the robots: the files beside this one, and those that an installed package declares.

A package declares one under the entry points ``tandem.robots``; its name there is what a scenario names.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Mapping
from functools import cache
from importlib.metadata import entry_points
from types import MappingProxyType
from typing import Final

from tandem.sim import robots
from tandem.sim.model import RobotModel
from tandem.sim.robots.robot import Robot
from tandem.skills.ports.sources import DocumentError

GROUP: Final = "tandem.robots"


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
    return tuple(dict.fromkeys((*shipped(), *sorted(entry_points(group=GROUP).names))))


@cache
def robot_model(name: str) -> RobotModel:
    """Put a robot together.

    Raises:
        RobotError: when there is none of that name, naming those there are, or when its
            package has a mistake.
        FileNotFoundError: when a package with its URDF or meshes is not installed.
    """
    return (shipped().get(name) or _declared(name)).compose()


def _declared(name: str) -> Robot:
    for entry in entry_points(group=GROUP, name=name):
        try:
            loaded = entry.load()
        except Exception as error:  # a plug-in may raise anything
            raise RobotError(f"robot {name!r}: loading {entry.value} raised {error!r}") from error
        if isinstance(loaded, Robot) and loaded.name == name:
            return loaded
        raise RobotError(f"robot {name!r}: expected a Robot of this name at {entry.value}, found {loaded!r}")
    raise RobotError(f"no robot {name!r}; expected one of {', '.join(names())}")
