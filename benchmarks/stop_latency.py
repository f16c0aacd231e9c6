"""How soon a stop and a cancel get through, at drawn moments of fetches, planning included.

All processes in real time. ``hw/stop`` is answered by the hardware once all its parts have begun to brake. A
cancel has reached a skill when its status is CANCELING; a base that moves has been reached when a smaller
velocity is sent to it than the one before. When an arm moves, the time until its joints are first measured
slower is told too: it is longer than what it took to reach the hardware, since joint states come every 10 ms.

What moves has to come to rest within its stated decelerations: in the longest time that one of its speeds
takes at the limit that the description tells. Told is by how much, in robot time, it took longer.
"""

from __future__ import annotations

import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np
import yaml

from benchmarks.fetch_time import NEAR_THE_TABLE, REQUESTED
from benchmarks.processes import free_endpoint
from benchmarks.rows import Row, quantile, spread
from benchmarks.standing import Motion
from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.systems import SystemFailure, wait_for
from tandem.executive.trials.demo import ANSWER_WITHIN, Caller
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.action import GoalState, GoalStatus, node_of
from tandem.skills.ports.hardware import Stop, StopRelease
from tandem.skills.ports.keys import DESCRIPTION, STOP, STOP_RELEASE, Latest, Nothing
from tandem.skills.ports.tasks import TASK_CANCEL, TASK_STATUS, CancelTask, TaskState

TRIALS: Final = 24
"""Of each kind; a third of them while an arm is planned for, a third while something moves."""
LATEST: Final = 2.5
"""Seconds after which a fetch is stopped at the latest; the next one goes on from where the robot is then."""
WITHIN: Final = 6.0
"""Seconds in which a planning or a motion is waited for."""
SPANS: Final = {"moving": 1.0, "planning": 0.05, "any": LATEST}
"""Kinds of moments, and the seconds after their beginning in which they are drawn."""
KINDS: Final = tuple(SPANS)
AIM: Final = 20.0
MOST: Final = 60.0
"""Host seconds after which no more trials are begun."""
MOST_QUICK: Final = 10.0
RESTS_WITHIN: Final = 2.0
"""Seconds in which rest is waited for after a stop."""


@dataclass
class Trial:
    """One stop or cancel; host seconds after it was asked for, None for what did not happen."""

    phase: str
    planning: bool
    goals: str = ""
    """The nodes whose goals were under way, in words."""
    answered: float | None = None
    canceling: float | None = None
    braked: float | None = None
    slower: float | None = None
    ended: float | None = None
    longer: float | None = None
    """Robot seconds from the asking to standing still, beyond those at the stated decelerations."""


@dataclass
class Watch:
    """Listens to what a stop or a cancel brings about."""

    system: ProcessSystem
    motion: Motion
    task: str = ""
    phase: str = ""
    state: TaskState | None = None
    canceling_at: float | None = None
    goals: dict[str, GoalStatus] = field(default_factory=dict)

    def __post_init__(self) -> None:
        bus = self.system.bus
        self._goals = bus.subscribe("skill/*/*/status", depth=1024)
        self._tasks = Latest(bus, TASK_STATUS, depth=1024)

    @property
    def planning(self) -> bool:
        """Whether an arm is being planned for."""
        open_goals = [(goal, each) for goal, each in self.goals.items() if not each.state.terminal]
        return any(
            "survey" in goal or (each.feedback or {}).get("phase") == "PLANNING" for goal, each in open_goals
        )

    @property
    def under_way(self) -> str:
        """The nodes whose goals are under way, in words; of an arm also what it does."""
        open_goals = [(node_of(goal), each) for goal, each in self.goals.items() if not each.state.terminal]
        told = {f"{node} {(each.feedback or {}).get('phase', '')}".strip() for node, each in open_goals}
        return " and ".join(sorted(told)) or "no goal"

    def trial(self) -> Trial:
        """Return a trial that begins now."""
        return Trial(self.phase, planning=self.planning, goals=self.under_way)

    def look(self) -> None:
        """Wait for something, and take in what has come."""
        self.system.advance()
        now = time.perf_counter()
        for sample in self._goals.drain():
            status = GoalStatus.model_validate_json(sample.payload)
            self.goals[status.goal_id] = status
            if status.state is GoalState.CANCELING and self.canceling_at is None:
                self.canceling_at = now
        for told in self._tasks.take():
            if told.task == self.task:
                self.state, self.phase = told.state, told.progress.phase
        self.motion.look(now)

    def until(self, holds: Callable[[], bool], within: float) -> bool:
        """Look until it holds, at most so many seconds."""
        end = time.perf_counter() + within
        while not holds():
            if time.perf_counter() > end:
                return False
            self.look()
        return True

    @property
    def over(self) -> bool:
        """Whether the task has ended."""
        return self.state is not None and self.state.terminal


def rows(*, quick: bool = False) -> Iterator[Row]:
    """Measure."""
    count, most = (2, MOST_QUICK) if quick else (TRIALS, MOST)
    stops, cancels = trials(count, most=most)
    answers = [each.answered for each in stops if each.answered is not None]
    yield from spread("from hw/stop to the hardware's answer", answers, aim=AIM, note=_when(stops), most=True)
    heard = [each.canceling for each in cancels if each.canceling is not None]
    name = "from task/cancel to the skill's CANCELING"
    yield from spread(name, heard, aim=AIM, note=_when(cancels), most=True)
    braked = [each.braked for each in cancels if each.braked is not None]
    name = "from task/cancel to the base's first braking command"
    yield from _some(name, braked, aim=AIM, note="the base moving and not slowing down already")
    for what, done in (("hw/stop", stops), ("task/cancel", cancels)):
        slower = [each.slower for each in done if each.slower is not None]
        note = "an arm moving; joint states come every 10 ms"
        yield from _some(f"from {what} to slower joints", slower, aim=None, note=note)
    for what, done in (("hw/stop", stops), ("task/cancel", cancels)):
        longer = [each.longer for each in done if each.longer is not None]
        name = f"from {what} to standing, beyond v / deceleration"
        yield from _some(name, longer, aim=None, note="moving; robot time")
    ends = [each.ended for each in cancels if each.ended is not None]
    if ends:
        median, most = quantile(ends, 0.5), max(ends)
        yield Row("from task/cancel to the task's end, at rest, median", median, "s", note=f"of {len(ends)}")
        yield Row("from task/cancel to the task's end, at rest, max", most, "s")


