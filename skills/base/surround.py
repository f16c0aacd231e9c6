"""What range sensors and robot sensors see around the base, and which of them can't be trusted."""

from __future__ import annotations

import logging
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Final

from tandem.skills.base.cliffs import Cliffs
from tandem.skills.base.ranger import SLOWLY, Ranger
from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import to_floor, wrap
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.keys import RANGES, ROBOTS_SEEN, Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import RobotsSeen, SeenRobot

log = logging.getLogger(__name__)

AHEAD: Final = math.radians(60.0)
"""To either side of the heading."""
OTHER_RADIUS: Final = 0.30
"""Metres: what is taken for the radius of a robot of which only the middle is told."""


@dataclass(frozen=True)
class Echo:
    """Something near: metres between it and the footprint, and where, in radians left of the heading."""

    clear: float
    bearing: float
    sensor: str


class Surround:
    """Hears the sensors that see what is near; a ``Node``.

    Args:
        bus: where they tell.
        clocks: robot time.
        description: the sensors, their frames and the footprint.
        moving: says whether the base moves.
        cliffs: what its cliff sensors tell, if it has any.
    """

    name: Final = "base/surround"

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        description: RobotDescription,
        moving: Callable[[], bool],
        cliffs: Cliffs | None = None,
    ) -> None:
        self._cliffs = cliffs
        self._clocks, self._radius, self._moving = clocks, description.footprint_radius, moving
        self._resting = description.resting_period or 0.0
        self._deaf = tuple(each.name for each in description.range_sensors)
        self._ranges = Latest(bus, RANGES)
        self._seen_in = Latest(bus, ROBOTS_SEEN) if description.robot_sensors else None
        self._seen: dict[str, RobotsSeen] = {}
        """By sensor: they share the topic."""
        self._rangers = [Ranger(each, _mount(description, each.frame)) for each in description.range_sensors]

    def step(self) -> bool:
        """Hear what has come; nothing is published."""
        told = self._ranges.take()
        for ranges in told:
            for ranger in self._rangers:
                said = ranges.of(ranger.sensor.name)
                ranger.hear(said, ranges.stamp, moving=self._moving())
        for seen in () if self._seen_in is None else self._seen_in.take():
            self._seen[seen.sensor] = seen
        self._deaf, before = self._find_deaf(), self._deaf
        if self._deaf != before and self._deaf:
            log.warning("range sensors that are silent or stuck: %s", ", ".join(self._deaf))
        elif self._deaf != before:
            log.info("all range sensors tell what they see")
        return False

    def close(self) -> None:
        """End the subscriptions."""
        self._ranges.close()
        if self._seen_in is not None:
            self._seen_in.close()

    @property
    def deaf(self) -> tuple[str, ...]:
        """The range sensors that are silent, or stuck at one distance."""
        return self._deaf

    def speed(self, wished: float) -> float:
        """Return how fast (m/s) the base may go ahead: slowly where a sensor that looks there is deaf."""
        ahead = {each.sensor.name for each in self._rangers if abs(each.in_base.yaw) < AHEAD}
        slow = min(wished, SLOWLY) if ahead & {*self._deaf} else wished
        return slow if self._cliffs is None else self._cliffs.speed(slow)

    def _find_deaf(self) -> tuple[str, ...]:
        now, resting = self._clocks.robot(), 0.0 if self._moving() else self._resting
        return tuple(each.sensor.name for each in self._rangers if each.is_deaf(now, resting))

    @property
    def robots(self) -> tuple[SeenRobot, ...]:
        """The other robots that are in view now, in the base."""
        now = self._clocks.robot()
        found: dict[str, SeenRobot] = {}
        for seen in self._seen.values():
            age = None if now is None else now.since(seen.stamp)
            if age is not None and age < 0.5:  # noqa: PLR2004 - as of now
                found |= {each.name: each for each in seen.robots}
        return tuple(found.values())

    @property
    def echoes(self) -> tuple[Echo, ...]:
        """What is near, the nearest first."""
        return tuple(sorted((*self._of_ranges(), *self._of_robots()), key=lambda each: each.clear))

    def room(self, bearing: float, width: float) -> float:
        """Return the metres to the nearest thing within ``width`` radians to either side of a direction.

        Where no sensor looks nothing is known, and the room is infinite.
        """
        return min(
            (each.clear for each in self.echoes if abs(wrap(each.bearing - bearing)) <= width),
            default=math.inf,
        )

    def _of_ranges(self) -> Iterable[Echo]:
        deaf = self._deaf
        for each in self._rangers:
            if each.said is None or each.sensor.name in deaf or each.said >= each.sensor.range_max:
                continue
            at = each.in_base
            x, y = at.x + each.said * math.cos(at.yaw), at.y + each.said * math.sin(at.yaw)
            yield Echo(math.hypot(x, y) - self._radius, math.atan2(y, x), each.sensor.name)

    def _of_robots(self) -> Iterable[Echo]:
        for each in self.robots:
            clear = math.hypot(each.x, each.y) - self._radius - OTHER_RADIUS
            yield Echo(clear, math.atan2(each.y, each.x), f"robot {each.name}")


def _mount(description: RobotDescription, frame: str) -> FloorPose:
    return to_floor(Chain.from_urdf(description.urdf, description.base_frame, frame).pose({}))
