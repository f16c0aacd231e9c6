"""Pause, resume and step of the running task: its skills come to rest, its tree stays where it is."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.tasks import TaskState
from tandem.trees.context import TreeContext
from tandem.trees.elapsed import Elapsed
from tandem.trees.snapshot import kind_of

Step = Literal["", "leaf", "tick"]
"""How far a paused task goes on: to its end, by one leaf, by one tick of its tree."""


class Pausing:
    """Whether the tree may be ticked, and the way there and back.

    Args:
        context: whose goals are paused.
        clocks: robot time, to tell the tree how long it stood.
    """

    def __init__(self, context: TreeContext, clocks: Clocks) -> None:
        self.state = TaskState.RUNNING
        """RUNNING, PAUSING or PAUSED."""
        self._context, self._clocks = context, clocks
        self._stepping: Step = ""
        self._stood: Elapsed | None = None

    @property
    def free(self) -> bool:
        """Whether the tree may be ticked."""
        return self.state is TaskState.RUNNING

    @property
    def stepping(self) -> Step:
        """How far the tree goes on before it is paused again."""
        return self._stepping

    def pause(self) -> None:
        """Have all goals come to rest; ``step`` sees when they have."""
        self._stepping = ""
        if self.free:
            self.state, self._stood = TaskState.PAUSING, Elapsed(self._clocks)
            self.step()

    def resume(self, step: Step = "") -> None:
        """Have the goals go on; with a ``step`` until one more leaf has ended, or by one tick."""
        self._stepping = step
        if self._stood is not None:
            self._stood.update()
            self._context.paused_for += self._stood.robot
        self.state, self._stood = TaskState.RUNNING, None
        for handle in self._context.clients.open:
            handle.resume()

    def step(self) -> None:
        """See how far the goals are."""
        if self._stood is None:
            return
        self._stood.update()
        for handle in self._context.clients.open:
            handle.pause()
        if self.state is TaskState.PAUSING and all(handle.paused for handle in self._context.clients.open):
            self.state = TaskState.PAUSED

    def after_tick(self, ticked: Iterable[Behaviour]) -> None:
        """Pause again when one of the nodes just ticked is the leaf that was waited for."""
        if self._stepping == "tick" or (self._stepping and any(_is_leaf_at_its_end(node) for node in ticked)):
            self.pause()


def _is_leaf_at_its_end(node: Behaviour) -> bool:
    ended = node.status in {Status.SUCCESS, Status.FAILURE}
    return ended and not node.children and kind_of(node) != "condition"
