"""Each goal is in the ledger before it is sent: so one of before a restart is known, and its number taken."""

from __future__ import annotations

from executive.ledger.port import Ledger, SentGoal


class LedgerJournal:
    """See ``trees.client.GoalJournal``.

    Args:
        ledger: where goals are written.
    """

    def __init__(self, ledger: Ledger) -> None:
        self._ledger = ledger

    def sending(self, goal_id: str, action: str) -> None:
        """Have it on disk."""
        self._ledger.goal(SentGoal(goal_id, action))
        self._ledger.commit()

    def ended(self, goal_id: str, how: str) -> None:
        """Write it with whatever is committed next: if that is lost, it is only asked after once more."""
        self._ledger.goal_ended(goal_id, how)
