"""What went wrong in a task, or in one branch of it, and what was done about it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.tasks import Attempt

ATTEMPTS: Final = 32
"""Attempts that are kept."""
CAUSES: Final = 8
"""Earlier failures that a task's failure tells."""


@dataclass(eq=False)
class FailureLog:
    """Leaves add to it, recoveries say what they try, and its summary is the task's failure.

    Args:
        clocks: robot time of attempts.
    """

    clocks: Clocks
    all: list[Failure] = field(default_factory=list)
    """Each failure of a leaf, in order; also those that a recovery has mended."""
    attempts: list[Attempt] = field(default_factory=list)
    """What went wrong so far and what was done about it, in order; the newest 32."""
    verdict: Failure | None = None
    """Why the main part failed; what failed afterwards, on the way home, comes second."""
    exhausted: tuple[Failure | None, frozenset[Callable[[Failure], bool]]] = (None, frozenset())
    """The failure that a recovery gave up last, and the conditions whose repairs it had tried."""

    def add(self, failure: Failure) -> None:
        """Keep a leaf's failure."""
        self.all.append(failure)

    def last(self) -> Failure:
        """Return the newest failure: the reason of what has just failed."""
        if self.all:
            return self.all[-1]
        return Failure(kind=FailureKind.SKILL_CRASHED, message="a part of the tree failed without a reason")

    def attempted(self, failure: Failure) -> None:
        """Note what went wrong; the recovery that takes it says so next."""
        kept = self.attempts
        if kept and not kept[-1].recovery and kept[-1].failure in failure.chain():
            kept = kept[:-1]  # given up below, and told here once more
        self.attempts = [*kept[1 - ATTEMPTS :], Attempt(at=self.clocks.robot(), failure=failure)]

    def recovering(self, recovery: str, times: int) -> None:
        """Note which recovery takes what went wrong last, and how often it has been tried by now."""
        last = self.attempts[-1].model_copy(update={"recovery": recovery, "times": times})
        self.attempts = [*self.attempts[:-1], last]

    def summary(self) -> Failure | None:
        """Return why the task failed: its main part's failure or else the last; with what came before.

        The causes are the newest different ones, newest first.
        """
        if not self.all:
            return None
        head = self.verdict or self.all[-1]
        seen, causes = {(head.kind, head.where)}, list[Failure]()
        for each in reversed(self.all):
            if (each.kind, each.where) not in seen:
                seen.add((each.kind, each.where))
                causes.append(each)
        return head.model_copy(update={"causes": (*head.causes, *causes[:CAUSES])})


@dataclass(eq=False, kw_only=True)
class BranchFailures(FailureLog):
    """The failures of one branch: each is told to the task as well, but ``last`` is the branch's own."""

    parent: FailureLog
    _told: Attempt | None = field(default=None, init=False)

    def add(self, failure: Failure) -> None:
        """Keep a leaf's failure, here and in the task."""
        super().add(failure)
        self.parent.add(failure)

    def attempted(self, failure: Failure) -> None:
        """Note what went wrong, here and in the task."""
        super().attempted(failure)
        self.parent.attempted(failure)
        self._told = self.parent.attempts[-1]

    def recovering(self, recovery: str, times: int) -> None:
        """Note which recovery takes it; others may have told the task of theirs since."""
        super().recovering(recovery, times)
        now = self.attempts[-1]
        self.parent.attempts = [now if each is self._told else each for each in self.parent.attempts]
        self._told = now
