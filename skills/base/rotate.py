"""ROTATE: turn on the spot."""

from __future__ import annotations

from typing import Final

from tandem.skills.base.guard import Guard
from tandem.skills.base.people.caution import Caution
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.wheels_run import Ride
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.base.with_wheels import with_wheels
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.actions.base import ROTATE, RotateFeedback, RotateGoal, RotateResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.robot_description import Drive
from tandem.skills.ports.skill import ActionType, Outcome, Run, canceled, failed, succeeded

MOST_CORRECTIONS: Final = 2
"""Turns after the first that may make up for what it has missed."""
SETTLE: Final = 0.15
"""Robot seconds at rest, at the most, before the angle is judged: by then a scan has been taken there."""


class Rotate:
    """The skill of turning.

    Args:
        bus: where the wheels listen.
        clocks: robot time.
        drive: what the wheels can do.
        localiser: where the base is.
        guard: whether it may move.
        board: who has the wheels.
        caution: what is heeded of people, by robots that track them.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        drive: Drive,
        localiser: Whereabouts,
        *,
        guard: Guard,
        board: BaseStatusBoard,
        caution: Caution | None = None,
    ) -> None:
        self._caution = caution
        self._clocks, self._localiser, self._guard, self._board = clocks, localiser, guard, board
        self._wheels = Wheels(bus, clocks, drive, lambda: board.pipeline.normal(ROTATE.name))

    @property
    def action(self) -> ActionType[RotateGoal, RotateFeedback, RotateResult]:
        """The contract."""
        return ROTATE

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.02

    def check(self, goal: RotateGoal) -> Failure | None:  # noqa: ARG002
        """Refuse while another skill has the wheels or the base may not move."""
        busy = self._board.pipeline.busy(ROTATE.name)
        if busy is not None:
            return busy
        return self._guard.refusal(ROTATE.name)

    def run(self, goal: RotateGoal, goal_id: str) -> Run[RotateFeedback, RotateResult]:  # noqa: ARG002
        """Turn, and correct what is left."""
        return with_wheels(self._turn(goal), self._board, self._wheels, ROTATE.name)

    def _turn(self, goal: RotateGoal) -> Run[RotateFeedback, RotateResult]:
        turned = 0.0

        def feedback() -> RotateFeedback:
            return RotateFeedback(remaining=goal.angle - turned - ride.turned)

        ride = Ride(
            self._clocks,
            self._localiser,
            self._wheels,
            feedback=feedback,
            where=ROTATE.name,
            caution=self._caution,
        )
        for _ in range(MOST_CORRECTIONS + 1):
            before = ride.pose.yaw
            going_on = (yield from ride.turn(goal.angle - turned)) and (yield from ride.settle_seen(SETTLE))
            # Whole turns as counted on the way, the rest as the settled pose tells.
            turned += ride.turned + wrap(ride.pose.yaw - before - ride.turned)
            ride.turned = 0.0
            if not going_on:
                yield from ride.rest()
                return self._ended(ride)
            if abs(goal.angle - turned) <= goal.tolerance:
                return succeeded(RotateResult(turned=turned))
        ride.fail(
            FailureKind.BASE_OFF_GOAL,
            "the base came to rest outside the tolerance",
            error_rad=goal.angle - turned,
            tolerance_rad=goal.tolerance,
        )
        return self._ended(ride)

    @staticmethod
    def _ended(ride: Ride[RotateFeedback]) -> Outcome[RotateResult]:
        if ride.canceled or ride.failure is None:
            return canceled()
        return failed(ride.failure)
