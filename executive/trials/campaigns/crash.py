"""Kill -9 at random and at each point, start again, and count what is lost, done twice, or stuck."""

from __future__ import annotations

import random
import signal
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from pydantic import JsonValue

from tandem.executive.trials.campaigns.crash_rig import CrashRig, StuckError, Victim
from tandem.executive.trials.campaigns.crash_world import ITEM, deeds, wrong_deeds
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import AskHistory, TaskState, TaskStatus

REQUESTS: Final = 3
"""Of each run: one fetch that moves the robot, and two that find the item there."""
KILLS: Final = 3
"""At the most, in a run."""
WITHIN: Final = 2.5
"""Host seconds after the first request in which kills are drawn; most of a run."""
STUCK_AFTER: Final = 60.0
"""Host seconds."""
TRIES: Final = 3
"""Runs in which a point must be reached once: what is heard when depends on the moment."""
VICTIMS: Final[tuple[Victim, ...]] = ("executive", "executive", "executive", "mock", "mock", "all")


class Kill(Message):
    """One kill: whom, and when."""

    victim: str
    after: float
    """Host seconds after the run's beginning."""


class CrashRun(Message):
    """One run, and what was wrong with it: nothing, as a rule."""

    run: int
    point: str = ""
    """The point at which the executive was to kill itself; empty in a run with random kills.

    A run that never came there is wrong: it has shown nothing.
    """
    kills: tuple[Kill, ...] = ()
    states: tuple[str, ...] = ()
    begun: int = 0
    """How often the tree of the first task began."""
    seconds: float = 0.0
    wrong: tuple[str, ...] = ()


class CrashCampaign(Message):
    """All of it, for the report."""

    seed: int
    right: int
    runs: tuple[CrashRun, ...]


@dataclass(eq=False)
class Reaper:
    """Kills when the time has come, and starts again what has died."""

    rig: CrashRig
    kills: list[Kill]
    began: float
    done: list[Kill] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)
    """Deaths that nobody asked for."""

    def step(self) -> None:
        """Kill who is to be killed now; start again who has died."""
        while self.kills and self.rig.now() - self.began >= self.kills[0].after:
            kill = self.kills.pop(0)
            self.done.append(kill)
            victim: Victim = (
                "all" if kill.victim == "all" else "mock" if kill.victim == "mock" else "executive"
            )
            self.rig.kill(victim)
            self.rig.start(*(("router", "mock", "executive") if victim == "all" else (victim,)))
        code = self.rig.exit_code("executive")
        if code is not None:  # at its point
            if code == -signal.SIGKILL:
                self.done.append(Kill(victim="executive", after=round(self.rig.now() - self.began, 3)))
            else:
                words = self.rig.last_words("executive")
                self.wrong.append(f"the executive ended by itself, with {code}: {words}")
            self.rig.bury("executive")
            self.rig.start("executive")


def random_kills(seed: int, run: int) -> list[Kill]:
    """Return the kills of a run, in order."""
    draw = random.Random(f"{seed}/{run}")  # noqa: S311 - no secret
    made = [
        Kill(victim=draw.choice(VICTIMS), after=round(draw.uniform(0.0, WITHIN), 3))
        for _ in range(draw.randint(1, KILLS))
    ]
    return sorted(made, key=lambda kill: kill.after)


def crash_runs(folder: Path, endpoint: str, runs: int, seed: int, *, first: int = 0) -> Iterator[CrashRun]:
    """Yield runs with random kills, one after the other in one system with one ledger."""
    with CrashRig(folder, endpoint) as rig:
        for run in range(first, first + runs):
            yield one_run(rig, run, random_kills(seed, run))


def crash_points(folder: Path, endpoint: str) -> tuple[str, ...]:
    """Return the names of the points that a run passes, in the order in which it first passes them."""
    log = folder / "points.txt"
    with CrashRig(folder, endpoint) as rig:
        rig.kill("executive")
        rig.start("executive", crash_log=log)
        one_run(rig, 0, [])
    return tuple(log.read_text("utf-8").splitlines())


