"""One trajectory goal on the hardware: sent, watched, stopped."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from typing import Final

from tandem.skills.arm.trajectory import Trajectory
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import CancelMotion, GroupStatus, MotionState, TrajectoryGoal
from tandem.skills.ports.keys import STOP_STATE, Latest, group_cancel, group_goal, group_status
from tandem.skills.ports.robot_description import JointGroup

ANSWER_WITHIN: Final = 2.0
"""Robot seconds for the hardware's answer to a goal or a cancel."""
ASKS: Final = 3
"""How often a goal is sent while no answer comes: a process that did not go on for a while misses one. The
goal's id is the same, and the hardware knows it again."""
CANCEL_AGAIN: Final = 0.5
"""Robot seconds after which a cancel is sent again, until the group is at rest."""
LATE: Final = 2.0
"""Robot seconds beyond the motion's and its settling time after which the hardware is said to be lost."""
RESTS_WITHIN: Final = 0.6
"""Robot seconds for which a motion is offered again to a group that is not at rest yet."""
ENDED: Final = frozenset({MotionState.SUCCEEDED, MotionState.ABORTED, MotionState.CANCELED})


@dataclass(frozen=True)
class Ended:
    """How the hardware ended a motion; ``failure`` is None when it got there, or was told to stop."""

    status: GroupStatus | None
    failure: Failure | None


@dataclass(frozen=True)
class Arrival:
    """How near its end (rad or m) each joint must get, and in how many robot seconds after the motion's."""

    tolerance: float
    within: float


class GroupDriver:
    """Speaks to one group of the hardware.

    Args:
        bus: where the hardware is.
        clocks: robot time.
        group: the joints that move, and how far they may stray.
        where: the action's name, for failures.
    """

    def __init__(self, bus: Bus, clocks: Clocks, group: JointGroup, where: str) -> None:
        self._bus, self._clocks, self._where = bus, clocks, where
        self._goal, self._cancel = group_goal(group.name), group_cancel(group.name)
        self._status = Latest(bus, group_status(group.name))
        self._stop = Latest(bus, STOP_STATE)
        self._group, self._tolerance = group.name, group.path_tolerance
        self.moving = False
        self._ends_at = 0.0
        self._cancel_again_at = float("inf")
        self._sent_at = 0.0
        self._duration = 0.0
        self._id = ""

    def send(
        self, goal_id: str, trajectory: Trajectory, arrives: Arrival | None = None
    ) -> Generator[None, None, Failure | None]:
        """Hand the motion over; yields while there is no answer. A failure means that nothing moves.

        Args:
            goal_id: names the motion.
            trajectory: what to do.
            arrives: None: as goals of the hardware do by themselves.
        """
        goal = TrajectoryGoal(
            id=goal_id,
            keeper=f"skill/{self._where}",
            points=trajectory.points(),
            path_tolerance=self._tolerance,
        )
        if arrives is not None:
            goal = goal.model_copy(update={"goal_tolerance": arrives.tolerance, "goal_time": arrives.within})
        self._id = goal_id
        self._cancel_again_at = float("inf")
        self.moving = True
        until = robot_seconds(self._clocks) + RESTS_WITHIN
        while True:
            answer = yield from self._ask(goal)
            if answer is None:
                self.stop()
                return self._failure(FailureKind.HARDWARE_LOST, f"{self._group} did not answer to a goal")
            accepted = self._goal.decode_answer(answer)
            if accepted.accepted:
                break
            # Whoever streamed set-points before leaves the arm swaying for a moment after the last of them.
            if self.stopped or robot_seconds(self._clocks) > until:
                self.moving = False
                kind = FailureKind.HARDWARE_STOPPED if self.stopped else FailureKind.NOT_READY
                return self._failure(kind, f"{self._group} refused the motion: {accepted.reason}")
            yield
        self._sent_at, self._duration = robot_seconds(self._clocks), trajectory.duration
        self._ends_at = self._sent_at + trajectory.duration + goal.goal_time + LATE
        return None

    @property
    def stopped(self) -> bool:
        """Whether the hardware's stop is set."""
        state = self._stop.refresh()
        return state is not None and state.stopped

    @property
    def elapsed(self) -> float:
        """Seconds of the motion that have passed."""
        return min(self._duration, max(0.0, robot_seconds(self._clocks) - self._sent_at - self._held))

    @property
    def progress(self) -> float:
        """Share of the motion's time that has passed, 0 to 1."""
        if self._duration <= 0.0:
            return 1.0
        return self.elapsed / self._duration

    def poll(self) -> Ended | None:
        """Return how the motion ended, and None while it goes on."""
        status = self._status.refresh()
        if status is not None and status.goal_id == self._id and status.state in ENDED and status.at_rest:
            self.moving = False
            return Ended(status, self._explain(status))
        if robot_seconds(self._clocks) > self._ends_at + self._held:
            self.stop()
            self.moving = False
            return Ended(None, self._failure(FailureKind.HARDWARE_LOST, f"{self._group} tells of no end"))
        if robot_seconds(self._clocks) > self._cancel_again_at:
            self._tell_cancel()
        return None

    @property
    def _held(self) -> float:
        """Seconds for which the hardware has stood on the way, since it did not hear of this process."""
        status = self._status.value
        return status.held if status is not None and status.goal_id == self._id else 0.0

    def stop(self) -> None:
        """Tell the hardware to stop; ``poll`` then tells when it is at rest."""
        self._tell_cancel()
        self._ends_at = robot_seconds(self._clocks) + ANSWER_WITHIN + LATE

    def close(self) -> None:
        """End the subscriptions."""
        self._status.close()
        self._stop.close()

    def _tell_cancel(self) -> None:
        self._cancel.query(self._bus, CancelMotion(id=self._id))
        self._cancel_again_at = robot_seconds(self._clocks) + CANCEL_AGAIN

    def _ask(self, goal: TrajectoryGoal) -> Generator[None, None, bytes | None]:
        for _ in range(ASKS):
            answer = yield from self._await(self._goal.query(self._bus, goal))
            if answer is not None:
                return answer
        return None

    def _await(self, pending: Pending) -> Generator[None, None, bytes | None]:
        until = robot_seconds(self._clocks) + ANSWER_WITHIN
        while (answer := pending.poll()) is None:
            if pending.done() or robot_seconds(self._clocks) > until:
                return pending.poll()
            yield
        return answer

    def _explain(self, status: GroupStatus) -> Failure | None:
        if status.state is MotionState.ABORTED:
            kind = FailureKind.HARDWARE_STOPPED if self.stopped else FailureKind.ARM_STOPPED
            return self._failure(
                kind,
                f"{status.joint or self._group} strayed by {status.error:.3f}",
                joint=status.joint,
                error_rad=status.error,
                share=round(self.progress, 3),
            )
        if status.state is MotionState.CANCELED and self.stopped:
            return self._failure(FailureKind.HARDWARE_STOPPED, f"{self._group} was stopped")
        return None

    def _failure(self, kind: FailureKind, message: str, **evidence: str | float | bool) -> Failure:
        return Failure(kind=kind, message=message, where=self._where, evidence=evidence)
