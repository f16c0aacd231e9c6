"""DRIVE: to the first of several poses that has a free way, around what is mapped and what is not."""

from __future__ import annotations

from tandem.skills.base.journey import Journey
from tandem.skills.base.journey_context import JourneyContext, Progress
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.wheels_run import Ride
from tandem.skills.base.with_wheels import with_wheels
from tandem.skills.ports.actions.base import DRIVE, DriveFeedback, DriveGoal, DriveResult
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.skill import ActionType, Run


class Drive:
    """The skill of getting somewhere.

    Args:
        bus: where the wheels listen.
        clocks: robot time.
        course: what is known of the floor, where the base is, and whether it may move.
        board: who has the wheels.
    """

    def __init__(self, bus: Bus, clocks: Clocks, course: JourneyContext, board: BaseStatusBoard) -> None:
        self._clocks, self.course, self._guard, self._board = clocks, course, course.guard, board
        self._wheels = Wheels(bus, clocks, course.drive, lambda: board.pipeline.normal(DRIVE.name))

    @property
    def action(self) -> ActionType[DriveGoal, DriveFeedback, DriveResult]:
        """The contract."""
        return DRIVE

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.02

    def check(self, goal: DriveGoal) -> Failure | None:  # noqa: ARG002
        """Refuse while another skill has the wheels or the base may not move."""
        busy = self._board.pipeline.busy(DRIVE.name)
        if busy is not None:
            return busy
        return self._guard.refusal(DRIVE.name)

    def run(self, goal: DriveGoal, goal_id: str) -> Run[DriveFeedback, DriveResult]:  # noqa: ARG002
        """Plan, drive, correct."""
        return with_wheels(self._drive(goal), self._board, self._wheels, DRIVE.name, goal.serves_item)

    def _drive(self, goal: DriveGoal) -> Run[DriveFeedback, DriveResult]:
        progress = Progress()
        return (yield from Journey(self.course, self._ride(progress), progress, goal).run())

    def _ride(self, progress: Progress) -> Ride[DriveFeedback]:
        def feedback() -> DriveFeedback:
            share = 1.0 - progress.remaining / progress.total if progress.total > 0.0 else 0.0
            return DriveFeedback(
                base_in_map=ride.pose,
                remaining=max(progress.remaining, 0.0),
                progress=min(max(share, 0.0), 1.0),
                way=progress.way,
            )

        ride = Ride(
            self._clocks,
            self.course.localiser,
            self._wheels,
            feedback=feedback,
            where=DRIVE.name,
            caution=self.course.caution,
        )
        return ride
