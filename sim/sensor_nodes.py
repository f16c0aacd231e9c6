"""The nodes of sensors that measure once in each of their periods, and publish what they measured."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Protocol

from tandem.skills.ports import keys
from tandem.skills.ports.sensors import Cliffs, PoseReading, RangeReading, Ranges, RobotsSeen

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from tandem.sim.pose_sensor import PoseFinder
    from tandem.sim.robot_sensor import RobotFinder
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.message import RobotTime
    from tandem.skills.ports.sensors import CliffSensor, RangeSensor

SLACK: Final = 1e-6
"""Seconds that sums of periods may be off by."""


class _Due:
    """Says when it is time again.

    Args:
        period: robot seconds.
    """

    def __init__(self, period: float) -> None:
        self._period = period
        self._next: RobotTime | None = None

    def __call__(self, now: RobotTime) -> bool:
        if self._next is not None and self._next.is_after(now):
            return False
        self._next = now.plus(self._period - SLACK)
        return True


class Finder(Protocol):
    """Measures a distance with one sensor."""

    @property
    def sensor(self) -> RangeSensor | CliffSensor:
        """What it is."""
        ...

    def measure(self) -> float:
        """Return metres."""
        ...


class RangesNode:
    """Tells the last reading of each range sensor, or of each cliff sensor, whenever one has measured.

    Args:
        finders: one for each sensor.
        tell: publishes the readings.
    """

    rests: Final = True

    def __init__(
        self, finders: Sequence[Finder], tell: Callable[[RobotTime, tuple[RangeReading, ...]], None]
    ) -> None:
        self._tell = tell
        self._finders = [(each, _Due(each.sensor.period)) for each in finders]
        self._last: dict[str, float] = {}
        self.silent: frozenset[str] = frozenset()
        """Sensors that tell nothing."""
        self.stuck: frozenset[str] = frozenset()
        """Sensors that repeat what they told last."""

    def step(self, now: RobotTime) -> None:
        """Measure with those whose time it is; publish if there were any."""
        due = [finder for finder, is_due in self._finders if is_due(now)]
        for finder in due:
            name, measured = finder.sensor.name, finder.measure()  # also when stuck: the noise goes on
            if name not in self.stuck or name not in self._last:
                self._last[name] = measured
        if due:
            told = tuple(
                RangeReading(sensor=name, distance=distance)
                for name, distance in self._last.items()
                if name not in self.silent
            )
            self._tell(now, told)


def ranges_node(bus: Bus, finders: Sequence[Finder]) -> RangesNode:
    """Return the node of the range sensors."""
    return RangesNode(finders, lambda now, told: keys.RANGES.publish(bus, Ranges(stamp=now, readings=told)))


def cliffs_node(bus: Bus, finders: Sequence[Finder]) -> RangesNode:
    """Return the node of the cliff sensors."""
    return RangesNode(finders, lambda now, told: keys.CLIFFS.publish(bus, Cliffs(stamp=now, readings=told)))


class PoseNode:
    """Publishes where a pose sensor has the base.

    Args:
        bus: where readings go.
        finder: measures.
    """

    rests: Final = False

    def __init__(self, bus: Bus, finder: PoseFinder) -> None:
        self._bus, self._finder, self._due = bus, finder, _Due(finder.sensor.period)

    def step(self, now: RobotTime) -> None:
        """Publish when it is time."""
        if self._due(now):
            reading = PoseReading(
                stamp=now, sensor=self._finder.sensor.name, base_in_map=self._finder.measure()
            )
            keys.POSE_READING.publish(self._bus, reading)


class RobotsNode:
    """Publishes which other robots a sensor sees, also when there are none.

    Args:
        bus: where readings go.
        finder: looks.
    """

    rests: Final = False

    def __init__(self, bus: Bus, finder: RobotFinder) -> None:
        self._bus, self._finder, self._due = bus, finder, _Due(finder.sensor.period)

    def step(self, now: RobotTime) -> None:
        """Publish when it is time."""
        if self._due(now):
            seen = RobotsSeen(stamp=now, sensor=self._finder.sensor.name, robots=self._finder.measure())
            keys.ROBOTS_SEEN.publish(self._bus, seen)
