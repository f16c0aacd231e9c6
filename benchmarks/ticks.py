"""How long one tick of the fetch tree takes, in memory, with mocked skills; and that of an empty tree."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.behaviours import Running, Success
from py_trees.composites import Sequence
from pydantic import JsonValue

from benchmarks.machine import frozen
from benchmarks.rows import Row, quantile, spread
from tandem.executive.render.example import tree_of
from tandem.executive.service.executive import Executive
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.tasks import REQUEST, TASK_CANCEL, TREE, CancelTask
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import Kind, MemoryHub
from tandem.trees.registry import discover

ITEMS: Final = {29: Pose(position=(0.5, 0.5, 0.74), orientation=from_axes((0, -1, 0), (0, 0, 1), (-1, 0, 0)))}
REQUESTED: Final[dict[str, JsonValue]] = {"task": "fetch", "item": 29}
FETCH: Final = json.dumps(REQUESTED).encode()
FETCHES: Final = 20
EMPTY_TICKS: Final = 400


@dataclass
class Times:
    """Seconds by the wall's clock, and of the processor, which others on the machine disturb less."""

    wall: list[float] = field(default_factory=list)
    processor: list[float] = field(default_factory=list)

    def timed(self, call: Callable[[], object]) -> Callable[[], None]:
        """Return ``call`` with a stop-watch."""

        def timed() -> None:
            processor, wall = time.thread_time(), time.perf_counter()
            call()
            self.wall.append(time.perf_counter() - wall)
            self.processor.append(time.thread_time() - processor)

        return timed


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    ticks, steps, goals = fetches(2 if quick else FETCHES)
    yield from spread("tick of the fetch tree", ticks.wall, aim=1.0)
    yield Row("tick of the fetch tree, processor time, p99", 1e3 * quantile(ticks.processor, 0.99), "ms", 1.0)
    note = "tick, tree, messages"
    for which, times in (("", steps.wall), (", processor time", steps.processor)):
        yield Row(f"step of the executive{which}, p99", 1e3 * quantile(times, 0.99), "ms", note=note)
    what, note = (
        "from the executive's wake to a goal's sending, processor time",
        f"of {len(goals)}, bus apart",
    )
    yield Row(f"{what}, median", 1e3 * quantile(goals, 0.5), "ms", note=note)
    yield Row(f"{what}, p99", 1e3 * quantile(goals, 0.99), "ms", 2.0)
    firsts, shown = first_steps(2 if quick else FETCHES)
    note = "request read and checked, tree built, ticked and told"
    for which, times in (("", firsts.wall), (", processor time", firsts.processor)):
        yield Row(f"step that starts a task{which}, median", 1e3 * quantile(times, 0.5), "ms", note=note)
        yield Row(f"step that starts a task{which}, p99", 1e3 * quantile(times, 0.99), "ms")
    what = "step that starts a task, until the tree of the first tick is told, processor time"
    yield Row(f"{what}, median", 1e3 * quantile(shown, 0.5), "ms", note="bus apart")
    yield Row(f"{what}, p99", 1e3 * quantile(shown, 0.99), "ms")
    nodes, empty = empty_ticks(EMPTY_TICKS // (20 if quick else 1))
    note = f"baseline: py_trees alone, {nodes} nodes as in fetch, all of them ticked"
    yield Row("tick of an empty tree, median", 1e3 * quantile(empty.wall, 0.5), "ms", note=note)


def fetches(count: int) -> tuple[Times, Times, list[float]]:
    """Return the times of some fetches' ticks, of the executive's steps, and until each goal is sent."""
    mocked, ticks, steps = Mocked(), Times(), Times()
    sent: list[float] = []
    step = steps.timed(mocked.executive.step)
    began = [0.0]

    def hear(kind: Kind, key: str, _: bytes) -> None:
        if kind == "query" and key.endswith("/goal"):
            sent.append(time.thread_time() - began[0])

    def timed() -> None:
        began[0] = time.thread_time()
        step()

    mocked.client.hub.watch(hear)
    with frozen():
        for _ in range(count):
            mocked.ask()
            began[0] = time.thread_time()
            mocked.executive.step()
            run = mocked.executive.running
            assert run is not None
            _time_ticks(run._root, ticks)  # noqa: SLF001
            mocked.run(timed)
    return ticks, steps, sent


def _time_ticks(root: Behaviour, times: Times) -> None:
    """Have each tick of the tree timed."""
    tick, ticked = root.tick, list[tuple[Behaviour, ...]]()
    timed = times.timed(lambda: ticked.append(tuple(tick())))

    def lazily() -> Iterator[Behaviour]:  # py_trees makes this generator also where it does not tick
        timed()
        yield from ticked.pop()

    root.tick = lazily  # type: ignore[method-assign]


def first_steps(count: int) -> tuple[Times, list[float]]:
    """Return the times of the steps in which requests are taken and their trees ticked for the first time.

    And of each the seconds of the processor until the tree is told.
    """
    mocked, times = Mocked(), Times()
    shown: list[float] = []
    began: list[float] = []

    def hear(kind: Kind, key: str, _: bytes) -> None:
        if began and kind == "put" and key == TREE.key:
            shown.append(time.thread_time() - began.pop())

    mocked.client.hub.watch(hear)
    step = times.timed(mocked.executive.step)
    with frozen():
        for _ in range(count):
            mocked.ask()
            began.append(time.thread_time())
            step()
            TASK_CANCEL.query(mocked.client, CancelTask(task=mocked.executive.book.all()[-1].task))
            mocked.run(mocked.executive.step)
    return times, shown


class Mocked:
    """An executive and a robot of mocked skills on a bus in memory."""

    def __init__(self) -> None:
        """Put them together."""
        hub, self._clocks, site = MemoryHub(), SteppedClocks(), load("lab")
        self._robot = MockRobot(hub.endpoint(), self._clocks, site, items=ITEMS, duration=0.05)
        self.executive = Executive(hub.endpoint(), self._clocks, site, discover())
        self.client = hub.endpoint()

    def ask(self) -> None:
        """Ask for a fetch of an item that was never seen, once the robot has told who and where it is."""
        for _ in range(3):
            self._clocks.advance(0.01)
            self.executive.step()
            self._robot.step()
        forget(self._robot)
        self.client.publish(REQUEST, FETCH)

    def run(self, step: Callable[[], object]) -> None:
        """Go on with ``step`` until nothing is left to do."""
        while not self.executive.idle:
            self._clocks.advance(0.01)
            self._robot.step()
            step()


def empty_ticks(count: int) -> tuple[int, Times]:
    """Return the nodes of the fetch tree, and the times of each tick of as many that do nothing."""
    nodes = sum(1 for _ in tree_of(discover()["fetch"], load("lab"), REQUESTED).walk())
    done: list[Behaviour] = [Success(f"leaf {number}") for number in range(nodes - 2)]
    root = Sequence("root", memory=False, children=[*done, Running("last")])
    times = Times()
    tick = times.timed(root.tick_once)
    for _ in range(count):
        tick()
    return nodes, times


def forget(robot: MockRobot) -> None:
    """Let the item never have been seen nor placed, and tell."""
    version = robot.world.version + 1
    robot.world = robot.world.model_copy(update={"placed": (), "items": (), "version": version})
    robot.tell()
