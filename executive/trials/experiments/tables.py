"""The rows of the two-arm thesis's tables 5.1 to 5.7 from runs, beside its figures."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator, Sequence
from typing import Final

from tandem.executive.trials.experiments.run import ArmRun, ExperimentRun
from tandem.executive.trials.experiments.settings import Options
from tandem.executive.trials.experiments.thesis import OFFSETS, ROWS, SUCCESS, TIME_ROWS, TIMES

NONE: Final = "-"
Row = tuple[str, str, str]
"""What, ours, the thesis's."""


def tables(options: Options, runs: Sequence[ExperimentRun]) -> Iterator[tuple[str, tuple[Row, ...]]]:
    """Yield each table: its title and its rows."""
    numbers = {"uncoordinated": (1, 2, 3), "crossing": (4,), "coordinated": (6,)}[options.kind]
    for position, number in enumerate(numbers, start=1):
        here = [run for run in runs if run.position == position]
        if here:
            yield f"Table 5.{number}: success rates", _success(options, position, here)
    if options.kind == "crossing":
        yield "Table 5.5: times (robot s)", _times(options, runs)
    if options.kind == "coordinated":
        yield "Table 5.7: grasping offset (m)", _offsets(options, runs)
    yield "besides", _besides(runs)


def picked(runs: Sequence[ExperimentRun]) -> int:
    """Return how many runs were right in both arms, in truth."""
    return sum(run.left.pick and run.right.pick for run in runs)


def _success(options: Options, position: int, runs: Sequence[ExperimentRun]) -> tuple[Row, ...]:
    column = options.method
    if options.kind == "crossing":
        told = SUCCESS.get((options.kind, 1, "sequential" if options.sequential else "dual"))
    else:
        told = SUCCESS.get((options.kind, position, column))
    of: tuple[Callable[[ArmRun], bool | None], ...] = (
        lambda arm: arm.apf,
        lambda arm: arm.rrtconnect,
        lambda arm: arm.pick,
    )
    ours = [_rate([what(run.arms[side]) for run in runs]) for what in of for side in (0, 1)]
    return tuple(zip(ROWS, ours, told or (NONE,) * len(ROWS), strict=True))


def _rate(values: Sequence[bool | None]) -> str:
    asked = [value for value in values if value is not None]
    return f"{sum(asked)}/{len(asked)}" if asked else NONE


def _times(options: Options, runs: Sequence[ExperimentRun]) -> tuple[Row, ...]:
    told = TIMES["sequential" if options.sequential else "dual"]
    of: tuple[Callable[[ArmRun], float | None], ...] = (
        lambda arm: arm.apf_s,
        lambda arm: arm.pick_s,
        lambda arm: arm.home_s,
    )
    ours = [_mean([what(run.arms[side]) for run in runs]) for side in (0, 1) for what in of]
    ours.append(_mean([run.total_s for run in runs]))
    return tuple(zip(TIME_ROWS, ours, (f"{value:.2f}" for value in told), strict=True))


def _mean(values: Sequence[float | None]) -> str:
    there = [value for value in values if value is not None]
    return f"{statistics.fmean(there):.2f}" if there else NONE


def _offsets(options: Options, runs: Sequence[ExperimentRun]) -> tuple[Row, ...]:
    told = OFFSETS.get(options.method)
    rows: list[Row] = []
    for number, side in enumerate(("left", "right")):
        offsets = [run.arms[number].offset for run in runs]
        along = [each[0] for each in offsets if each is not None]
        away = sorted((each[0] ** 2 + each[2] ** 2) ** 0.5 for each in offsets if each is not None)
        signed = NONE if told is None else f"{told[number][0]:.5f}"
        spread = NONE if told is None else f"{told[number][1]:.5f}"
        if not away:
            rows.append((f"offset {side}", NONE, signed))
            continue
        rows += [
            (f"signed mean {side}", f"{statistics.fmean(along):.5f}", signed),
            (f"deviation {side}", f"{statistics.pstdev(along):.5f}", spread),
            (f"mean distance {side}", f"{statistics.fmean(away):.5f}", NONE),
            (f"p95 of the distance {side}", f"{away[max(0, round(0.95 * len(away)) - 1)]:.5f}", NONE),
        ]
    return tuple(rows)


def _besides(runs: Sequence[ExperimentRun]) -> tuple[Row, ...]:
    touches = [touch for run in runs for touch in run.touches]
    arms = sum(touch.second == "right arm" for touch in touches)
    table = sum(touch.second == "table" for touch in touches)
    return (
        ("whole routine (s)", _mean([run.total_s for run in runs]), NONE),
        ("stops by the coordination", str(sum(run.stops for run in runs)), NONE),
        ("items followed at the grasp", str(sum(arm.follows for run in runs for arm in run.arms)), NONE),
        ("contacts arm with arm", str(arms), NONE),
        ("contacts arm with table", str(table), NONE),
        ("contacts with what the other holds", str(len(touches) - arms - table), NONE),
        ("cubes picked as they lay", str(sum(arm.lying for run in runs for arm in run.arms)), NONE),
        ("largest tilt (rad)", f"{max((run.tilt for run in runs), default=0.0):.4f}", NONE),
    )
