"""Each goal is in the ledger before it is sent: so one of before a restart is known, and its number taken."""

from __future__ import annotations

from collections.abc import Callable

from tandem.executive.ledger.port import Ledger, SentGoal


class LedgerJournal:
    """See ``tandem.trees.client.GoalJournal``.

    Args:
        ledger: where goals are written.
        before: called before each is written; what it writes is on disk with the goal.
    """

    def __init__(self, ledger: Ledger, before: Callable[[], None]) -> None:
        self._ledger, self._before = ledger, before

    def sending(self, goal_id: str, action: str) -> None:
        """Have it on disk."""
        self._before()
        self._ledger.goal(SentGoal(goal_id, action))
        self._ledger.commit()

    def ended(self, goal_id: str, how: str) -> None:
        """Write it with whatever is committed next: if that is lost, it is only asked after once more."""
        self._ledger.goal_ended(goal_id, how)
