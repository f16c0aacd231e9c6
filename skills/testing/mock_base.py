"""Wheels of a mocked robot: they go straight to places, follow, and lose the base to a reflex."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Protocol

from tandem.skills.ports.actions.base import FollowGoal, FollowResult, GoGoal, GoResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex import BASE, PipelineState, pipeline_state
from tandem.skills.ports.skill import Outcome, failed, succeeded

BLOCKED: Final = Failure(kind=FailureKind.BASE_BLOCKED, message="something is 0.25 m ahead")
FOR_EVER: Final = 10**9
"""Goals from which a reflex takes the base: more than any task sends."""


class _Moved(Protocol):
    """The robot whose base it is."""

    base: FloorPose
    bus: Bus

    @property
    def now(self) -> RobotTime:
        """Robot time."""
        ...

    def tell(self) -> None:
        """Publish all beliefs."""
        ...


@dataclass
class MockReflex:
    """A reflex that takes the base from goals.

    Args:
        times: from how many goals.
        name: its name.
        holds: robot seconds for which it has the base then.
        gains: metres by which the robot gets nearer with each goal, until the reflex takes the base.
        why: what it sees.
        tells: whether the pipeline tells of it.
    """

    times: int = 0
    name: str = "avoid_collision"
    holds: float = 0.5
    gains: float = 0.0
    why: Failure = BLOCKED
    tells: bool = True


class MockBase:
    """What ``MockRobot`` has of it as ``wheels``.

    Args:
        robot: whose base it moves.
    """

    def __init__(self, robot: _Moved) -> None:
        self.reflex = MockReflex()
        """Takes the base while it has times left."""
        self.seen = 1.0
        """Share of the seconds for which the robot that is followed is seen."""
        self._robot = robot
        self._taken: RobotTime | None = None
        self._told: RobotTime | None = None

    def go(self, goal: GoGoal) -> Outcome[GoResult]:
        """Be there, unless the reflex takes the base before."""
        ended = self._ended()
        if ended is not None:
            return failed(ended)
        at = self._robot.base
        yaw = math.atan2(goal.y - at.y, goal.x - at.x) if goal.yaw is None else goal.yaw
        if self.reflex.times:
            away = math.hypot(goal.x - at.x, goal.y - at.y)
            share = min(1.0, self.reflex.gains / away) if away else 0.0
            self._put(at.x + share * (goal.x - at.x), at.y + share * (goal.y - at.y), yaw)
            return failed(self._override())
        self._put(goal.x, goal.y, yaw)
        return succeeded(GoResult(base_in_map=self._robot.base, position_error=0.0))

    def follow(self, goal: FollowGoal) -> Outcome[FollowResult]:
        """Have followed for the seconds asked for, unless the reflex takes the base."""
        ended = self._ended()
        if ended is not None:
            return failed(ended)
        if self.reflex.times:
            return failed(self._override())
        return succeeded(FollowResult(seconds=goal.seconds, seen=self.seen * goal.seconds))

    def shove(self, x: float, y: float) -> None:
        """Have the reflex take the base and give way by so many metres of the map."""
        at = self._robot.base
        self._take()
        self._put(at.x + x, at.y + y, at.yaw)
        self._robot.tell()

    def step(self) -> None:
        """Give the base back when the reflex is done, and tell once a second."""
        if self._taken is not None and self._since(self._taken) >= self.reflex.holds:
            self._taken = None
            self._tell()
        elif self._told is None or self._since(self._told) >= 1.0:
            self._tell()

    def _ended(self) -> Failure | None:
        """Return why no goal can begin while the reflex has the base."""
        if self._taken is None:
            return None
        return self._failure(FailureKind.BUSY, "has")

    def _override(self) -> Failure:
        self.reflex.times -= 1
        self._take()
        return self._failure(FailureKind.OVERRIDDEN, "took")

    def _failure(self, kind: FailureKind, what: str) -> Failure:
        reflex = self.reflex
        return Failure(
            kind=kind,
            message=f"reflex {reflex.name} {what} the base: {reflex.why.message}",
            evidence={"reflex": reflex.name},
            causes=(reflex.why,),
        )

    def _take(self) -> None:
        self._taken = self._robot.now
        self._tell()

    def _since(self, stamp: RobotTime) -> float:
        return self._robot.now.since(stamp) or 0.0

    def _put(self, x: float, y: float, yaw: float) -> None:
        self._robot.base = FloorPose(x=x, y=y, yaw=yaw)

    def _tell(self) -> None:
        if not self.reflex.tells:
            return
        has, self._told = self._taken is not None, self._robot.now
        state = PipelineState(
            stamp=self._robot.now,
            resource=BASE,
            reflex=self.reflex.name if has else "",
            why=self.reflex.why if has else None,
        )
        pipeline_state(BASE).publish(self._robot.bus, state)
