"""A branch that runs beside others: its failures are its own, so that no arm answers for the other's."""

from __future__ import annotations

from dataclasses import dataclass, field

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.tasks import Attempt
from tandem.trees.context import TreeContext


@dataclass(eq=False, kw_only=True)
class Branch(TreeContext):
    """A task's surroundings as one of its branches sees them.

    Clients, knowledge, clock and resources are the task's. A failure is kept here and told to the task; but
    ``last_failure`` is the last one of this branch.
    """

    parent: TreeContext
    name: str
    """Who it is, in words: "left arm"."""
    _told: Attempt | None = field(default=None, init=False)

    @property
    def seconds(self) -> float:
        """The task's robot seconds."""
        return self.parent.seconds

    def failed(self, failure: Failure) -> None:
        """Keep a leaf's failure, here and in the task."""
        super().failed(failure)
        self.parent.failed(failure)

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
        parent=context,
        name=name,
    )
