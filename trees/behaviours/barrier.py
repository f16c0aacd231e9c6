"""A barrier: all wait for each other, then all go on; when one fails first, the others are let go with that.

Two-arm thesis, 4.3: the synchronous pick. What each does up to the barrier stands in a ``Member``, so the
barrier hears of its failure.
"""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.context import TreeContext


class Barrier:
    """Who has arrived, and who won't.

    Args:
        parties: those that wait for each other, in words ("left arm").
    """

    def __init__(self, *parties: str) -> None:
        self._parties = parties
        self._arrived: set[str] = set()
        self._lost: dict[str, Failure] = {}
        self.met = False
        """Whether all were there at once; stays so until the barrier is set up anew."""

    def reset(self) -> str:
        """Set it up anew; return in words who is waited for."""
        self._arrived.clear()
        self._lost.clear()
        self.met = False
        return f"{' and '.join(self._parties)} will wait for each other"

    def arrive(self, party: str) -> None:
        """Note that a party waits, or has nothing left to do."""
        self._arrived.add(party)
        self.met = self.met or len(self._arrived) == len(self._parties)

    def leave(self, party: str) -> None:
        """Note that a party waits no more."""
        self._arrived.discard(party)

    def lose(self, party: str, failure: Failure) -> None:
        """Note that a party won't come."""
        self._lost[party] = failure

    def missing(self) -> tuple[str, ...]:
        """Return who has not arrived."""
        return tuple(each for each in self._parties if each not in self._arrived)

    def lost(self, party: str) -> tuple[str, Failure] | None:
        """Return another party that won't come, and why; None when all may."""
        return next(((who, why) for who, why in self._lost.items() if who != party), None)


class Meet(Behaviour):
    """RUNNING until all parties are there, then SUCCESS; FAILURE when another one failed before.

    Args:
        name: unique in the tree.
        context: keeps the failure.
        barrier: where they meet.
        party: who this is.
    """

    def __init__(self, name: str, context: TreeContext, barrier: Barrier, party: str) -> None:
        super().__init__(name)
        self._context, self._barrier, self._party = context, barrier, party

    def update(self) -> Status:
        """Arrive, and see who else has."""
        barrier = self._barrier
        barrier.arrive(self._party)
        if barrier.met:
            self.feedback_message = "all are there"
            return Status.SUCCESS
        lost = barrier.lost(self._party)
        if lost is None:
            self.feedback_message = f"waits for the {' and the '.join(barrier.missing())}"
            return Status.RUNNING
        failure = self._other_failed(*lost)
        self._context.failures.add(failure)
        self.feedback_message = failure.message
        return Status.FAILURE

    def terminate(self, new_status: Status) -> None:
        """Wait no more when the tree turns to something else."""
        if new_status is not Status.SUCCESS:
            self._barrier.leave(self._party)

    def _other_failed(self, who: str, why: Failure) -> Failure:
        return Failure(
            kind=FailureKind.OTHER_ARM_FAILED,
            message=f"the {who} failed before both could go on: {why.kind}: {why.message}",
            where=self.name,
            evidence={"failed": who},
            causes=(why,),
        )


class Member(Decorator):
    """Passes its child's status on, and tells the barrier when the child has ended.

    One that has failed won't come; one that has succeeded without coming had nothing left to wait for.
    """

    def __init__(
        self, name: str, context: TreeContext, child: Behaviour, barrier: Barrier, party: str
    ) -> None:
        """See ``Meet``; ``context`` keeps the child's failures."""
        super().__init__(name, child)
        self._context, self._barrier, self._party = context, barrier, party

    def update(self) -> Status:
        """Pass the status on."""
        status: Status = self.decorated.status
        self.feedback_message = self.decorated.feedback_message
        if status is Status.FAILURE:
            self._barrier.lose(self._party, self._context.failures.last())
        elif status is Status.SUCCESS:
            self._barrier.arrive(self._party)
        return status
