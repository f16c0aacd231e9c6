"""When each leaf of a task's tree ran, on the robot's clock, from what the executive tells."""

from __future__ import annotations

from dataclasses import dataclass, field

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import TREE, NodeStatus, TreeNode


@dataclass(eq=False)
class Span:
    """One run of a leaf: robot seconds; ``end`` and ``status`` come when it has ended."""

    leaf: str
    begin: float
    end: float | None = None
    status: NodeStatus = NodeStatus.RUNNING


@dataclass(eq=False)
class Timeline:
    """A node that listens to the trees.

    Args:
        bus: where they are told.
        clocks: robot time.
    """

    bus: Bus
    clocks: Clocks
    spans: list[Span] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Listen from now on."""
        self._trees = Latest(self.bus, TREE, depth=1024)
        self._open: dict[str, Span] = {}

    def step(self) -> bool:
        """Take in what was told."""
        now = robot_seconds(self.clocks)
        for tree in self._trees.take():
            self._note(tree.root, now)
        return False

    def running(self, leaf: str) -> Span | None:
        """Return the run of a leaf that is under way, or None."""
        return self._open.get(leaf)

    def of(self, leaf: str) -> tuple[Span, ...]:
        """Return all runs of a leaf, in order."""
        return tuple(span for span in self.spans if span.leaf == leaf)

    def succeeded(self, leaf: str) -> Span | None:
        """Return the last run of a leaf that succeeded, or None."""
        ended = [span for span in self.of(leaf) if span.status is NodeStatus.SUCCESS]
        return ended[-1] if ended else None

    def close(self) -> None:
        """Stop listening."""
        self._trees.close()

    def _note(self, node: TreeNode, now: float) -> None:
        for child in node.children:
            self._note(child, now)
        if node.children:
            return
        span = self._open.get(node.name)
        if node.status is NodeStatus.RUNNING:
            if span is None:
                self._open[node.name] = Span(node.name, now)
                self.spans.append(self._open[node.name])
        elif span is not None:
            span.end, span.status = now, node.status
            del self._open[node.name]
