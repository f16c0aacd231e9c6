"""FOLLOW: keep a distance to another robot, as a sensor sees it, or as it tells of itself."""

from __future__ import annotations

import math
from collections.abc import Generator
from typing import Final

from tandem.skills.base.guard import Guard
from tandem.skills.base.macros import LATENCY, Macros
from tandem.skills.base.sights import Sight, Sights
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.surround import Surround
from tandem.skills.base.way_back import WayBack
from tandem.skills.base.wheels import Wheels, stopping_speed
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.base.with_wheels import with_wheels
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import FOLLOW, FollowFeedback, FollowGoal, FollowResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.robot_description import Drive
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
BEHIND: Final = math.radians(40.0)
"""To either side of straight back: what range sensors see there is in the way of a base that backs up."""
LOST_AFTER: Final = 0.6
"""Robot seconds without a sight after which the base stands and looks around."""


class Follow:
    """The skill of following.

    Args:
        bus: where the wheels listen.
        clocks: robot time.
        drive: what the wheels can do.
        monitor: where the base is.
        surround: sees what is near.
        sights: know where other robots are; a goal that follows one that was overridden looks there first.
        way_back: knows what is behind the base, as far as the site's map tells.
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
        sights: Sights,
        way_back: WayBack,
        guard: Guard,
        board: BaseStatusBoard,
    ) -> None:
        self._clocks, self._monitor, self._surround = clocks, monitor, surround
        self._sights, self._way_back = sights, way_back
        self._guard, self._board = guard, board
        self._wheels = Wheels(bus, clocks, drive, lambda: board.pipeline.normal(FOLLOW.name))

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
        seen, stands, side = 0.0, False, 0.0
        while (now := robot_seconds(self._clocks)) - begun < lasts:
            self._sights.refresh(goal.source)
            sight = self._sights.last.get(goal.robot)
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

    def _back(self, macros: Macros) -> float:
        """Return how fast (m/s) the base may back up: so that it stops in what is free behind it."""
        known = self._way_back.free(macros.pose, self._sights.last, robot_seconds(self._clocks))
        free = min(known, self._surround.room(math.pi, BEHIND))
        return min(
            self._wheels.drive.backward, stopping_speed(free, self._wheels.drive.acceleration, LATENCY)
        )

    def _speeds(
        self, goal: FollowGoal, macros: Macros, sight: Sight | None, side: float
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
        linear = min(max(GAIN * off, -self._back(macros)), self._speed()) * math.cos(bearing)
        return linear, angular, ("Follow", "SetWheelSpeed")

    @staticmethod
    def _rest(macros: Macros) -> Generator[FollowFeedback, Command, None]:
        for _ in macros.brake():
            yield FollowFeedback(base_in_map=macros.pose, distance=None, doing=macros.doing)
