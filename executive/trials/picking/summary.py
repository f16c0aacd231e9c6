"""What a series of fetches came to, in lines: how long the paper's phases and the arm's steps took."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from statistics import median
from types import MappingProxyType
from typing import Final

from tandem.executive.trials.picking.phases import STEPS, is_turn
from tandem.executive.trials.picking.settings import Phase, PickingOptions, PickingRun

PHASES: Final = MappingProxyType(
    {
        Phase.REQUEST: "request taken up (III-A.1)",
        Phase.SEARCH: "search (III-A.2)",
        Phase.APPROACH: "base to the item (III-A.3)",
        Phase.PICK: "pick (III-D.1)",
        Phase.CARRY: "base to the depot (III-A.3)",
        Phase.PLACE: "place (III-D.2)",
        Phase.HOME: "home (IV-B)",
        Phase.RECOVERY: "recovery (III-A.4)",
    }
)
"""What a phase is called, and where the paper tells it."""


def summary(options: PickingOptions, runs: Sequence[PickingRun]) -> list[str]:
    """Return the lines: times are of the runs that brought the item."""
    brought = [run for run in runs if run.state == "SUCCEEDED"]
    failing = ", the arm fails at first" if options.arm_fails else ""
    lines = [
        f"{options.scenario}{failing}, seed {options.seed}: {len(runs)} fetches",
        f"  right: {sum(run.right for run in runs)} of {len(runs)}",
    ]
    if not brought:
        return lines
    searched = [run for run in brought if _turns(run)]
    return [
        *lines,
        f"  the item was in view at once in {len(brought) - len(searched)} of {len(brought)}",
        "  robot seconds                 median    least     most   runs",
        *(_row(name, [run.phases[phase] for run in brought]) for phase, name in PHASES.items()),
        _row("in all", [run.lasted for run in brought]),
        *_steps(brought),
    ]


def _steps(runs: Sequence[PickingRun]) -> Iterator[str]:
    for node, where in STEPS.items():
        lengths = [
            each.end - each.begin
            for run in runs
            for each in run.stretches
            if each.node == node and each.ended_well
        ]
        if lengths:
            yield _row(f"{node} ({where})", lengths)


def _turns(run: PickingRun) -> int:
    return sum(is_turn(each) for each in run.stretches)


def _row(name: str, values: Sequence[float]) -> str:
    return f"  {name:<28} {median(values):8.1f} {min(values):8.1f} {max(values):8.1f} {len(values):6d}"