def _some(name: str, seconds: list[float], *, aim: float | None, note: str) -> list[Row]:
    """Return the rows of what happened in some trials only; none when it happened in none."""
    return spread(name, seconds, aim=aim, note=note, most=True) if seconds else []


def _when(done: list[Trial]) -> str:
    counts = Counter(each.phase or "start" for each in done)
    phases = ", ".join(f"{phase} {count}" for phase, count in counts.items())
    return f"{sum(each.planning for each in done)} while an arm was planned for; {phases}"


def trials(count: int, *, most: float, seed: int = 1) -> tuple[list[Trial], list[Trial]]:
    """Return so many stops and cancels at drawn moments, or fewer when ``most`` host seconds are over."""
    rng = np.random.default_rng(seed)
    stops: list[Trial] = []
    cancels: list[Trial] = []
    with tempfile.TemporaryDirectory() as folder:
        scenario = Path(folder) / "near.yaml"
        near = load_scenario("Demo").starting_at(NEAR_THE_TABLE)
        scenario.write_text(yaml.safe_dump(near.model_dump(mode="json")), encoding="utf-8")
        options = RunOptions(bus=BusOptions(endpoint=free_endpoint()), scenario=str(scenario))
        spent = 0.0
        while len(stops) + len(cancels) < 2 * count and spent < most:
            with ProcessSystem(options) as system:
                began = time.monotonic()
                _in_one_system(system, stops, cancels, rng, count=count, until=began + most - spent)
                spent += time.monotonic() - began
    return stops, cancels


def _in_one_system(
    system: ProcessSystem,
    stops: list[Trial],
    cancels: list[Trial],
    rng: np.random.Generator,
    *,
    count: int,
    until: float,
) -> None:
    """Stop and cancel until there are enough, or the item is where it was wanted."""
    watch, caller = Watch(system, _motion(system)), Caller(system, lambda _: None)
    while len(stops) + len(cancels) < 2 * count and time.monotonic() < until:
        done, act = (stops, _stop) if len(stops) <= len(cancels) else (cancels, _cancel)
        if _under_way(watch, caller, KINDS[len(done) % len(KINDS)], rng):
            done.append(act(watch))
        elif watch.state is TaskState.SUCCEEDED:
            return


def _motion(system: ProcessSystem) -> Motion:
    payload = wait_for(system, DESCRIPTION.query(system.bus, Nothing()), ANSWER_WITHIN)
    if payload is None:
        raise SystemFailure("the hardware did not tell its description")
    return Motion(system.bus, DESCRIPTION.decode_answer(payload))


def _under_way(watch: Watch, caller: Caller, kind: str, rng: np.random.Generator) -> bool:
    """Ask for a fetch and go on to a moment of that kind; False when the fetch has ended before."""
    watch.state, watch.canceling_at = None, None
    watch.goals.clear()
    watch.task = caller.request(REQUESTED).task
    watch.until(lambda: watch.state is TaskState.RUNNING, ANSWER_WITHIN)
    if kind == "planning":
        watch.until(lambda: watch.over or watch.planning, WITHIN)
    elif kind == "moving":
        watch.until(lambda: watch.over or watch.motion.fast, WITHIN)
    watch.until(lambda: watch.over, float(rng.uniform(0.0, SPANS[kind])))
    return not watch.over


def _stop(watch: Watch) -> Trial:
    trial = watch.trial()
    watch.motion.mark()
    began = time.perf_counter()
    pending = STOP.query(watch.system.bus, Stop(by="benchmark", reason="how soon?"))
    end = began + RESTS_WITHIN
    while (
        not (trial.answered is not None and watch.over and watch.motion.stands) and time.perf_counter() < end
    ):
        watch.look()
        if trial.answered is None and pending.poll() is not None:
            trial.answered = time.perf_counter() - began
    _read(trial, watch, began)
    watch.until(lambda: watch.over, ANSWER_WITHIN)
    wait_for(watch.system, STOP_RELEASE.query(watch.system.bus, StopRelease(by="benchmark")), ANSWER_WITHIN)
    return trial


def _cancel(watch: Watch) -> Trial:
    trial = watch.trial()
    watch.motion.mark()
    began = time.perf_counter()
    TASK_CANCEL.query(watch.system.bus, CancelTask(task=watch.task))
    if watch.until(lambda: watch.over, ANSWER_WITHIN):
        trial.ended = time.perf_counter() - began
    watch.until(lambda: watch.motion.stands, RESTS_WITHIN)
    if watch.canceling_at is not None:
        trial.canceling = watch.canceling_at - began
    _read(trial, watch, began)
    return trial


def _read(trial: Trial, watch: Watch, began: float) -> None:
    motion = watch.motion
    trial.braked = None if motion.braked_at is None else motion.braked_at - began
    trial.slower = None if motion.slower_at is None else motion.slower_at - began
    trial.longer = motion.longer
