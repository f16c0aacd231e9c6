"""How soon a stop and a cancel get through, at random moments of fetches, planning included.

All processes in real time. ``hw/stop`` is answered by the hardware once all its parts have begun to brake; a
cancel has reached a skill when its status is CANCELING. When a trajectory was being followed, the time until
the joints are first measured slower is told too; joint states come every 10 ms.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

import numpy as np
import yaml

from benchmarks.fetch_time import NEAR_THE_TABLE, REQUESTED
from benchmarks.processes import free_endpoint
from benchmarks.rows import Row, quantile, spread
from benchmarks.stillness import speed
from executive.demo import ANSWER_WITHIN, Caller
from executive.options import BusOptions, RunOptions
from executive.systems import ProcessSystem, wait_for
from sim.scenario import load_scenario
from skills.ports.action import GoalState, GoalStatus
from skills.ports.hardware import Stop
from skills.ports.keys import JOINT_STATES, STOP, STOP_RELEASE, Latest, Nothing
from skills.ports.tasks import TASK_CANCEL, TASK_STATUS, CancelTask, TaskState

TRIALS: Final = 24
"""Of each kind; every other one while an arm is planned for."""
LATEST: Final = 8.0
"""Seconds of a fetch in which the other moments lie: survey, drive, looks and the first motions of an arm."""
PLANNED_WITHIN: Final = 15.0
"""Seconds in which a planning is waited for."""
AIM: Final = 20.0
MOST: Final = 300.0
"""Host seconds after which no more trials are begun."""
MOVING: Final = 0.2
"""rad/s from which a joint is followed to see it slow down."""


@dataclass
class Trial:
    """One stop or cancel; seconds after it was asked for, None for what did not happen."""

    planning: bool
    answered: float | None = None
    canceling: float | None = None
    slower: float | None = None
    ended: float | None = None


@dataclass
class Watch:
    """Listens to what a stop or a cancel brings about."""

    system: ProcessSystem
    task: str = ""
    state: TaskState | None = None
    speed: float = 0.0
    canceling_at: float | None = None
    goals: dict[str, GoalStatus] = field(default_factory=dict)

    def __post_init__(self) -> None:
        bus = self.system.bus
        self._goals = bus.subscribe("skill/*/*/status", depth=1024)
        self._joints = Latest(bus, JOINT_STATES, depth=1024)
        self._tasks = Latest(bus, TASK_STATUS, depth=1024)

    @property
    def planning(self) -> bool:
        """Whether an arm is being planned for."""
        open_goals = [(goal, each) for goal, each in self.goals.items() if not each.state.terminal]
        return any(
            "survey" in goal or (each.feedback or {}).get("phase") == "PLANNING" for goal, each in open_goals
        )

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
                self.state = told.state
        states = self._joints.refresh()
        self.speed = 0.0 if states is None else speed(states)

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
    count = 2 if quick else TRIALS
    stops, cancels = trials(count, latest=3.0 if quick else LATEST)
    for what, done in (("stop", stops), ("cancel", cancels)):
        during = f"{sum(each.planning for each in done)} of them while an arm was planned for"
        slower = [each.slower for each in done if each.slower is not None]
        if what == "stop":
            answers = [each.answered for each in done if each.answered is not None]
            yield from spread(
                "from hw/stop to the hardware's answer", answers, aim=AIM, note=during, most=True
            )
        else:
            heard = [each.canceling for each in done if each.canceling is not None]
            name = "from task/cancel to the skill's CANCELING"
            yield from spread(name, heard, aim=AIM, note=during, most=True)
        note = f"of {len(slower)}, an arm moving; joint states come every 10 ms"
        yield Row(f"from a {what} to slower joints, median", 1e3 * quantile(slower, 0.5), "ms", note=note)
        yield Row(f"from a {what} to slower joints, max", 1e3 * max(slower, default=float("nan")), "ms")
    rest = [each.ended for each in cancels if each.ended is not None]
    yield Row("from task/cancel to the task's end, at rest, max", max(rest, default=float("nan")), "s")


def trials(count: int, *, latest: float, seed: int = 1) -> tuple[list[Trial], list[Trial]]:
    """Return so many stops and cancels, at moments drawn from the first ``latest`` seconds of fetches."""
    rng = np.random.default_rng(seed)
    stops: list[Trial] = []
    cancels: list[Trial] = []
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        scenario = Path(folder) / "near.yaml"
        near = load_scenario("Demo").starting_at(NEAR_THE_TABLE)
        scenario.write_text(yaml.safe_dump(near.model_dump(mode="json")), encoding="utf-8")
        options = RunOptions(bus=BusOptions(endpoint=free_endpoint()), scenario=str(scenario))
        with ProcessSystem(options) as system:
            watch = Watch(system)
            caller = Caller(system, lambda _: None)
            while len(stops) + len(cancels) < 2 * count and time.monotonic() - began < MOST:
                done, act = (stops, _stop) if len(stops) <= len(cancels) else (cancels, _cancel)
                planning = len(done) % 2 == 1
                seconds = float(rng.uniform(0.0, 0.05) if planning else rng.uniform(0.05, latest))
                if _under_way(watch, caller, seconds, planning=planning):
                    done.append(act(watch))
    return stops, cancels


def _under_way(watch: Watch, caller: Caller, seconds: float, *, planning: bool) -> bool:
    """Ask for a fetch and go on so long, or so long after an arm is planned for; False when it has ended."""
    watch.state, watch.canceling_at = None, None
    watch.goals.clear()
    watch.task = caller.request(REQUESTED).task
    watch.until(lambda: watch.state is TaskState.RUNNING, ANSWER_WITHIN)
    if planning:
        watch.until(lambda: watch.over or watch.planning, PLANNED_WITHIN)
    watch.until(lambda: watch.over, seconds)
    return not watch.over


def _stop(watch: Watch) -> Trial:
    trial, before = Trial(planning=watch.planning), watch.speed
    began = time.perf_counter()
    pending = STOP.query(watch.system.bus, Stop(by="benchmark", reason="how soon?"))
    end = began + 1.0
    while (trial.answered is None or trial.slower is None) and time.perf_counter() < end:
        watch.look()
        now = time.perf_counter() - began
        if trial.answered is None and pending.poll() is not None:
            trial.answered = now
        _slower(trial, watch, before, now)
    watch.until(lambda: watch.over, ANSWER_WITHIN)
    wait_for(watch.system, STOP_RELEASE.query(watch.system.bus, Nothing()), ANSWER_WITHIN)
    return trial


def _cancel(watch: Watch) -> Trial:
    trial, before = Trial(planning=watch.planning), watch.speed
    began = time.perf_counter()
    TASK_CANCEL.query(watch.system.bus, CancelTask(task=watch.task))
    while not watch.over and time.perf_counter() < began + ANSWER_WITHIN:
        watch.look()
        now = time.perf_counter() - began
        if trial.canceling is None and watch.canceling_at is not None:
            trial.canceling = watch.canceling_at - began
        _slower(trial, watch, before, now)
    trial.ended = time.perf_counter() - began if watch.over else None
    return trial


def _slower(trial: Trial, watch: Watch, before: float, now: float) -> None:
    if trial.slower is None and before > MOVING and watch.speed < 0.98 * before:
        trial.slower = now
