"""Do something again each time that a reflex has taken the base from it, until somebody says enough."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.context import TreeContext
from tandem.trees.recovery_kinds import another_way_helps, localising_helps, waiting_helps

REFLEX: Final = "reflex"
"""Names, in a failure's evidence, the reflex that had the base."""
WAITED: Final = "waited_s"
"""Marks, in a failure's evidence, that it is about a wait that became too long."""
FREE_WITHIN: Final = 60.0
"""Robot seconds for which a reflex may have the base without a break, before it is given up."""
_PASSES: Final = another_way_helps.kinds | {FailureKind.OVERRIDDEN, FailureKind.OTHER}
"""Kinds of what a reflex saw that pass by themselves: something in the base's way, another override, or what
no kind says."""


def gave_way(failure: Failure) -> bool:
    """Say whether a reflex had the base since something was in the way, so that going on helps.

    What else a reflex may have seen, such as a silent sensor, is answered by its kind as always.
    """
    if REFLEX not in failure.evidence or WAITED in failure.evidence:
        return False
    saw = failure.causes[0] if failure.causes else failure
    if failure.kind is FailureKind.BUSY:
        return not failure.causes or saw.kind in _PASSES
    return failure.kind is FailureKind.OVERRIDDEN and saw.kind in _PASSES


class GiveWay(Decorator):
    """Ticks its child; after a failure by which a reflex took the base, it begins the child anew.

    FAILURE with what ``enough`` returns, or after any other failure. Each time is told in the task's
    attempts.

    Args:
        name: unique in the tree.
        context: keeps the failures.
        child: waits for the base, and moves it.
        enough: told of each such failure; returns why it shall not be tried again, or None.
        settles: whether no repair for what was given up here is tried above.
        free: whether nothing has the base, so that the child may begin anew. A child that waits by itself,
            its first time too, needs none (``base_is_free``); a drive that has other ways does not wait
            before it has tried, and has its base waited for here.
    """

    def __init__(
        self,
        name: str,
        context: TreeContext,
        child: Behaviour,
        enough: Callable[[Failure], Failure | None],
        *,
        settles: bool = True,
        free: Callable[[], bool] = lambda: True,
    ) -> None:
        super().__init__(name, child)
        self._context, self._enough, self._settles, self._free = context, enough, settles, free
        self._times = 0
        self._waits_since: float | None = None

    def initialise(self) -> None:
        """Begin to count."""
        self._times, self._waits_since = 0, None

    def tick(self) -> Iterator[Behaviour]:
        """Tick the child, once the base is free again."""
        if self.status is Status.RUNNING and self._waits_since is not None and not self._free():
            if self._context.seconds - self._waits_since > FREE_WITHIN:
                self.stop(Status.FAILURE)
            yield self
            return
        self._waits_since = None
        yield from super().tick()

    def update(self) -> Status:
        """Pass the child's status on, unless a reflex was the reason of a failure."""
        status: Status = self.decorated.status
        self.feedback_message = self.decorated.feedback_message
        if status is not Status.FAILURE:
            return status
        failures = self._context.failures
        failure = failures.last()
        if not gave_way(failure):
            if WAITED in failure.evidence:
                self._settle(failure)
            return status
        given_up = self._enough(failure)
        if given_up is not None and not self._settles:
            return status
        failures.attempted(failure)
        if given_up is not None:
            given_up = given_up.model_copy(update={"where": self.name})
            failures.add(given_up)
            self._settle(given_up)
            self.feedback_message = f"{given_up.kind}: {given_up.message}"
            return status
        self._times, self._waits_since = self._times + 1, self._context.seconds
        failures.recovering(self.name, self._times)
        self.feedback_message = f"{self._times} times: {failure.message}"
        return Status.RUNNING

    def _settle(self, given_up: Failure) -> None:
        if not self._settles:
            return
        helps = frozenset((waiting_helps, localising_helps, another_way_helps))
        self._context.failures.exhausted = (given_up, helps)
