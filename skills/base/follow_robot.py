"""FOLLOW: keep a distance to another robot, as the robot sensor sees it."""

from __future__ import annotations

import math
from collections.abc import Generator
from dataclasses import dataclass
from typing import Final

from tandem.skills.base.floor import compose
from tandem.skills.base.guard import Guard
from tandem.skills.base.macros import Macros
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.surround import Surround
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.base.with_wheels import with_wheels
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import FOLLOW, FollowFeedback, FollowGoal, FollowResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.hardware import Drive
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import ActionType, Command, Run, canceled, succeeded

SPEED: Final = 0.60
"""m/s: faster than what it follows, so that it catches up."""
GAIN: Final = 1.2
"""m/s for each metre off the distance."""
TURN_GAIN: Final = 2.0
"""rad/s for each radian off the other robot."""
FACE: Final = 0.9
"""Radians off the other robot from which on the base turns before it drives."""
SEARCH: Final = 1.0
"""rad/s at which it looks for a robot that it does not see: first where it was, then all around."""
LOST_AFTER: Final = 0.6
"""Robot seconds without a sight after which the base stands and looks around."""


@dataclass
class _Sight:
    """What was last seen of the other robot, in the map."""

    x: float
    y: float
    at: float


class Follow:
    """The skill of following.

    Args:
        bus: where the wheels listen.
        clocks: robot time.
        drive: what the wheels can do.
        monitor: where the base is.
        surround: sees other robots.
        guard: whether it may move.
        board: who has the wheels.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        drive: Drive,
        monitor: Whereabouts,
        surround: Surround,
        *,
        guard: Guard,
        board: BaseStatusBoard,
    ) -> None:
        self._clocks, self._monitor, self._surround = clocks, monitor, surround
        self._guard, self._board = guard, board
        self._wheels = Wheels(bus, clocks, drive, lambda: board.pipeline.normal(FOLLOW.name))
        self._last: dict[str, _Sight] = {}
        """Where each robot was seen last: a goal that follows one that was overridden looks there first."""

    @property
    def action(self) -> ActionType[FollowGoal, FollowFeedback, FollowResult]:
        """The contract."""
        return FOLLOW

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.02

    def check(self, goal: FollowGoal) -> Failure | None:  # noqa: ARG002
        """Refuse while another skill, or a reflex, has the wheels, or the base may not move."""
        return self._board.pipeline.busy(FOLLOW.name) or self._guard.refusal(FOLLOW.name)

    def run(self, goal: FollowGoal, goal_id: str) -> Run[FollowFeedback, FollowResult]:  # noqa: ARG002
        """Follow until the time is over."""
        return with_wheels(self._follow(goal), self._board, self._wheels, FOLLOW.name)

    def _follow(self, goal: FollowGoal) -> Run[FollowFeedback, FollowResult]:
        self._wheels.begin(self._monitor.odometry)
        macros = Macros(self._clocks, self._monitor, self._wheels, self._speed)
        begun = before = robot_seconds(self._clocks)
        lasts = goal.seconds
        seen, stands, sight, side = 0.0, False, self._last.get(goal.robot), 0.0
        while (now := robot_seconds(self._clocks)) - begun < lasts:
            found = self._look(goal.robot, macros, now)
            if found is not None:
                sight = self._last[goal.robot] = found
            fresh = sight is not None and now - sight.at < LOST_AFTER
            seen += now - before if fresh else 0.0
            before = now
            if fresh:
                side = 0.0
            elif not side:  # to the side where it was last, and on all around
                side = -1.0 if sight is not None and macros.bearing(sight.x, sight.y) < 0.0 else 1.0
            linear, angular, doing = self._speeds(goal, macros, sight, side)
            if stands:
                linear, angular = 0.0, 0.0
            self._wheels.send(linear, angular)
            self._board.pipeline.doing = doing
            distance = None if sight is None or not fresh else macros.distance(sight.x, sight.y)
            command = yield FollowFeedback(base_in_map=macros.pose, distance=distance, doing=doing)
            if command is Command.CANCEL:
                yield from self._rest(macros)
                return canceled()
            stands = command is Command.PAUSE or (stands and command is not Command.RESUME)
        yield from self._rest(macros)
        return succeeded(FollowResult(seconds=now - begun, seen=min(seen, now - begun)))

    def _speed(self) -> float:
        return self._surround.speed(SPEED)

    def _back(self) -> float:
        """Return how fast (m/s) the base may back up: not at all where no range sensor looks."""
        return self._wheels.drive.backward / 2.0 if self._surround.looks_back else 0.0

    def _look(self, robot: str, macros: Macros, now: float) -> _Sight | None:
        for each in self._surround.robots:
            if each.name == robot:
                there = compose(macros.pose, FloorPose(x=each.x, y=each.y, yaw=0.0))
                return _Sight(there.x, there.y, now)
        return None

    def _speeds(
        self, goal: FollowGoal, macros: Macros, sight: _Sight | None, side: float
    ) -> tuple[float, float, tuple[str, ...]]:
        """Return the speeds (m/s, rad/s) and what they are for; it searches to ``side``, unless that is 0."""
        if sight is None or side:
            return 0.0, side * SEARCH, ("Follow", "TurnTo", "SetWheelSpeed")
        bearing = wrap(macros.bearing(sight.x, sight.y))
        off = macros.distance(sight.x, sight.y) - goal.distance
        drive = self._wheels.drive
        angular = min(max(TURN_GAIN * bearing, -drive.turn), drive.turn)
        if abs(bearing) > FACE:
            return 0.0, angular, ("Follow", "TurnTo", "SetWheelSpeed")
        linear = min(max(GAIN * off, -self._back()), self._speed()) * math.cos(bearing)
        return linear, angular, ("Follow", "SetWheelSpeed")

    @staticmethod
    def _rest(macros: Macros) -> Generator[FollowFeedback, Command, None]:
        for _ in macros.brake():
            yield FollowFeedback(base_in_map=macros.pose, distance=None, doing=macros.doing)
