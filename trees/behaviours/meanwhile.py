"""Have things go on beside what matters, for as long as that lasts."""

from __future__ import annotations

from collections.abc import Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Composite

from tandem.trees.context import TreeContext


class Meanwhile(Composite):
    """Ticks ``main`` and, before it, all that goes on beside it; ends as ``main`` does, once all is at rest.

    What goes on beside may end by itself, or fail: main goes on then, and has to notice what it misses.

    Args:
        name: unique in the tree.
        context: knows when all skills have come to rest.
        main: what matters.
        beside: what goes on meanwhile; stopped at main's end.
    """

    def __init__(self, name: str, context: TreeContext, main: Behaviour, *beside: Behaviour) -> None:
        super().__init__(name, [main, *beside])
        self._context, self._main, self._beside = context, main, beside
        self._verdict: Status | None = None

    def tick(self) -> Iterator[Behaviour]:
        """Tick what goes on, or wait for its rest."""
        if self.status is not Status.RUNNING:
            self._begin()
        if self._verdict is None:
            for each in self._beside:
                if each.status in {Status.INVALID, Status.RUNNING}:
                    yield from each.tick()
            yield from self._main.tick()
            if self._main.status is not Status.RUNNING:
                self._end(self._main.status)
        if self._verdict is not None and self._context.quiet:
            self.stop(self._verdict)
        else:
            self.status = Status.RUNNING
        yield self

    def _begin(self) -> None:
        self._verdict, self.feedback_message = None, ""
        for child in self.children:
            if child.status is not Status.INVALID:
                child.stop(Status.INVALID)

    def _end(self, verdict: Status) -> None:
        self._verdict = verdict
        self.feedback_message = self._main.feedback_message
        for each in self._beside:
            if each.status is Status.RUNNING:
                each.stop(Status.INVALID)
