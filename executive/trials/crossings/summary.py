"""What a series of crossings came to, in lines."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from statistics import median
from typing import Final

from tandem.executive.trials.crossings.settings import CrossingOptions, CrossingRun, Drive, What

WORDS: Final[dict[What, str]] = {
    "crossing": "among people",
    "alone": "the same without people",
    "today": "among people, planner pursuit",
}


def summary(options: CrossingOptions, runs: Sequence[CrossingRun]) -> list[str]:
    """Return the lines. Spreads are smallest, median and largest."""
    people = sum(run.people for run in runs)
    lines = [f"crossings, planner {options.planner}, seed {options.seed}: {len(runs)} runs, {people} people"]
    for what, words in WORDS.items():
        drives = [drive for run in runs if (drive := run.of(what)) is not None]
        if drives:
            lines += _lines(words, drives, people=what != "alone")
    seen = [drive.seen for run in runs for drive in run.drives if drive.what != "today"]
    minutes = sum(each.lasted for each in seen) / 60.0
    in_view, missed = sum(each.in_view for each in seen), sum(each.missed for each in seen)
    false = sum(each.false_people for each in seen)
    share = 100.0 * missed / in_view if in_view else 0.0
    return [
        *lines,
        "tracker, with and without people:",
        f"  false people: {false} in {minutes:.1f} min, {false / max(minutes, 1e-9):.2f} a minute",
        f"  missed: {missed:.1f} of {in_view:.1f} person seconds in view, {share:.1f} %",
    ]


def _lines(words: str, drives: Sequence[Drive], *, people: bool) -> list[str]:
    ended = Counter(drive.state if drive.failure is None else f"{drive.failure.kind}" for drive in drives)
    counts = ", ".join(f"{state} {count}" for state, count in sorted(ended.items()))
    total = sum(drive.lasted for drive in drives)
    lines = [f"{words}:", f"  ended: {counts}"]
    if people:
        caused = sum(len(drive.caused) for drive in drives)
        stood = sum(len(drive.touches) for drive in drives) - caused
        near = sum(drive.near for drive in drives)
        lines += [
            f"  contacts: {caused} while the robot moved or had stood < 1 s, {stood} with a standing robot",
            f"  within 1.0 m of a person: {near:.1f} s of {total:.1f} s",
            f"  nearest, between the axes (m): {_spread([drive.nearest for drive in drives])}",
        ]
    return [*lines, f"  robot seconds: {_spread([drive.lasted for drive in drives])}, {total:.1f} in all"]


def _spread(values: Sequence[float]) -> str:
    return f"{min(values):.3g} / {median(values):.3g} / {max(values):.3g}"
