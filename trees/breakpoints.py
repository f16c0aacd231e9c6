"""Breakpoints, and nodes forced to a status: gates before the ``tick`` of single nodes of a built tree."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.tasks import ForcedStatus, Side
from tandem.trees.context import TreeContext
from tandem.trees.node_paths import paths


@dataclass(eq=False)
class _Gate:
    """What stands before one node, and where the tree is with it."""

    node: Behaviour
    tick: Callable[[], Iterator[Behaviour]]
    """The node's own."""
    before: bool = False
    after: bool = False
    forced: Status | None = None
    let_in: bool = False
    """Whether the tree was let past the breakpoint before the node; until the node has ended."""
    held: Status | None = None
    """The status that the node has ended with while the tree is held behind it; RUNNING: held before it."""


@dataclass(eq=False)
class Breakpoints:
    """The gates of one tree. A tree that has come to one must not be ticked until ``release``.

    Args:
        root: the tree.
        context: keeps the failure of a node that is forced to fail.
    """

    root: Behaviour
    context: TreeContext
    hit: str = ""
    """What the tree has come to: "before grasp"; empty while it goes."""
    changes: int = 0
    """How often a gate was set or taken away."""
    _gates: dict[Behaviour, _Gate] = field(default_factory=dict)

    def find(self, name: str) -> Behaviour | str:
        """Return the node of this path or name, or why there is none. The root's name is its path."""
        every = tuple(paths(self.root))
        named = [each for each in every if name == each[0]] or [
            each for each in every if name == each[1].name
        ]
        if not named:
            return f"no node {name[:80]!r} in the tree"
        if len(named) > 1:
            return "several nodes of that name; name one by its path: " + ", ".join(path for path, _ in named)
        return named[0][1]

    def hold(self, node: Behaviour, *, before: bool, on: bool = True) -> None:
        """Put a breakpoint before or behind a node, or take it away."""
        gate = self._gate(node)
        self.changes += 1
        if before:
            gate.before = on
        else:
            gate.after = on

    def force(self, node: Behaviour, status: Status | None) -> None:
        """Have a node end with a status instead of working; None lets it work again."""
        self._gate(node).forced = status
        self.changes += 1

    def held(self) -> tuple[tuple[str, bool], ...]:
        """Return the breakpoints: the node's path, and whether it is before the node."""
        return tuple(
            (path, before)
            for path, gate in self._by_path()
            for before, on in ((True, gate.before), (False, gate.after))
            if on
        )

    def breakpoints(self) -> dict[str, tuple[Side, ...]]:
        """Return on which sides of which nodes, by path, there are breakpoints."""
        sides: dict[str, tuple[Side, ...]] = {}
        for path, before in self.held():
            sides[path] = (*sides.get(path, ()), "before" if before else "after")
        return sides

    def forced(self) -> dict[str, ForcedStatus]:
        """Return how the nodes end that are forced, by path."""
        return {
            path: "SUCCESS" if gate.forced is Status.SUCCESS else "FAILURE"
            for path, gate in self._by_path()
            if gate.forced is not None
        }

    def _by_path(self) -> Iterator[tuple[str, _Gate]]:
        if self._gates:
            yield from ((path, self._gates[node]) for path, node in paths(self.root) if node in self._gates)

    def release(self) -> None:
        """Let the tree go on from where it is held."""
        self.hit = ""

    def _gate(self, node: Behaviour) -> _Gate:
        gate = self._gates.get(node)
        if gate is None:
            gate = self._gates[node] = _Gate(node, node.tick)
            node.tick = lambda: self._tick(gate)  # type: ignore[method-assign]  # that is what a gate is
        return gate

    def _tick(self, gate: _Gate) -> Iterator[Behaviour]:
        node = gate.node
        if node.status is not Status.RUNNING:  # it begins, or it was stopped while it was held
            gate.held, gate.let_in = None, False
        if gate.held not in {None, Status.RUNNING}:
            yield from self._leave(gate)
            return
        began = node.status is Status.RUNNING and gate.held is None
        if gate.before and not began and not gate.let_in:
            gate.held, gate.let_in = Status.RUNNING, True
            yield from self._stand(gate, "before")
            return
        if gate.held is Status.RUNNING:  # it was made to look so; it has not begun
            gate.held, node.status = None, Status.INVALID
        if gate.forced is not None:
            self._end_as(node, gate.forced)
            yield node
        else:
            yield from gate.tick()
        if node.status is not Status.RUNNING:
            gate.let_in = False
            if gate.after:
                gate.held = node.status
                yield from self._stand(gate, "after")

    def _stand(self, gate: _Gate, where: str) -> Iterator[Behaviour]:
        self.hit = self.hit or f"{where} {gate.node.name}"
        gate.node.status = Status.RUNNING
        yield gate.node

    def _leave(self, gate: _Gate) -> Iterator[Behaviour]:
        ended, gate.held = gate.held, None
        assert ended is not None
        gate.node.status = ended
        yield gate.node

    def _end_as(self, node: Behaviour, status: Status) -> None:
        if node.status is Status.RUNNING:
            node.stop(Status.INVALID)
        node.feedback_message = "forced"
        if status is Status.FAILURE:
            text = "the node was forced to fail, for a test"
            self.context.failures.add(Failure(kind=FailureKind.SKILL_CRASHED, message=text, where=node.name))
        node.status = status
