"""Random schedules of faults for whole fetches with mocked skills, and what must hold whatever they are."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from py_trees.common import Status

from tandem.executive.trials.exploration.exploring import STEPS_WITHIN, Make, broken, moves_stretched
from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.testing.mock_robot import MockRobot
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.behaviours.act import Act

MOST_FAULTS: Final = 6
"""Of one run."""
LATE: Final = (0.5, 5.0, 30.0)
"""Robot seconds by which an answer may be late."""
CANCEL_WITHIN: Final = 600
"""Ticks in which a cancel may come."""


@dataclass(frozen=True)
class Schedule:
    """What goes wrong in one fetch: faults by leaf and attempt, a drop, a cancel."""

    world: str
    faults: tuple[tuple[str, int, Fault], ...]
    drop_at: str | None
    cancel_at: int | None

    def words(self) -> str:
        """Return it for people."""
        faults = "; ".join(f"{leaf} #{attempt}: {_words(fault)}" for leaf, attempt, fault in self.faults)
        drop = "" if self.drop_at is None else f"; dropped at {self.drop_at}"
        cancel = "" if self.cancel_at is None else f"; cancelled at tick {self.cancel_at}"
        return f"{self.world}: {faults or 'no faults'}{drop}{cancel}"


@dataclass(frozen=True)
class Verdict:
    """How one went: its ticks, and the rules that it broke, in words."""

    ticks: int
    broken: tuple[str, ...]


def draw(worlds: Mapping[str, Make], rng: random.Random) -> Schedule:
    """Draw a schedule; the same generator gives the same one."""
    world = rng.choice(sorted(worlds))
    root = worlds[world]().root
    assert root is not None, "a world starts its task"
    leaves = [node.name for node in root.iterate() if isinstance(node, Act)]
    faults = tuple(
        (rng.choice(leaves), rng.randint(1, 3), _draw_fault(rng)) for _ in range(rng.randint(0, MOST_FAULTS))
    )
    drop_at = rng.choice(leaves) if rng.random() < 0.3 else None  # noqa: PLR2004 - now and then
    cancel_at = rng.randint(1, CANCEL_WITHIN) if rng.random() < 0.3 else None  # noqa: PLR2004 - as above
    return Schedule(world, faults, drop_at, cancel_at)


def run(worlds: Mapping[str, Make], schedule: Schedule) -> Verdict:
    """Run one schedule to its end, and check the rules on the way and after it."""
    bench = worlds[schedule.world]()
    for leaf, attempt, fault in schedule.faults:
        bench.robot.leaf_faults[leaf, attempt] = fault
    if schedule.drop_at is not None:
        bench.events.setdefault(schedule.drop_at, _drop)
    wrong: dict[str, None] = {}
    status, ticks = Status.RUNNING, 0
    while status is Status.RUNNING and ticks < STEPS_WITHIN:
        status = bench.step()
        ticks += 1
        if moves_stretched(bench):
            wrong["base and stretched arm move together"] = None
        if ticks == schedule.cancel_at and status is Status.RUNNING:
            return Verdict(ticks, (*wrong, *_after_cancel(bench)))
    return Verdict(ticks, (*wrong, *broken(bench, status)))


def search(
    worlds: Mapping[str, Make], *, ticks: int, seed: int, tell: Callable[[str], None]
) -> tuple[int, int]:
    """Run drawn schedules for so many ticks; tell each that broke a rule; return runs and broken ones."""
    done, runs, bad = 0, 0, 0
    while done < ticks:
        schedule = draw(worlds, random.Random(f"{seed}/{runs}"))  # noqa: S311 - no secret hangs on it
        verdict = run(worlds, schedule)
        done, runs = done + verdict.ticks, runs + 1
        if verdict.broken:
            bad += 1
            tell(f"{schedule.words()}: {', '.join(verdict.broken)}")
    return runs, bad


def _draw_fault(rng: random.Random) -> Fault:
    kind = rng.choice(["fails", "fails", "fails", "late", "hangs"])
    if kind == "late":
        return Fault(late=rng.choice(LATE))
    if kind == "hangs":
        return Fault(hangs=True)
    failing = [each for each in FailureKind if each is not FailureKind.INVALID_GOAL]
    return Fault(failure=Failure(kind=rng.choice(failing), message="as drawn"))


def _after_cancel(bench: TreeBench) -> tuple[str, ...]:
    at_rest = bench.interrupt()
    held = [
        name
        for name in ("base", "head", *(f"{part}_{side}" for part in ("arm", "gripper") for side in PAIR))
        if bench.context.resources.holder(name) is not None
    ]
    wrong = [] if at_rest and not bench.robot.busy else ["skills are at work after a cancel"]
    return (*wrong, *(f"{name} is held after a cancel" for name in held))


def _drop(robot: MockRobot) -> None:
    for side in PAIR:
        if robot.world.in_hand(side) is not None:
            robot.drop(side)


def _words(fault: Fault) -> str:
    if fault.failure is not None:
        return str(fault.failure.kind)
    return "hangs" if fault.hangs else f"{fault.late:.1f} s late"
