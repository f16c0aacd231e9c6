"""GO: straight to a place in the map, round robots that tell where they are; the rest is the reflexes'."""

from __future__ import annotations

from typing import Final

from tandem.skills.base.company import Company
from tandem.skills.base.guard import Guard
from tandem.skills.base.macros import Macros, Steps
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.surround import Surround
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.base.with_wheels import with_wheels
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import GO, GoFeedback, GoGoal, GoResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.robot_description import Drive
from tandem.skills.ports.skill import ActionType, Command, Run, canceled, failed, succeeded

SPEED: Final = 0.40
"""m/s: a base that brakes with 0.6 m/s2 stands after 0.17 m."""
NEARER: Final = 0.6
"""Share of the tolerance within which the way ends: the rest is for the sensor's noise."""
STUCK_AFTER: Final = 6.0
"""Robot seconds without getting nearer, or turning, after which something holds the base."""
PROGRESS: Final = 0.02
"""Metres, or radians, that are getting nearer."""


class Go:
    """The skill of going to a place.

    Args:
        bus: where the wheels listen.
        clocks: robot time.
        drive: what the wheels can do.
        monitor: where the base is.
        guard: whether it may move.
        board: who has the wheels.
        surround: what the base sees; what it can't see makes it slow.
        company: the other robots of the site.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        drive: Drive,
        monitor: Whereabouts,
        *,
        guard: Guard,
        board: BaseStatusBoard,
        surround: Surround,
        company: Company,
    ) -> None:
        self._clocks, self._monitor, self._guard, self._board = clocks, monitor, guard, board
        self._surround, self._company = surround, company
        self._wheels = Wheels(bus, clocks, drive, lambda: board.pipeline.normal(GO.name))

    @property
    def action(self) -> ActionType[GoGoal, GoFeedback, GoResult]:
        """The contract."""
        return GO

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.02

    def check(self, goal: GoGoal) -> Failure | None:  # noqa: ARG002
        """Refuse while another skill, or a reflex, has the wheels, or the base may not move."""
        return self._board.pipeline.busy(GO.name) or self._guard.refusal(GO.name)

    def run(self, goal: GoGoal, goal_id: str) -> Run[GoFeedback, GoResult]:  # noqa: ARG002
        """Turn, go, turn to the heading."""
        return with_wheels(self._go(goal), self._board, self._wheels, GO.name)

    def _speed(self) -> float:
        return self._surround.speed(SPEED)

    def _go(self, goal: GoGoal) -> Run[GoFeedback, GoResult]:
        self._wheels.begin(self._monitor.odometry)
        self._company.begin()
        macros = Macros(self._clocks, self._monitor, self._wheels, self._speed)
        steps = self._steps(goal, macros)
        nearest, since = float("inf"), robot_seconds(self._clocks)
        stopping, paused = False, False
        while _goes_on(steps):
            left = macros.distance(goal.x, goal.y) + abs(self._off(goal, macros))
            now = robot_seconds(self._clocks)
            if left < nearest - PROGRESS or stopping or paused or self._company.why:
                nearest, since = min(left, nearest), now
            elif now - since > STUCK_AFTER:
                return failed(self._stuck(goal, macros))
            command = yield self._feedback(goal, macros)
            self._board.pipeline.doing = self._doing(macros)
            if command is Command.CANCEL and not stopping:
                stopping = True
                steps.close()
                steps = macros.brake()
            elif command is Command.PAUSE and not stopping:
                paused = True
                steps.close()
                steps = self._stand(macros)
            elif command is Command.RESUME and paused:
                paused = False
                steps.close()
                steps = self._steps(goal, macros)
        if stopping:
            return canceled()
        here = macros.pose
        return succeeded(GoResult(base_in_map=here, position_error=macros.distance(goal.x, goal.y)))

    def _steps(self, goal: GoGoal, macros: Macros) -> Steps:
        yield from macros.go_to(goal.x, goal.y, NEARER * goal.position_tolerance, self._company.advice)
        self._company.begin()  # it is there: nobody is the reason for what follows
        if goal.yaw is not None and abs(wrap(goal.yaw - macros.pose.yaw)) > NEARER * goal.yaw_tolerance:
            yield from macros.turn_angle(wrap(goal.yaw - macros.pose.yaw))

    @staticmethod
    def _stand(macros: Macros) -> Steps:
        yield from macros.set_wheel_speed(0.0, 0.0, lambda: False)

    @staticmethod
    def _off(goal: GoGoal, macros: Macros) -> float:
        """Return how far the heading is off where the base should look now (rad)."""
        if macros.distance(goal.x, goal.y) > goal.position_tolerance:
            return macros.bearing(goal.x, goal.y)
        return 0.0 if goal.yaw is None else wrap(goal.yaw - macros.pose.yaw)

    def _doing(self, macros: Macros) -> tuple[str, ...]:
        """Return what is at work: the macro-actions, and what of it is for another robot."""
        return (*macros.doing[:1], *((self._company.why,) if self._company.why else ()), *macros.doing[1:])

    def _feedback(self, goal: GoGoal, macros: Macros) -> GoFeedback:
        return GoFeedback(
            base_in_map=macros.pose,
            remaining=macros.distance(goal.x, goal.y),
            doing=self._doing(macros),
        )

    @staticmethod
    def _stuck(goal: GoGoal, macros: Macros) -> Failure:
        return Failure(
            kind=FailureKind.BASE_BLOCKED,
            message="the base does not get nearer",
            where=GO.name,
            evidence={"remaining_m": round(macros.distance(goal.x, goal.y), 3), "for_s": STUCK_AFTER},
        )


def _goes_on(steps: Steps) -> bool:
    """Do the next cycle; False when there is none."""
    try:
        next(steps)
    except StopIteration:
        return False
    return True
