"""Do several things beside each other, each to its own end."""

from __future__ import annotations

from collections.abc import Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.branch import Branch
from tandem.trees.context import TreeContext


class SideBySide(Composite):
    """RUNNING until all children have ended; SUCCESS when all succeeded, else FAILURE.

    py_trees' Parallel stops the others as soon as one fails; here an arm that has something in its hand
    brings it to a safe place, whatever the other arm does.

    Args:
        name: unique in the tree.
        context: gets one failure in the end: that of the first child that failed, the others' as causes.
        branches: each child with the branch that keeps its failures.
    """

    def __init__(
        self, name: str, context: TreeContext, branches: tuple[tuple[Branch, Behaviour], ...]
    ) -> None:
        super().__init__(name, [child for _, child in branches])
        self._context, self._branches = context, branches
        self._ended: dict[str, Failure | None] = {}

    def tick(self) -> Iterator[Behaviour]:
        """Tick all that have not ended."""
        if self.status is not Status.RUNNING:
            self._begin()
        for branch, child in self._branches:
            if branch.name in self._ended:
                continue
            yield from child.tick()
            if child.status is not Status.RUNNING:
                failed = child.status is Status.FAILURE
                self._ended[branch.name] = (
                    (branch.failures.verdict or branch.failures.last()) if failed else None
                )
        if len(self._ended) < len(self._branches):
            self.status = Status.RUNNING
        else:
            self.stop(self._verdict())
        yield self

    def _begin(self) -> None:
        self._ended.clear()
        self.feedback_message = ""
        for child in self.children:
            if child.status is not Status.INVALID:
                child.stop(Status.INVALID)

    def _verdict(self) -> Status:
        failures = [(who, why) for who, why in self._ended.items() if why is not None]
        if not failures:
            return Status.SUCCESS
        # Who only gave up because of another is not whose failure it is.
        failures.sort(key=lambda each: each[1].kind is FailureKind.OTHER_ARM_FAILED)
        (who, why), *others = failures
        evidence = {**why.evidence, "failed": " and ".join(sorted(name for name, _ in failures))}
        causes = (*why.causes, *(other for _, other in others))
        message = why.message if who in why.message else f"{who}: {why.message}"
        told = why.model_copy(update={"evidence": evidence, "causes": causes, "message": message})
        self._context.failures.add(told)
        self.feedback_message = f"{told.kind}: {told.message}"
        return Status.FAILURE
