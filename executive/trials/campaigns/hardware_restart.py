"""Kill the hardware under live skills, at rest and in each phase of a fetch; the next fetch must succeed.

All runs are in one system, whose skills and executive live on over every boot. Simulated hardware that is
started again begins at its scenario's start, so what was believed of items and hands is found out anew.
"""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.systems import SystemFailure, wait_for
from tandem.executive.trials.demo import truth_of
from tandem.executive.trials.experiments.timeline import Timeline
from tandem.executive.trials.trial import Trial, trial, warm_up
from tandem.sim.controls import RESET, ResetRequest
from tandem.sim.scenario import load_scenario
from tandem.sim.truth import Truth, lies_on
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import TaskState
from tandem.skills.site import load

SCENARIO: Final = "Demo"
INTERRUPTED: Final = 29
"""The item of the fetch during which the hardware is killed."""
NEXT: Final = 42
"""The item of the fetch after it."""
DEPOT: Final = "depot"
TASK_WITHIN: Final = 600.0
"""Robot seconds for a fetch: several times what the slowest one takes."""
SETTLED_AFTER: Final = 2.0
"""Robot seconds in which each node has told its state several times."""
BACK_WITHIN: Final = 60.0
"""Host seconds in which killed hardware must be heard again: what processes have for their start."""
MOMENTS: Final[tuple[str, ...]] = (
    "",
    "localise",
    "look here",
    "drive to item",
    "pre-grasp",
    "grasp",
    "drive to slot",
    "place above",
    "put down",
    "home: drive",
)
"""The leaves in which it is killed, in a fetch's order; nothing: at rest."""


class RestartRun(Message):
    """One kill, and what came after it."""

    run: int
    leaf: str
    """In which it was killed; nothing: at rest."""
    killed_at: float | None
    """Robot seconds since the system's start; None: the leaf never ran."""
    back_after: float = 0.0
    """Host seconds from the kill until a new boot was heard."""
    interrupted: str = ""
    """How the fetch ended during which it was killed."""
    kind: FailureKind | None = None
    state: str = ""
    """How the next one ended."""
    wrong: tuple[str, ...] = ()


class RestartCampaign(Message):
    """All of it, for the report."""

    seed: int
    right: int
    runs: tuple[RestartRun, ...]


def restart_runs(
    folder: Path, endpoint: str, runs: int, seed: int, *, first: int = 0, speed: float | None = None
) -> Iterator[RestartRun]:
    """Yield runs; they go through the moments in turn.

    Unless given, the ``speed`` is as fast as the processes follow: on a busy machine real time lets the
    renderer fall behind, and a fetch then fails for want of pictures, whatever was killed.
    """
    options = RunOptions(
        bus=BusOptions(endpoint=endpoint, site="restart"),
        scenario=SCENARIO,
        seed=seed,
        speed=speed,
        data=folder,
    )
    with ProcessSystem(options) as system:
        for run in range(first, first + runs):
            if run != first:
                _reset(system, seed + run)
            _settle(system)
            yield _one_run(system, run, MOMENTS[run % len(MOMENTS)])


def _reset(system: ProcessSystem, seed: int) -> None:
    """Have all begin where the scenario has it: a new boot of hardware that lives."""
    if wait_for(system, RESET.query(system.bus, ResetRequest(seed=seed), timeout=10.0), 10.0) is None:
        raise SystemFailure("the sim was not reset")


def _settle(system: ProcessSystem) -> None:
    """Let the skills live through some seconds of this boot, so that there is something to lose."""
    warm_up(system, SETTLED_AFTER)


def _one_run(system: ProcessSystem, run: int, leaf: str) -> RestartRun:
    killer = Killer(system, leaf)
    site, wrong = load(load_scenario(SCENARIO).site), list[str]()
    interrupted, kind, state = "", None, ""
    try:
        if leaf:
            first = _fetched(system, INTERRUPTED, killer)
            interrupted = first.state
            kind = None if first.failure is None else first.failure.kind
            if killer.killed_at is None:
                wrong.append(f"'{leaf}' never ran: nothing was killed")
        else:
            killer.kill()
        killer.await_boot()
        state = _fetched(system, NEXT, killer).state
        wrong += _wrong(truth_of(system), site, interrupted, state)
    except SystemFailure as stuck:
        wrong.append(str(stuck))
    finally:
        killer.close()
    return RestartRun(
        run=run,
        leaf=leaf,
        killed_at=killer.killed_at,
        back_after=round(killer.back_after or 0.0, 1),
        interrupted=interrupted,
        kind=kind,
        state=state,
        wrong=tuple(wrong),
    )


def _fetched(system: ProcessSystem, item: int, killer: Killer) -> Trial:
    made = trial(system, {"task": "fetch", "item": item, "to": DEPOT}, within=TASK_WITHIN, also=killer)
    if made.status is None:
        raise SystemFailure(made.stuck)
    return made


def _wrong(truth: Truth, site: Site, interrupted: str, state: str) -> Iterator[str]:
    """Yield what is not as it was told, in truth."""
    if state != TaskState.SUCCEEDED.value:
        yield f"the next fetch ended as {state}"
    elif not lies_on(truth, site, NEXT, DEPOT):
        yield f"item {NEXT} does not lie in the {DEPOT}"
    if interrupted == TaskState.SUCCEEDED.value and not lies_on(truth, site, INTERRUPTED, DEPOT):
        yield f"item {INTERRUPTED} does not lie in the {DEPOT}, although its fetch succeeded"


@dataclass(eq=False)
class Killer:
    """Kills the hardware once, when a leaf runs; a ``Node`` that is stepped along.

    Args:
        system: whose hardware.
        leaf: its name.
    """

    system: ProcessSystem
    leaf: str
    killed_at: float | None = None
    """Robot seconds since the system's start."""
    back_after: float | None = None
    """Host seconds until a new boot was heard."""
    name: Final = "killer"

    def __post_init__(self) -> None:
        """Listen."""
        self._timeline = Timeline(self.system.bus, self.system.clocks)
        self._boot: str | None = None
        self._killed_on_host = 0.0

    def step(self) -> bool:
        """Take in what was told; kill when the time has come."""
        self._timeline.step()
        if self.killed_at is None and self.leaf and self._timeline.of(self.leaf):
            self.kill()
        self._note_boot()
        return False

    def kill(self) -> None:
        """End the hardware's process at once."""
        clocks = self.system.clocks
        now = clocks.robot()
        self._boot, self.killed_at = None if now is None else now.boot, round(clocks.passed(), 2)
        self._killed_on_host = clocks.monotonic()
        os.kill(self.system.pids()["hardware"], signal.SIGKILL)

    def await_boot(self) -> None:
        """Let the system go on until the hardware is heard again.

        Raises:
            SystemFailure: when it is not.
        """
        while self.killed_at is not None and self.back_after is None:
            self.system.advance()
            self._note_boot()
            if self.system.clocks.monotonic() - self._killed_on_host > BACK_WITHIN:
                raise SystemFailure(f"the hardware was not back within {BACK_WITHIN:.0f} s")

    def close(self) -> None:
        """Stop listening."""
        self._timeline.close()

    def _note_boot(self) -> None:
        now = self.system.clocks.robot()
        if (
            self.killed_at is not None
            and self.back_after is None
            and now is not None
            and now.boot != self._boot
        ):
            self.back_after = self.system.clocks.monotonic() - self._killed_on_host


def _quiet(_: str) -> None:
    """Tell nobody."""
