"""How goals ended, for who asks late: a bounded memory of an action server."""

from __future__ import annotations

from collections import OrderedDict
from typing import Final, TypeVar

from tandem.skills.ports.action import GoalStatus

T = TypeVar("T")

KEPT: Final = 256
"""Ended goals whose result is remembered; as many rejected ones, and as many that were called off unseen."""


class EndedGoals:
    """The last statuses of goals that ended, of those that were rejected, and what was called off unseen."""

    def __init__(self) -> None:
        # As JSON, 0.2 to 0.4 kB each: ended goals are seldom asked for, and as objects they take seven times
        # that. Those of a rare action fill up over weeks.
        self._over: OrderedDict[str, str] = OrderedDict()
        self._rejected: OrderedDict[str, str] = OrderedDict()
        self._called_off: OrderedDict[str, None] = OrderedDict()

    def find(self, goal_id: str) -> GoalStatus | None:
        """Return how a goal ended, or None."""
        packed = self._over.get(goal_id) or self._rejected.get(goal_id)
        return None if packed is None else GoalStatus.model_validate_json(packed)

    def ended(self, goal_id: str, status: GoalStatus) -> None:
        """Keep how a goal ended."""
        _keep(self._over, goal_id, status.model_dump_json())

    def rejected(self, goal_id: str, status: GoalStatus) -> None:
        """Keep the answer to a goal that was not started.

        The same message may come twice, and late: for a client that has given up by then.
        """
        _keep(self._rejected, goal_id, status.model_dump_json())

    def call_off(self, goal_id: str) -> None:
        """Note that a goal was cancelled before it was there: messages overtake each other."""
        _keep(self._called_off, goal_id, None)

    def is_called_off(self, goal_id: str) -> bool:
        """Say whether the goal was cancelled before it was there."""
        return goal_id in self._called_off


def _keep(kept: OrderedDict[str, T], goal_id: str, value: T) -> None:
    """Note what is so of a goal; of more than ``KEPT`` goals the oldest is forgotten."""
    kept[goal_id] = value
    kept.move_to_end(goal_id)
    while len(kept) > KEPT:
        kept.popitem(last=False)
