"""Do something whatever comes before it, and still tell what came before: a tree's ``finally``."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence
from py_trees.decorators import Decorator

from tandem.trees.context import TreeContext


class Remember(Decorator):
    """SUCCESS when its child has ended, however it did; ``verdict`` keeps how, the context keeps why."""

    def __init__(self, name: str, context: TreeContext, child: Behaviour) -> None:
        """Decorate ``child``."""
        super().__init__(name, child)
        self._context = context
        self.verdict = Status.INVALID

    def initialise(self) -> None:
        """Forget the last verdict."""
        self.verdict = Status.INVALID

    def update(self) -> Status:
        """Pass RUNNING on; turn both ends into SUCCESS."""
        self.feedback_message = self.decorated.feedback_message
        if self.decorated.status is Status.RUNNING:
            return Status.RUNNING
        self.verdict = self.decorated.status
        if self.verdict is Status.FAILURE:
            self._context.failures.verdict = self._context.failures.last()
        return Status.SUCCESS


class Verdict(Behaviour):
    """How the remembered child ended."""

    def __init__(self, name: str, remembered: Remember) -> None:
        """Ask ``remembered``."""
        super().__init__(name)
        self._remembered = remembered

    def update(self) -> Status:
        """Tell it."""
        self.feedback_message = self._remembered.verdict.value.lower()
        return self._remembered.verdict


def afterwards(name: str, context: TreeContext, main: Behaviour, finally_: Behaviour) -> Sequence:
    """Return a sequence that runs ``main``, then ``finally_`` in any case, and ends as ``main`` did.

    It fails too when ``finally_`` fails.
    """
    remembered = Remember(f"{name}: try", context, main)
    return Sequence(
        name, memory=True, children=[remembered, finally_, Verdict(f"{name}: verdict", remembered)]
    )
