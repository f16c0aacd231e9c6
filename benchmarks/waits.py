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
from benchmarks.listening import Listening
from benchmarks.rows import Row
from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.demo import Caller
from tandem.sim.scenario import Scenario, load_scenario
from tandem.skills.ports.action import GoalStatus, node_of
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.tasks import TaskState, TaskStatus

NOTHING: Final = "no goal under way"


@dataclass
class Spent:
    """Robot seconds of one node in one phase."""

    total: float = 0.0
    standing: float = 0.0
    """Of these, nothing on the robot moved."""
    doing: dict[str, float] = field(default_factory=dict)
    """Of these, by what the skill told that it did."""


class Waits(Listening):
    """See ``Listening`` for the argument."""

    name = "waits"

    def __init__(self, bus: Bus) -> None:
        super().__init__(bus)
        self._phase = ""
        self.spent: dict[tuple[str, str], Spent] = {}
        """By phase and node, in the order of their first acts."""
        self.phases: dict[str, float] = {}
        """Robot seconds of each phase."""

    def on_task(self, status: TaskStatus) -> None:
        """Take in the phase."""
        self._phase = status.progress.phase if status.state is TaskState.RUNNING else ""

    def on_passed(self, seconds: float, now: float, *, moving: bool) -> None:
        """Count the seconds for the phase, and for each node at work."""
        del now
        if not self._phase:
            return
        self.phases[self._phase] = self.phases.get(self._phase, 0.0) + seconds
        at_work = {node_of(goal): _doing(status) for goal, (_, status) in self.open.items()}
        for node, doing in (at_work or {NOTHING: ""}).items():
            spent = self.spent.setdefault((self._phase, node), Spent())
            spent.total += seconds
            spent.standing += 0.0 if moving else seconds
            if doing:
                spent.doing[doing] = spent.doing.get(doing, 0.0) + seconds


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
