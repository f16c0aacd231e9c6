"""What a robot's file declares, as ``ROBOT``: its name, and how it is put together."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from tandem.sim.model import RobotModel


@dataclass(frozen=True)
class Robot:
    """A robot that the sim can stand in for.

    Args:
        name: what a scenario calls it; the description's name, too.
        compose: puts it together. FileNotFoundError when a package with its URDF or meshes is missing.
    """

    name: str
    compose: Callable[[], RobotModel]
