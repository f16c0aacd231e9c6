"""COORDINATE: have both arms give way to each other until cancelled (two-arm thesis, Algorithm 3)."""

from __future__ import annotations

from tandem.skills.bimanual.coordinator import Coordinator
from tandem.skills.ports.actions.bimanual import (
    COORDINATE,
    CoordinateFeedback,
    CoordinateGoal,
    CoordinateResult,
)
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.skill import ActionType, Command, Run, canceled


class Coordinate:
    """The skill. It rules over the coordinator and moves nothing itself: at rest is who obeys it.

    Args:
        coordinator: sees and tells.
    """

    def __init__(self, coordinator: Coordinator) -> None:
        self._coordinator = coordinator

    @property
    def action(self) -> ActionType[CoordinateGoal, CoordinateFeedback, CoordinateResult]:
        """The contract."""
        return COORDINATE

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.05

    def check(self, goal: CoordinateGoal) -> Failure | None:  # noqa: ARG002 - whatever a goal may say is right
        """Take every goal."""
        return None

    def run(self, goal: CoordinateGoal, goal_id: str) -> Run[CoordinateFeedback, CoordinateResult]:
        """Coordinate until cancelled. A pause changes nothing: who is paused stands."""
        del goal_id
        self._coordinator.begin(goal.mode, goal.phi)
        try:
            while True:
                if (yield self._feedback()) is Command.CANCEL:
                    return canceled()
        finally:
            self._coordinator.end()

    def _feedback(self) -> CoordinateFeedback:
        state, seen = self._coordinator.coordination, self._coordinator.seen
        return CoordinateFeedback(
            episode=state.episode,
            leader=state.leader if state.open else None,
            left_safe=seen is None or seen.left.back_home,
            right_safe=seen is None or seen.right.back_home,
        )
