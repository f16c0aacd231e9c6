"""A branch that runs beside others: its failures are its own, so that no arm answers for the other's."""

from __future__ import annotations

from dataclasses import dataclass

from tandem.trees.context import TreeContext
from tandem.trees.failure_log import BranchFailures


@dataclass(eq=False, kw_only=True)
class Branch(TreeContext):
    """A task's surroundings as one of its branches sees them.

    Clients, knowledge, clock and resources are the task's. So are its notes, for no goal of
    a node may have the number of one before a restart. Failures are the branch's own, and told to the task.
    """

    parent: TreeContext
    name: str
    """Who it is, in words: "left arm"."""

    def __post_init__(self) -> None:
        """Keep its own failures, and tell them to the task."""
        self.failures = BranchFailures(self.clocks, parent=self.parent.failures)

    @property
    def seconds(self) -> float:
        """The task's robot seconds."""
        return self.parent.seconds

    def enter(self, phase: str, fraction: float) -> None:
        """Say which phase the task is in; it never runs backwards."""
        self.parent.enter(phase, fraction)


def branch(context: TreeContext, name: str) -> Branch:
    """Return a branch of a task's surroundings."""
    return Branch(
        task=context.task,
        clients=context.clients,
        knowledge=context.knowledge,
        clocks=context.clocks,
        resources=context.resources,
        notes=context.notes,
        parent=context,
        name=name,
    )
