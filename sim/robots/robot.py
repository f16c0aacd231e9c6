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
        footprint_radius: metres, as the description tells it.
        height: metres, likewise. With the radius it is the room that the robot takes, which is known
            without putting the robot together: that needs numpy and its meshes.
        compose: puts it together. FileNotFoundError when a package with its URDF or meshes is missing.
    """

    name: str
    footprint_radius: float
    height: float
    compose: Callable[[], RobotModel]
