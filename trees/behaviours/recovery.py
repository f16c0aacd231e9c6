"""Try; when it fails, repair what the failure's kind says may be repaired, and try again."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite, Sequence

from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.check import Check
from tandem.trees.context import TreeContext


@dataclass(frozen=True)
class RecoveryStep:
    """One recovery: for which failures, how often at the most, and what it does.

    Args:
        name: unique in the tree; what people read: "go home and search again".
        helps: a condition over the failure (``trees/recovery_kinds.py``).
        times: how often, before the recovery begins anew from outside.
        repair: what is done; when it fails, the next step is asked.
    """

    name: str
    helps: Callable[[Failure], bool]
    times: int
    repair: Behaviour


class Allowance(Behaviour):
    """SUCCESS as long as there are tries left, and takes one; keeps in the context that it was taken."""

    def __init__(self, name: str, context: TreeContext, step: str, times: int) -> None:
        """``times``: tries until ``reset``."""
        super().__init__(name)
        self._context, self._step, self._times = context, step, times
        self.taken = 0

    def reset(self) -> None:
        """Begin anew."""
        self.taken = 0

    def update(self) -> Status:
        """Take one."""
        if self.taken >= self._times:
            self.feedback_message = f"tried {self.taken} times"
            return Status.FAILURE
        self.taken += 1
        self._context.failures.recovering(self._step, self.taken)
        self.feedback_message = f"{self.taken} of {self._times}"
        return Status.SUCCESS


class Recovery(Composite):
    """Ticks ``main``; each time it fails, the first step that takes the failure and then ``main`` again.

    FAILURE when no step takes it, or ``within`` robot seconds have passed: then the failure of main, as
    ``conclude`` puts it, is the last one that the context keeps.

    Args:
        name: unique in the tree.
        context: keeps the failures.
        main: what is tried; begins anew after each repair, so it asks first what is done already.
        steps: from cheap to dear.
        within: robot seconds after which nothing is repaired any more.
        conclude: makes of main's failure what is told when it is given up.
    """

    def __init__(
        self,
        name: str,
        context: TreeContext,
        main: Behaviour,
        steps: tuple[RecoveryStep, ...],
        *,
        within: float,
        conclude: Callable[[Failure], Failure] = lambda failure: failure,
    ) -> None:
        self._context, self._within, self._conclude = context, within, conclude
        self._failure: Failure | None = None
        self._allowances = [
            Allowance(f"{step.name}: at most {step.times}", context, step.name, step.times) for step in steps
        ]
        self._at, self._since = 0, 0.0
        self._helps = frozenset(step.helps for step in steps)
        super().__init__(name, [main, *map(self._step, steps, self._allowances)])

    def initialise(self) -> None:
        """Begin with main and with all tries."""
        self._at, self._since, self._failure = 0, self._context.seconds, None
        for allowance in self._allowances:
            allowance.reset()

    def tick(self) -> Iterator[Behaviour]:
        """Tick main, or the step that is at work."""
        if self.status is not Status.RUNNING:
            self.initialise()
            for each in self.children:
                if each.status is not Status.INVALID:
                    each.stop(Status.INVALID)
        while True:
            child = self.current_child = self.children[self._at]
            yield from child.tick()
            status = self._after(child.status)
            if status is None:
                continue
            if status is Status.RUNNING:
                self.status = status
            else:
                self.stop(status)
            yield self
            return

    def _after(self, status: Status) -> Status | None:
        """Return the status after a child's, None when the next child's turn is at once."""
        if status is Status.RUNNING:
            return status
        if self._at == 0:
            return self._after_main(status)
        if status is Status.SUCCESS:
            self._at = 0
            return Status.RUNNING
        return self._next()

    def _after_main(self, status: Status) -> Status | None:
        if status is Status.SUCCESS:
            self.feedback_message = ""
            return status
        self._failure = self._context.failures.last()
        self.feedback_message = f"{self._failure.kind}: {self._failure.message}"
        self._context.failures.attempted(self._failure)
        if self._context.seconds - self._since > self._within:
            return self._give_up(self._failure)
        return self._next()

    def _next(self) -> Status | None:
        self._at += 1
        if self._at < len(self.children):
            return None
        assert self._failure is not None, "main has failed"
        return self._give_up(self._failure)

    def _give_up(self, failure: Failure) -> Status:
        given_up = self._conclude(failure)
        self._context.failures.add(given_up)
        self._context.failures.exhausted = (given_up, self._helps)
        return Status.FAILURE

    def _step(self, step: RecoveryStep, allowance: Allowance) -> Behaviour:
        def takes() -> bool:
            failure, (given_up, exhausted) = self._failure, self._context.failures.exhausted
            # What a recovery below has given up is not tried here in the same way once more.
            tried = failure is given_up and step.helps in exhausted
            return failure is not None and not tried and step.helps(failure)

        return Sequence(
            step.name, memory=True, children=[Check(f"{step.name}?", takes), allowance, step.repair]
        )
