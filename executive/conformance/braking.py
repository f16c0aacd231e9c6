"""The moving clause about the stop."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Steps
from tandem.executive.conformance.motions import REST, back, ended, fastest, go, small_motion, start
from tandem.executive.conformance.stops import release, set_stop, then_released
from tandem.executive.conformance.streams import drive, stands
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import MotionState

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.hardware import TrajectoryGoal

VELOCITY: Final = keys.BASE_VELOCITY.key
STRETCHED: Final = 4.0
"""How many times slower a motion is that the stop is to interrupt."""
RESTS_WITHIN: Final = 1.0
"""Robot seconds in which slow motions brake."""


def _brakes(bench: Bench) -> Steps:
    motions = [small_motion(bench, group) for group in bench.robot.groups]
    goals: list[TrajectoryGoal] = []
    for motion in motions:
        goal = yield from start(bench, motion, motion.takes * STRETCHED)
        goals.append(goal)
    if bench.robot.drive is None:
        yield from bench.pause(1.0)
    else:
        driven = bench.robot.driven
        yield from drive(bench, min(0.1, driven.forward / 2.0), 0.0, 1.0)
    yield from set_stop(bench)
    for motion, goal in zip(motions, goals, strict=True):
        status = yield from ended(bench, motion, goal, RESTS_WITHIN)
        if status.state is not MotionState.ABORTED:
            raise Broken(f"the stopped goal of {motion.group.name} ABORTED", f"{status.state}")
        if (quick := fastest(bench, motion.group)) > REST:
            raise Broken(f"{motion.group.name} at rest after a stop", f"{quick:.3f} rad/s or m/s")
    if bench.robot.drive is not None:
        yield from bench.pause(RESTS_WITHIN)
        yield from drive(bench, 0.1, 0.0, 0.5)
        if (yield from stands(bench)) is not None:
            raise Broken(f"a base that stands while the stop is set, whatever comes on {VELOCITY}", "motion")
    yield from release(bench)
    for motion in motions:
        yield from go(bench, back(bench, motion))


CLAUSES: Final = (
    Clause(
        "stop_brakes",
        "A stop during motions brings groups and base to rest and keeps them there; goals end ABORTED.",
        "interface.md#hardware",
        then_released(_brakes),
        moving=True,
        interrupts=True,
    ),
)
