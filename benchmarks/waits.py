"""What a fetch waits for, node by node, on the robot's clock: in lockstep, the same on every machine.

The rows come in the order in which the nodes first acted. A node's seconds are those of its goals, from the
first status to the last; behind it stands what the skill told that it did meanwhile, and how long of that
nothing on the robot moved. What overlaps is counted by each, so the rows may add up to more than the fetch.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final

from benchmarks.fetch_time import NEAR_THE_TABLE, REQUESTED, WITHIN
from benchmarks.rows import Row
from benchmarks.stillness import moves
from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import Scenario, load_scenario
from tandem.skills.ports.action import GoalStatus, node_of
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES, ODOMETRY, Latest
from tandem.skills.ports.tasks import TASK_STATUS, TaskState

NOTHING: Final = "no goal under way"


@dataclass
class Spent:
    """Robot seconds of one node in one phase."""

    total: float = 0.0
    standing: float = 0.0
    """Of these, nothing on the robot moved."""
    doing: dict[str, float] = field(default_factory=dict)
    """Of these, by what the skill told that it did."""


class Waits:
    """A node that listens: give it all messages of a run.

    Args:
        bus: where the robot is.
    """

    name = "waits"

    def __init__(self, bus: Bus) -> None:
        self._goals = bus.subscribe("skill/*/*/status", depth=4096)
        self._joints = Latest(bus, JOINT_STATES, depth=4096)
        self._odometry = Latest(bus, ODOMETRY, depth=4096)
        self._tasks = Latest(bus, TASK_STATUS, depth=1024)
        self._open: dict[str, GoalStatus] = {}
        self._last: float | None = None
        self._phase = ""
        self.spent: dict[tuple[str, str], Spent] = {}
        """By phase and node, in the order of their first acts."""
        self.phases: dict[str, float] = {}
        """Robot seconds of each phase."""

    def step(self) -> bool:
        """Take in what has arrived."""
        for task in self._tasks.take():
            self._phase = task.progress.phase if task.state is TaskState.RUNNING else ""
        for sample in self._goals.drain():
            status = GoalStatus.model_validate_json(sample.payload)
            if status.state.terminal:
                self._open.pop(status.goal_id, None)
            else:
                self._open[status.goal_id] = status
        self._odometry.refresh()
        for states in self._joints.take():
            self._count(states)
        return False

    def close(self) -> None:
        """Stop listening."""
        for end in (self._goals, self._joints, self._odometry, self._tasks):
            end.close()

    def _count(self, states: JointStates) -> None:
        now, last = states.stamp.seconds, self._last
        self._last = now
        if not self._phase or last is None:
            return
        passed, stands = now - last, not moves(states, self._odometry.value)
        self.phases[self._phase] = self.phases.get(self._phase, 0.0) + passed
        at_work = {node_of(goal): _doing(status) for goal, status in self._open.items()}
        for node, doing in (at_work or {NOTHING: ""}).items():
            spent = self.spent.setdefault((self._phase, node), Spent())
            spent.total += passed
            spent.standing += passed if stands else 0.0
            if doing:
                spent.doing[doing] = spent.doing.get(doing, 0.0) + passed


def _doing(status: GoalStatus) -> str:
    """Return what the skill says that it does, or that it is only being stopped."""
    told = status.feedback or {}
    words = told.get("phase") or status.state
    return str(words).lower().replace("_", " ")


def rows() -> Iterator[Row]:
    """Measure."""
    demo = load_scenario("Demo")
    yield from waits("Demo", demo)
    yield from waits("item in the first view", demo.starting_at(NEAR_THE_TABLE))


def waits(name: str, scenario: Scenario) -> Iterator[Row]:
    """Fetch once, and say what took how long."""
    system = LockstepSystem(scenario, 1)
    try:
        heard = Waits(system.bus)
        caller = Caller(system, lambda _: None, also=heard)
        status = caller.follow(caller.request(REQUESTED).task, within=WITHIN)
        heard.step()
        yield from table(name, heard, status.state.value.lower())
    finally:
        system.close()


def table(name: str, heard: Waits, ended: str) -> Iterator[Row]:
    """Return the rows of what was heard."""
    yield Row(f"waits, {name}", sum(heard.phases.values()), "robot s", note=ended)
    for phase, seconds in heard.phases.items():
        yield Row(f"waits, {name}: {phase}", seconds, "robot s")
        for (within, node), spent in heard.spent.items():
            if within == phase:
                yield Row(f"waits, {name}: {phase}: {node}", spent.total, "robot s", note=_note(spent))


def _note(spent: Spent) -> str:
    parts = [f"{what} {seconds:.2f}" for what, seconds in spent.doing.items()]
    return ", ".join((*parts, f"standing {spent.standing:.2f}"))