def point_runs(folder: Path, endpoint: str, points: tuple[str, ...]) -> Iterator[CrashRun]:
    """Yield a run for each point, at which the executive kills itself once.

    A run that does not come to its point is made anew, ``TRIES`` times in all; then it is wrong.
    """
    with CrashRig(folder, endpoint) as rig:
        for run, point in enumerate(points):
            yield point_run(rig, run, point)


def point_run(rig: CrashRig, run: int, point: str, *, tries: int = TRIES) -> CrashRun:
    """Return the first run in which the executive came to its point, or the last one of those tried."""
    made = CrashRun(run=run, point=point)
    for number in range(tries):
        rig.kill("executive")
        rig.start("executive", crash_at=point)
        made = one_run(rig, run, [], point=point, client=f"{point}-{run}-{number}")
        if made.kills or made.wrong != (never_reached(point),):
            break
    return made


def never_reached(point: str) -> str:
    """Return what is wrong with a run that did not come to its point."""
    return f"'{point}' was never reached: nobody was killed"


def one_run(rig: CrashRig, run: int, kills: list[Kill], *, point: str = "", client: str = "") -> CrashRun:
    """Ask for three tasks, kill meanwhile, and look at what came of it.

    While nobody has been killed, nor is to be by the clock, a fourth follows when the three have ended.

    Args:
        rig: the processes; the executive kills itself at the ``point``, if there is one.
        run: its number.
        kills: in order.
        point: where the executive must have killed itself.
        client: begins the ids of the requests; each run needs its own.
    """
    ids = client or f"run-{run}"
    rig.reset()
    before = len(deeds(rig.folder))
    began = rig.now()
    reaper = Reaper(rig, kills, began)
    tasks: dict[str, str] = {}
    wrong: list[str] = []
    found: tuple[TaskStatus, ...] = ()
    try:
        for number in range(REQUESTS):
            _ask(rig, reaper, f"{ids}-{number}"[-60:], tasks, wrong)
        found = _await_ends(rig, reaper, tuple(tasks.values()))
        if not kills and not reaper.done:  # some points need a request with nothing before it
            _ask(rig, reaper, f"{ids}-idle"[-60:], tasks, wrong)
            found = _await_ends(rig, reaper, tuple(tasks.values()))
    except StuckError as stuck:
        wrong.append(str(stuck))
    ends = {status.task: status.ended_at for status in found}
    wrong += [f"{task} was acknowledged and is lost" for task in tasks.values() if task not in ends]
    wrong += [
        f"{each.task} ended as {each.state}: {each.failure}"
        for each in found
        if each.state is not TaskState.SUCCEEDED
    ]
    wrong += wrong_deeds(deeds(rig.folder)[before:], ends.get)
    wrong += reaper.wrong
    if point and not reaper.done:
        wrong.append(never_reached(point))
    return CrashRun(
        run=run,
        point=point,
        kills=tuple(reaper.done),
        states=tuple(str(each.state) for each in found),
        begun=max((each.begun for each in found), default=0),
        seconds=round(rig.now() - began, 2),
        wrong=tuple(wrong),
    )


def _ask(rig: CrashRig, reaper: Reaper, client_id: str, tasks: dict[str, str], wrong: list[str]) -> None:
    document: dict[str, JsonValue] = {"task": "fetch", "item": ITEM, "id": client_id}
    answer = rig.request(document, meanwhile=reaper.step)
    again = rig.request(document, meanwhile=reaper.step)
    if not answer.accepted or answer != again:
        wrong.append(f"{client_id} was answered {answer}, and then {again}")
    tasks[client_id] = answer.task


def _await_ends(rig: CrashRig, reaper: Reaper, tasks: tuple[str, ...]) -> tuple[TaskStatus, ...]:
    end = rig.now() + STUCK_AFTER
    while rig.now() < end:
        found = tuple(status for task in tasks for status in _of(rig, reaper.step, task))
        if not reaper.kills and len(found) == len(tasks) and all(each.state.terminal for each in found):
            return found
        rig.bus.waker.wait(0.05)
        reaper.step()
    raise StuckError(f"{', '.join(tasks)} had not ended {STUCK_AFTER:.0f} s after the requests")


def _of(rig: CrashRig, meanwhile: Callable[[], None], task: str) -> tuple[TaskStatus, ...]:
    return rig.tasks(AskHistory(task=task), meanwhile=meanwhile)
