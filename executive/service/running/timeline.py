"""When which node of a task ran: phases, recoveries and what works. For the page, and for who asks later."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final, Protocol

from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import NodeStatus, Span
from tandem.trees.snapshot import Kind

MOST: Final = 256
"""Runs of nodes that are kept of a task; the oldest go. A fetch has about 60."""
SAID: Final = 120
"""Characters of a node's message that are kept."""
PHASE: Final = "Phase"
WORKS: Final = frozenset({"action", "recovery"})
"""Kinds of nodes that have stretches beside phases. Conditions take no time, and all others would only repeat
their children."""
ENDED: Final = frozenset({NodeStatus.SUCCESS, NodeStatus.FAILURE})


class _Node(Protocol):
    """A node as it is now."""

    @property
    def path(self) -> str: ...
    @property
    def kind(self) -> Kind: ...
    @property
    def type(self) -> str: ...
    @property
    def status(self) -> NodeStatus: ...
    @property
    def last(self) -> NodeStatus: ...
    @property
    def message(self) -> str: ...


class Spans:
    """Watches one task's tree.

    Args:
        before: what was kept of the task when it was under way the last time.
    """

    def __init__(self, before: tuple[Span, ...] = ()) -> None:
        self._done = [each for each in before if each.end is not None]
        self._open: dict[str, Span] = {}

    def see(self, changed: Iterable[_Node], now: RobotTime) -> None:
        """Take in the nodes that have changed, as they are now."""
        for node in changed:
            if node.kind in WORKS or node.type == PHASE:
                self._note(node, now)

    def all(self) -> tuple[Span, ...]:
        """Return them in the order in which they began to be known; those that go on have no end."""
        return (*self._done, *self._open.values())[-MOST:]

    def end(self, at: RobotTime | None) -> tuple[Span, ...]:
        """Return them with an end to each: the tree has been left."""
        for path, span in list(self._open.items()):
            self._close(path, span, NodeStatus.INVALID, at or span.begin, span.message)
        return self.all()

    def _note(self, node: _Node, now: RobotTime) -> None:
        span = self._open.get(node.path)
        if span is not None and node.status is not NodeStatus.RUNNING:
            how = node.status if node.status in ENDED else node.last
            self._close(node.path, span, how, now, node.message)
        elif span is None and node.status is NodeStatus.RUNNING:
            self._open[node.path] = Span(
                path=node.path, kind=node.kind, begin=now, status=node.status, message=node.message[:SAID]
            )
        elif span is not None:
            self._open[node.path] = span.model_copy(update={"message": node.message[:SAID]})

    def _close(self, path: str, span: Span, how: NodeStatus, at: RobotTime, said: str) -> None:
        del self._open[path]
        self._done.append(span.model_copy(update={"end": at, "status": how, "message": said[:SAID]}))
        del self._done[:-MOST]
