"""Fetches in which something goes wrong: drawn starts, drawn faults, in lockstep with all physics."""

from __future__ import annotations

from typing import Final

import numpy as np

from executive.campaigns.fetch import DEPOT, WARM_UP, free_radius
from executive.campaigns.troubles import Case, Trouble, draw_hopeless, draw_recoverable
from executive.demo import Caller
from executive.systems import LockstepSystem, SystemFailure
from sim.controls import FAULTS
from sim.draw import draw_fetch
from sim.scenario import Scenario
from sim.truth import lies_on
from skills.ports.clocks import robot_seconds
from skills.ports.failure import Failure
from skills.ports.geometry import distance
from skills.ports.keys import JOINT_STATES, Latest
from skills.ports.message import Message
from skills.ports.site import Site
from skills.ports.tasks import Attempt, TaskState
from skills.site import load

TASK_WITHIN: Final = 1200.0
"""Robot seconds (host seconds while the hardware is silent) in which a task must have ended."""
REST: Final = 1.0
"""Robot seconds over which the robot must stand still after the end."""
STILL: Final = 0.01
"""Metres (base) and rad/s (joints) that count as standing still."""


class RecoveryRun(Message):
    """One run. ``right``: it ended as it must, hopeless ones with the right kind; the robot is at rest."""

    run: int
    item: int
    trouble: str
    hopeless: bool
    struck: tuple[str, ...]
    """What went wrong in truth, with the robot's time."""
    state: str
    in_depot: bool
    at_rest: bool
    right: bool
    failure: Failure | None
    tried: tuple[Attempt, ...]
    robot_seconds: float
    digest: str


class RecoveryCampaign(Message):
    """A whole campaign: how many of the recoverable runs and of the hopeless ones were right."""

    scenario: str
    seed: int
    recovered: int
    recoverable: int
    right_kind: int
    hopeless: int
    runs: tuple[RecoveryRun, ...]


def run_recovery(scenario: Scenario, seed: int, run: int) -> RecoveryRun:
    """Draw and run number ``run`` of the recoverable ones; the same numbers give the same run."""
    return _run(scenario, seed, run, hopeless=False)


def run_hopeless(scenario: Scenario, seed: int, run: int) -> RecoveryRun:
    """Draw and run number ``run`` of the hopeless ones."""
    return _run(scenario, seed, run, hopeless=True)


def _run(scenario: Scenario, seed: int, run: int, *, hopeless: bool) -> RecoveryRun:
    site, rng = load(scenario.site), np.random.default_rng((seed, run, int(hopeless)))
    draw = draw_fetch(site, scenario, rng, free_radius())
    case = Case(rng, draw.item, site)
    trouble = draw_hopeless(case, run) if hopeless else draw_recoverable(case)
    struck = draw.scenario.model_copy(update={"faults": trouble.faults})
    system = LockstepSystem(struck, seed * 1000 + run, digest=True, bus_faults=trouble.bus)
    try:
        return _fetch(system, site, run, draw.item, trouble)
    finally:
        system.close()


def _fetch(system: LockstepSystem, site: Site, run: int, item: int, trouble: Trouble) -> RecoveryRun:
    events, caller = Latest(system.bus, FAULTS, depth=1024), Caller(system, _quiet)
    while robot_seconds(system.clocks) < WARM_UP:
        system.advance()
    began = robot_seconds(system.clocks)
    answer = caller.request({"task": "fetch", "item": item, "to": DEPOT})
    failure, tried = None, tuple[Attempt, ...]()
    try:
        status = caller.follow(answer.task, within=TASK_WITHIN)
        state, failure, tried = status.state.value, status.failure, status.tried
    except SystemFailure as error:
        state = f"STUCK: {error}"
    ended = robot_seconds(system.clocks)
    at_rest = _stands_still(system, caller)
    there = _in_depot(caller, site, item)
    if trouble.ends_in:
        ended_well = failure is not None and failure.kind in trouble.ends_in
    else:
        ended_well = there and state == TaskState.SUCCEEDED.value
    return RecoveryRun(
        run=run,
        item=item,
        trouble=trouble.name,
        hopeless=bool(trouble.ends_in),
        struck=tuple(f"{event.stamp.seconds:.2f} s {event.phase}: {event.words}" for event in events.take()),
        state=state,
        in_depot=there,
        at_rest=at_rest,
        right=ended_well and at_rest,
        failure=failure,
        tried=tried,
        robot_seconds=round(ended - began, 2),
        digest=system.digest(),
    )


def _stands_still(system: LockstepSystem, caller: Caller) -> bool:
    """Let a second pass, and say whether base and joints stood still in it."""
    joints = Latest(system.bus, JOINT_STATES, depth=1024)
    before = caller.truth().base_in_map
    for _ in range(round(REST / system.lockstep.period)):
        system.advance()
    moved = distance(before, caller.truth().base_in_map)
    fastest = max((abs(v) for state in joints.take()[-10:] for v in state.velocities), default=0.0)
    joints.close()
    return moved < STILL and fastest < STILL


def _in_depot(caller: Caller, site: Site, item: int) -> bool:
    try:
        return lies_on(caller.truth(), site, item, DEPOT)
    except KeyError:  # somebody took it away
        return False


def _quiet(_: str) -> None:
    """Tell nobody."""
