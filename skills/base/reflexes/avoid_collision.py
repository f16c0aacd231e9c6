"""Avoiding collisions (RoCS paper, Table 2 and 6.3): turn from what is too near, and go on a little.

The paper's ``AvoidCollision`` is ``TurnAngle; SetWheelSpeed``. What is ahead counts from so far away that the
base can stop before it, what is beside or behind from nearer. The base turns along what it has met, to the
side of the last time when that is not long ago: so it goes round a corner instead of to and fro before it. A
base that stands without a goal gives way to what comes close.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.base.macros import LATENCY, Macros
from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.base.surround import Echo, Surround
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message, Positive
from tandem.skills.ports.reflex import BASE
from tandem.skills.ports.reflex_setting import Threshold
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.reflexes import Act, ReflexType

NAME: Final = "avoid_collision"
AHEAD: Final = math.radians(60.0)
"""To either side of where the base goes: what is there is in its way."""
CORRIDOR: Final = math.radians(40.0)
"""To either side of a direction that is tried: a base 0.5 m wide and 0.4 m from a thing fills as much."""
SIDE_FOR: Final = 8.0
"""Robot seconds for which the side of the last turn is kept."""
STEP: Final = math.radians(15.0)
"""Radians between two headings that are tried: 24 of a whole circle."""
PATIENCE: Final = 3.0
"""Times as long as the way away takes at its speed, after which something holds the base."""
MOVES: Final = 0.02
"""m/s from which on the base goes somewhere."""


class AvoidCollisionParameters(Message):
    """Bounds in metres between the base's footprint and what is near."""

    ahead: Threshold = Threshold(fires=0.12, releases=0.22)
    """Beyond what the base needs to stop, ahead of it."""
    around: Threshold = Threshold(fires=0.05, releases=0.10)
    """Beside and behind it, and wherever it does not go."""
    standing: Positive = 0.20
    """Around a base that stands without a goal: from here on it gives way, until the other bounds hold."""
    speed: Positive = 0.25
    """m/s: of the way away from what is near."""
    way: Positive = 0.40
    """Metres that it goes before it gives the wheels back."""
    room: Positive = 0.30
    """Metres that must be free in a direction in which it is to go."""


class AvoidCollisionReflex:
    """Fires when something is nearer than its bound."""

    def __init__(self, at: BaseSurroundings, parameters: AvoidCollisionParameters) -> None:
        assert at.surround is not None, "only robots with range sensors have it"
        self._at, self._how = at, parameters
        self._surround: Surround = at.surround
        self._side, self._turned_at = 0.0, -math.inf

    def look(self, *, holds: bool) -> Failure | None:
        """Return what is too near."""
        odometry = self._at.localiser.odometry
        if odometry is None:
            return None
        for echo in self._surround.echoes:
            if self._too_near(echo, odometry.linear, holds=holds):
                return Failure(
                    kind=FailureKind.BASE_BLOCKED,
                    message=f"{echo.sensor} sees something at {max(echo.clear, 0.0):.2f} m",
                    where=f"reflex/{NAME}",
                    evidence={
                        "sensor": echo.sensor,
                        "clear_m": round(echo.clear, 3),
                        "bearing_rad": round(echo.bearing, 3),
                    },
                )
        return None

    def act(self) -> Act:
        """Turn away, and go on a little."""
        macros = self._at.macros(NAME, self._how.speed)
        with macros.named("AvoidCollision"):
            for _ in macros.brake():
                yield macros.doing
            angle = self._away()
            for _ in macros.turn_angle(angle):
                yield macros.doing
            start, until = macros.pose, self._now() + PATIENCE * self._how.way / self._how.speed
            for _ in macros.set_wheel_speed(
                self._how.speed,
                0.0,
                lambda: (
                    macros.distance(start.x, start.y) > self._how.way
                    or self._blocked(macros)
                    or self._now() > until
                ),
            ):
                yield macros.doing
            for _ in macros.brake():
                yield macros.doing

    def close(self) -> None:
        """Nothing to leave: the monitor has the subscriptions."""

    def _too_near(self, echo: Echo, linear: float, *, holds: bool) -> bool:
        how = self._how
        if abs(linear) < MOVES and not self._at.board.holder and not holds:
            return echo.clear < how.standing
        ahead = abs(wrap(echo.bearing - (0.0 if linear >= 0.0 else math.pi))) < AHEAD
        if not ahead:
            return how.around.below(echo.clear, holds=holds)
        stops = linear * linear / (2.0 * self._at.description.driven.acceleration) + abs(linear) * LATENCY
        return how.ahead.below(echo.clear - stops, holds=holds)

    def _now(self) -> float:
        return robot_seconds(self._at.clocks)

    def _blocked(self, macros: Macros) -> bool:
        return any(
            abs(echo.bearing) < AHEAD and self._too_near(echo, macros.wheels.linear, holds=False)
            for echo in self._surround.echoes
        )

    def _away(self) -> float:
        """Return the turn (rad) to a direction that is free, the nearest one along what was met."""
        echoes, now = self._surround.echoes, self._now()
        if not echoes:
            return 0.0
        met = echoes[0].bearing
        recent = now - self._turned_at < SIDE_FOR
        side = self._side if recent and self._side else (-1.0 if met > 0.0 else 1.0)
        count = round(math.pi / STEP)
        # From along what was met, on the side that is kept, on to straight away from it, then the other side.
        along = [wrap(met + side * (math.pi / 2.0 + STEP * k)) for k in range(count // 2 + 1)]
        back = [wrap(met - side * (math.pi - STEP * k)) for k in range(1, count // 2 + 1)]
        tried = [*along, *back]
        free = [each for each in tried if self._surround.room(each, CORRIDOR) > self._how.room]
        turn = free[0] if free else max(tried, key=lambda each: self._surround.room(each, CORRIDOR))
        self._side, self._turned_at = side, now
        return turn


def _needs(robot: RobotDescription) -> str:
    if not robot.range_sensors:
        return "a range sensor"
    return "" if robot.pose_sensors and not robot.lasers else "a pose sensor, and no laser,"


REFLEX: Final = ReflexType(
    name=NAME,
    about="turns the base away from what range sensors see too near, and goes on a little",
    protects="people and furniture from a base that comes too near",
    resources=(BASE,),
    rank=50,
    parameters=AvoidCollisionParameters,
    needs=_needs,
    make=AvoidCollisionReflex,
)
