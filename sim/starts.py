"""The robots of a scenario: what each is called, where it starts, and who drives it."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import AfterValidator

from tandem.sim.things import Name
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose

ROBOT: Final = "tiago_dual"
"""The robot of a scenario that names none."""
ALONE: Final = "robot"
"""What the only robot of a scenario is called in the truth; its keys are those of the command line."""
MOST_ROBOTS: Final = 8
"""Robots in one world: the physics tells them apart by a bit each (``tandem.sim.physics.robot_group``)."""
SHARED: Final = "world"
"""The part of a site's keys that belongs to no robot."""


def _not_shared(name: str) -> str:
    if name == SHARED:
        raise ValueError(f"expected another name than {SHARED}: its keys belong to all robots of a site")
    return name


class RobotStart(Message):
    """One robot of a scenario."""

    name: Annotated[Name, AfterValidator(_not_shared)]
    """The second part of its keys, ``<site>/<name>/...``."""
    robot: Name = ROBOT
    """A file of ``sim/robots/``, or an entry point under ``tandem.robots``."""
    start: FloorPose
    drives: Literal["executive", "wander"] = "executive"
    """An executive of its own, or a script that drives about at random and gives way (``sim.wanderer``)."""
