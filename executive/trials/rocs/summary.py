"""What a series of runs came to, in lines."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from statistics import median

from tandem.executive.trials.rocs.run import RocsRun
from tandem.executive.trials.rocs.settings import RocsOptions


def summary(options: RocsOptions, runs: Sequence[RocsRun]) -> list[str]:
    """Return the lines. Spreads are smallest, median and largest."""
    reached = sum(each.reached for each in runs)
    bumps = [bump for run in runs for bump in run.bumps]
    stood = sum(bump.stood for bump in bumps)
    unseen = sum(bump.unseen and not bump.stood for bump in bumps)
    caused = sum(bump.caused for bump in bumps)
    ended = Counter(run.state for run in runs)
    failed = Counter(str(run.failure.kind) for run in runs if run.failure is not None)
    offs = [run.off_goal for run in runs if run.state == "SUCCEEDED"]
    lines = [
        f"EXP{options.case}, route {options.route}{_source(options)}, seed {options.seed}: {len(runs)} runs",
        f"  as aimed at, having caused no contact: {reached} of {len(runs)}",
        f"  ended: {_counts(ended)}" + (f"; failures: {_counts(failed)}" if failed else ""),
        f"  places not visited: {sum(run.missed for run in runs)}",
        f"  contacts: {caused} caused, {stood} while it had stood for 1 s, {unseen} where no sensor looks",
    ]
    kept = [run.kept for run in runs if run.kept is not None]
    if kept:
        lines.append(f"  share of time at 0.9 to 1.8 m: {_spread(kept)}")
    if offs:
        lines.append(f"  off the goal, or the last corner: {_spread(offs)} m")
    return [
        *lines,
        f"  robot seconds: {_spread([run.lasted for run in runs])}",
        f"  share of time on the reactive route: {_spread([run.reactive for run in runs])}",
        f"  new plans in a run: {_spread([float(run.replans) for run in runs])}",
    ]


def _source(options: RocsOptions) -> str:
    return f", by {options.source}" if options.case == 3 else ""  # noqa: PLR2004 - EXP3 alone has a follower


def _counts(of: Counter[str]) -> str:
    return ", ".join(f"{what} {count}" for what, count in sorted(of.items()))


def _spread(values: Sequence[float]) -> str:
    return f"{min(values):.3g} / {median(values):.3g} / {max(values):.3g}"
