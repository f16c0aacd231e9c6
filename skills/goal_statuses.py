"""What an action server tells of its goals: each status numbered, stamped, published and kept."""

from __future__ import annotations

from typing import Final

from tandem.skills.ended_goals import EndedGoals
from tandem.skills.ports.action import GoalState, GoalStatus, status_topic
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message

FEEDBACK_PERIOD: Final = 0.1
"""Robot seconds between two published statuses with new feedback only: it is for people who watch."""


class GoalStatuses:
    """The statuses of one action's goals: of the one under way, and of those before it.

    Args:
        bus: where they are published.
        clocks: robot time for their stamps.
        name: the action's.
    """

    def __init__(self, bus: Bus, clocks: Clocks, name: str) -> None:
        self.ended = EndedGoals()
        self._bus, self._clocks, self._topic = bus, clocks, status_topic(name)
        self._now: GoalStatus | None = None
        self._sequence = 0
        self._published_at = float("-inf")

    @property
    def state(self) -> GoalState:
        """Of the goal under way; UNKNOWN when there is none."""
        return GoalState.UNKNOWN if self._now is None else self._now.state

    def find(self, goal_id: str) -> GoalStatus | None:
        """Return the last status of a goal, or None."""
        if self._now is not None and self._now.goal_id == goal_id:
            return self._now
        return self.ended.find(goal_id)

    def change(
        self,
        goal_id: str,
        state: GoalState,
        *,
        feedback: Message | None = None,
        result: Message | None = None,
        failure: Failure | None = None,
    ) -> GoalStatus:
        """Publish and keep how a goal stands from now on."""
        status = self.of(goal_id, state, feedback=feedback, result=result, failure=failure)
        self._now = None if state.terminal else status
        if state.terminal:
            self.ended.ended(goal_id, status)
        self._published_at = robot_seconds(self._clocks)
        self._topic.publish(self._bus, status)
        return status

    def feed_back(self, goal_id: str, feedback: Message) -> None:
        """Publish what is new of the goal under way, unless something was published just before."""
        now = robot_seconds(self._clocks)
        document = feedback.model_dump(mode="json")
        if now - self._published_at < FEEDBACK_PERIOD:
            return
        if self._now is not None and document == self._now.feedback:
            return
        self.change(goal_id, self.state, feedback=feedback)

    def of(
        self,
        goal_id: str,
        state: GoalState,
        *,
        feedback: Message | None = None,
        result: Message | None = None,
        failure: Failure | None = None,
    ) -> GoalStatus:
        """Return a status with the next number and the stamp of now, for an answer; it is not published."""
        self._sequence += 1
        return GoalStatus(
            goal_id=goal_id,
            state=state,
            sequence=self._sequence,
            stamp=self._clocks.robot(),
            feedback=None if feedback is None else feedback.model_dump(mode="json"),
            result=None if result is None else result.model_dump(mode="json"),
            failure=failure,
        )
