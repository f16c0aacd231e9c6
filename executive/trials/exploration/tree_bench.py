"""Run a task's tree against mocked skills: a whole fetch in milliseconds, each branch at will.

bench = TreeBench(load_site("lab"), items={29: tag_in_map})
bench.robot.faults("base/drive")[1] = Fault(failure=...)
status = bench.run("fetch", {"item": 29})
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence
from pydantic import JsonValue

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import Site
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tandem.trees.breakpoints import Breakpoints
from tandem.trees.clients import Clients
from tandem.trees.context import TreeContext
from tandem.trees.knowledge import Knowledge
from tandem.trees.registry import discover
from tandem.trees.task import TaskType

STEP = 0.01
"""Robot seconds of a period, unless another one is asked for."""
OWNER = "executive"


class TreeBench:
    """A tree, mocked skills, a bus in memory and a clock that only ``step`` moves."""

    def __init__(
        self,
        site: Site,
        *,
        items: dict[int, Pose],
        seen_at_look: int = 1,
        duration: float = 0.0,
        localised: bool = False,
        step: float = STEP,
    ) -> None:
        """See ``MockRobot`` for the arguments."""
        self._site = site
        self.clocks = SteppedClocks("bench")
        self.hub = MemoryHub()
        bus = MemoryBus(self.hub)
        bus.announce(OWNER)
        self.robot = MockRobot(
            MemoryBus(self.hub),
            self.clocks,
            site,
            items=items,
            seen_at_look=seen_at_look,
            duration=duration,
            localised=localised,
            ends=lambda: MemoryBus(self.hub),
        )
        self._knowledge = Knowledge(bus, self.clocks, site)
        self._clients = Clients(bus, self.clocks, OWNER)
        self._runs, self._step = 0, step
        self.context = self._new_context()
        self.kind: TaskType[Message] | None = None
        self.root: Behaviour | None = None
        self.gates = Breakpoints(Sequence("no task", memory=True), self.context)
        """Breakpoints and forced nodes of the tree that was started last."""
        self.visited: list[tuple[str, Status]] = []
        """What each node became when it was ticked, in order: RUNNING once, INVALID when interrupted."""
        self.events: dict[str, Callable[[MockRobot], None]] = {}
        """What happens to the robot each time a node begins to run, by the node's name."""
        self._running: dict[Behaviour, None] = {}

    def start(self, task: str | TaskType[Any], request: dict[str, object]) -> Behaviour:
        """Build a task's tree for a request document and return its root.

        Args:
            task: its name, or its ``TASK``, which need not be registered.
            request: the document, without ``task``.
        """
        self.kind = kind = discover()[task] if isinstance(task, str) else task
        named = {"task": kind.name} if "task" in kind.request.model_fields else {}
        self.context = self._new_context()
        self.visited, self._running = [], {}
        asked = kind.request.model_validate({**named, **request}, context=self._site)
        self.root = kind.tree(asked, self.context)
        self.gates = Breakpoints(self.root, self.context)
        return self.root

    def hold(self, node: str, *, before: bool = True) -> None:
        """Have the tree held before or behind a node.

        ``gates.hit`` says when it is, ``gates.release`` lets it go on.

        KeyError for a name that no node, or more than one, has.
        """
        self.gates.hold(self._node(node), before=before)

    def force(self, node: str, status: Status | None) -> None:
        """Have a node end with a status instead of working; None lets it work again."""
        self.gates.force(self._node(node), status)

    def _node(self, name: str) -> Behaviour:
        found = self.gates.find(name)
        if isinstance(found, str):
            raise KeyError(found)
        return found

    def step(self) -> Status:
        """Let one period pass: skills, then one tick of the tree; return the root's status."""
        assert self.root is not None, "start a task first"
        self.clocks.advance(self._step)
        self.robot.step()
        self.context.poll()
        begun: list[str] = []
        for node in self.root.tick():
            if node.status is not Status.RUNNING or node not in self._running:
                self.visited.append((node.name, node.status))
            if node.status is Status.RUNNING:
                if node not in self._running:
                    begun.append(node.name)
                self._running[node] = None
            else:
                self._running.pop(node, None)
        self._note_interrupted()
        for name in begun:
            if name in self.events:
                self.events[name](self.robot)
        return self.root.status

    def running_leaves(self) -> list[Behaviour]:
        """Return the leaves that are RUNNING."""
        return [node for node in self._running if not node.children and node.status is Status.RUNNING]

    def run(self, task: str | TaskType[Any], request: dict[str, object], *, steps: int = 5000) -> Status:
        """Start the task and step until it ends, at most ``steps`` times."""
        self.start(task, request)
        status = Status.RUNNING
        for _ in range(steps):
            status = self.step()
            if status is not Status.RUNNING:
                break
        return status

    @property
    def about_items(self) -> bool:
        """Whether the request that was started names items."""
        return self.kind is not None and bool({"item", "left", "right"} & set(self.kind.request.model_fields))

    @property
    def ends_anywhere(self) -> bool:
        """Whether the task that was started does not end at home: one on wheels ends where it was sent."""
        return self.kind is not None and self.kind.needs.place

    def result(self) -> dict[str, JsonValue] | None:
        """Return what the task tells as its result, checked as the executive checks it."""
        assert self.kind is not None, "start a task first"
        succeeded = self.root is not None and self.root.status is Status.SUCCESS
        return self.kind.result_of(self.context, succeeded=succeeded)

    def interrupt(self, *, steps: int = 1000) -> bool:
        """Stop the tree as a cancel does; return whether all skills came to rest within ``steps``."""
        assert self.root is not None, "start a task first"
        self.root.stop(Status.INVALID)
        self._note_interrupted()
        for _ in range(steps):
            if self.context.quiet:
                return True
            self.clocks.advance(self._step)
            self.robot.step()
            self.context.poll()
        return False

    def failure(self) -> Failure | None:
        """Return why the task failed, and where everything is, as the executive tells it."""
        failure = self.context.failures.summary()
        return None if failure is None else self.context.with_places(failure)

    def path(self) -> tuple[str, ...]:
        """Return the leaves' names in the order in which they first succeeded or failed."""
        assert self.root is not None, "start a task first"
        leaves = {node.name for node in self.root.iterate() if not node.children}
        ended = (name for name, status in self.visited if status in {Status.SUCCESS, Status.FAILURE})
        return tuple(name for name in ended if name in leaves)

    def _note_interrupted(self) -> None:
        for node in [each for each in self._running if each.status is Status.INVALID]:
            self.visited.append((node.name, Status.INVALID))
            del self._running[node]

    def _new_context(self) -> TreeContext:
        self._runs += 1
        return TreeContext(f"bench-{self._runs:04d}", self._clients, self._knowledge, self.clocks)
