"""Stop what is under way when that on which it rests no longer holds."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext


class Guarded(Decorator):
    """Passes its child's status on while ``holds``; else stops it, waits for rest, and is FAILURE.

    Args:
        name: unique in the tree, and reads as what must hold ("while the item is in the hand").
        context: keeps the failure; knows when all skills have come to rest.
        child: what is under way.
        holds: asked at each tick, before the child's.
        otherwise: the failure when it does not hold.
    """

    def __init__(
        self,
        name: str,
        context: TreeContext,
        child: Behaviour,
        *,
        holds: Callable[[], bool],
        otherwise: Callable[[], Failure],
    ) -> None:
        super().__init__(name, child)
        self._context, self._holds, self._otherwise = context, holds, otherwise
        self._broken = False

    def tick(self) -> Iterator[Behaviour]:
        """Ask, then tick the child or wait for rest."""
        if self.status is not Status.RUNNING:
            self._broken = False
        if not self._broken and self._holds():
            yield from super().tick()
            return
        if not self._broken:
            self._broken = True
            self._context.failures.add(self._told())
            self.decorated.stop(Status.INVALID)
        if self._context.quiet:
            self.stop(Status.FAILURE)
        else:
            self.status = Status.RUNNING
        yield self

    def update(self) -> Status:
        """Pass the child's status on."""
        status: Status = self.decorated.status
        self.feedback_message = self.decorated.feedback_message
        return status

    def _told(self) -> Failure:
        failure = self._otherwise()
        self.feedback_message = f"{failure.kind}: {failure.message}"
        return failure.model_copy(update={"where": self.name})
