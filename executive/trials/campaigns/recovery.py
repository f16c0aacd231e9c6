"""Fetches in which something goes wrong: drawn starts, drawn faults, in lockstep with all physics."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.executive.system.systems import LockstepSystem
from tandem.executive.trials.campaigns.fetch import DEPOT, description_of, draw_run
from tandem.executive.trials.campaigns.oracle import Oracle, Verdict
from tandem.executive.trials.campaigns.reachable import Reachable
from tandem.executive.trials.campaigns.recording import UNRECORDED, Runs
from tandem.executive.trials.campaigns.troubles import Case, Trouble, draw_hopeless, draw_recoverable
from tandem.executive.trials.trial import trial, warm_up
from tandem.sim.controls import FAULTS
from tandem.sim.scenario import Scenario
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import Attempt
from tandem.skills.site import load

if TYPE_CHECKING:
    from collections.abc import Iterable

    from tandem.sim.faults import Fault, FaultEvent

TASK_WITHIN: Final = 1200.0
"""Robot seconds (host seconds while the hardware is silent) in which a task must have ended."""


class RecoveryRun(Message):
    """One run. ``right``: every fault struck, it ended as it must, and nothing is ``wrong`` in truth.

    A run that can be mended must end as a fetch without any fault must (``FetchRun``); but what falls out of
    the hand by a fault may push other things. A hopeless one must end with the right kind, at rest, and leave
    the room as it was.
    """

    run: int
    item: int
    trouble: str
    hopeless: bool
    struck: tuple[str, ...]
    """What went wrong in truth, with the robot's time."""
    unstruck: tuple[str, ...]
    """Faults that never struck, or were refused: the run has shown nothing about them."""
    state: str
    wrong: tuple[str, ...]
    """What the ground truth contradicts: see ``executive.trials.campaigns.oracle``."""
    right: bool
    failure: Failure | None
    tried: tuple[Attempt, ...]
    robot_seconds: float
    digest: str


class RecoveryCampaign(Message):
    """A whole campaign: how many of the recoverable runs and of the hopeless ones were right.

    ``unstruck``: runs in which a drawn fault never struck. They count as not right.
    """

    scenario: str
    seed: int
    recovered: int
    recoverable: int
    right_kind: int
    hopeless: int
    unstruck: int
    runs: tuple[RecoveryRun, ...]


def run_recovery(scenario: Scenario, seed: int, run: int, *, runs: Runs = UNRECORDED) -> RecoveryRun:
    """Draw and run number ``run`` of the recoverable ones; the same numbers give the same run.

    ``runs`` makes its system: one that is recorded, for instance.
    """
    return _run(scenario, seed, run, runs, hopeless=False)


def run_hopeless(scenario: Scenario, seed: int, run: int, *, runs: Runs = UNRECORDED) -> RecoveryRun:
    """Draw and run number ``run`` of the hopeless ones."""
    return _run(scenario, seed, run, runs, hopeless=True)


def _run(scenario: Scenario, seed: int, run: int, runs: Runs, *, hopeless: bool) -> RecoveryRun:
    site, rng = load(scenario.site), np.random.default_rng((seed, run, int(hopeless)))
    draw, robot = draw_run(site, scenario, rng), description_of(scenario)
    case = Case(rng, draw.item, site, robot, draw.scenario, Reachable(robot, site).why_not)
    trouble = draw_hopeless(case, run) if hopeless else draw_recoverable(case)
    struck = draw.scenario.model_copy(update={"faults": trouble.faults})
    system = runs.system(struck, seed * 1000 + run, run, trouble.bus)
    try:
        return _fetch(system, site, run, draw.item, trouble)
    finally:
        system.close()


def _fetch(system: LockstepSystem, site: Site, run: int, item: int, trouble: Trouble) -> RecoveryRun:
    events = Latest(system.bus, FAULTS, depth=1024)
    oracle = Oracle(system, site, item, DEPOT)
    warm_up(system)
    made = trial(system, {"task": "fetch", "item": item, "to": DEPOT}, within=TASK_WITHIN)
    digest, told, failure = system.digest(), events.take(), made.failure
    missed = unstruck(trouble.faults, told)
    wrong = wrong_in(oracle.verdict(), hopeless=bool(trouble.ends_in))
    if trouble.ends_in:
        ended_well = failure is not None and failure.reason.kind in trouble.ends_in
    else:
        ended_well = made.succeeded
    return RecoveryRun(
        run=run,
        item=item,
        trouble=trouble.name,
        hopeless=bool(trouble.ends_in),
        struck=tuple(f"{event.stamp.seconds:.2f} s {event.phase}: {event.words}" for event in told),
        unstruck=missed,
        state=made.state,
        wrong=wrong,
        right=ended_well and not missed and not wrong,
        failure=failure,
        tried=() if made.status is None else made.status.tried,
        robot_seconds=made.lasted,
        digest=digest,
    )


def unstruck(faults: tuple[Fault, ...], told: Iterable[FaultEvent]) -> tuple[str, ...]:
    """Return the faults that never began, by the sim's own account, in words."""
    began = {event.number for event in told if event.phase == "began"}
    return tuple(
        f"{fault.kind} ({_when(fault)})" for number, fault in enumerate(faults) if number not in began
    )


def wrong_in(verdict: Verdict, *, hopeless: bool) -> tuple[str, ...]:
    """Return what of a verdict counts here.

    What a fault alone did to the room is not the robot's doing. A robot that nothing helps can't bring the
    item, and need not get home.
    """
    if hopeless:
        return verdict.disturbed + verdict.restless
    return verdict.misplaced + verdict.disturbed + verdict.not_home + verdict.restless


def _when(fault: Fault) -> str:
    if fault.when is None:
        return f"at {fault.at or 0.0:g} s"
    return f"{fault.when.event}, time {fault.when.nth}, {fault.when.after:g} s after it"


def _quiet(_: str) -> None:
    """Tell nobody."""
