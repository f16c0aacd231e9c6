"""Draws, timelines, tables and figures of the experiments, without a simulation."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET

import numpy as np
import pytest

from tandem.executive.trials.experiments.draws import APART, draw_run, scenario_of
from tandem.executive.trials.experiments.figures import Flat, figure, from_above, in_space
from tandem.executive.trials.experiments.mover import Moved
from tandem.executive.trials.experiments.run import ArmRun, ExperimentRun
from tandem.executive.trials.experiments.settings import FARTHEST, LEAST, REGIONS, Kind, Options
from tandem.executive.trials.experiments.tables import picked, tables
from tandem.executive.trials.experiments.witness import Touch
from tandem.skills.ports.message import Vector3

KINDS: tuple[Kind, ...] = ("uncoordinated", "crossing", "coordinated")


@pytest.mark.parametrize("kind", KINDS)
def test_each_thing_is_moved_far_enough_within_its_region(kind: Kind) -> None:
    for run in range(30):
        draw = draw_run(kind, "field", run, np.random.default_rng((1, run)))
        for step, region in zip(draw.steps, REGIONS[kind], strict=True):
            for to in step.to:
                assert LEAST <= math.hypot(to.x - step.start.x, to.y - step.start.y) <= FARTHEST
                assert region.x[0] <= to.x <= region.x[1]
                assert region.y[0] <= to.y <= region.y[1]
        firsts = [step.to[0] for step in draw.steps]
        if len(firsts) > 1:
            assert math.hypot(firsts[0].x - firsts[1].x, firsts[0].y - firsts[1].y) >= APART


def test_the_same_numbers_draw_the_same_and_positions_take_turns() -> None:
    draws = [draw_run("uncoordinated", "grasp", run, np.random.default_rng((1, run))) for run in range(3)]
    assert [draw.position for draw in draws] == [1, 2, 3]
    assert draws[2] == draw_run("uncoordinated", "grasp", 2, np.random.default_rng((1, 2)))
    placed = scenario_of("uncoordinated", draws[0]).item(29)
    assert (placed.x, placed.y) == (draws[0].steps[0].start.x, draws[0].steps[0].start.y)


def run_of(number: int, *, left: bool, right: bool, offset: Vector3 | None = None) -> ExperimentRun:
    arms = [
        ArmRun(apf=True, rrtconnect=pick, pick=pick, apf_s=2.0, pick_s=3.0, home_s=1.0, offset=offset)
        for pick in (left, right)
    ]
    return ExperimentRun(
        run=number,
        position=1,
        state="SUCCEEDED",
        failure=None,
        moved=(
            Moved(
                item=29, to=draw_run("crossing", "field", 0, np.random.default_rng(1)).steps[0].start, at=1.0
            ),
        ),
        touches=(),
        left=arms[0].model_copy(update={"path": ((0.4, 0.3, 1.0), (0.6, 0.2, 0.8))}),
        right=arms[1],
        total_s=10.0 + number,
        stops=number,
    )


def test_the_rows_stand_beside_the_thesis_s() -> None:
    runs = [run_of(0, left=True, right=True), run_of(1, left=True, right=False)]
    shown = dict(tables(Options(kind="crossing"), runs))
    assert ("SR pick right", "1/2", "58/60") in shown["Table 5.4: success rates"]
    assert ("total time", "10.50", "238.74") in shown["Table 5.5: times (robot s)"]
    assert ("stops by the coordination", "1", "-") in shown["besides"]
    assert picked(runs) == 1


def test_contacts_are_counted_by_what_was_touched() -> None:
    others = ("right arm", "table", "what is in the right hand", "what is in the right hand")
    touches = tuple(Touch(first="left arm", second=each, at=1.0) for each in others)
    run = run_of(0, left=True, right=True).model_copy(update={"touches": touches})
    rows = {row[0]: row[1] for row in dict(tables(Options(kind="crossing"), [run]))["besides"]}
    assert [rows[f"contacts {what}"] for what in ("arm with arm", "arm with table")] == ["1", "1"]
    assert rows["contacts with what the other holds"] == "2"


def test_the_offset_is_told_signed_and_as_a_distance() -> None:
    runs = [run_of(n, left=True, right=True, offset=(x, 0.0, 0.004)) for n, x in enumerate((0.003, -0.003))]
    rows = {
        row[0]: row[1:]
        for row in dict(tables(Options(kind="coordinated"), runs))["Table 5.7: grasping offset (m)"]
    }
    assert rows["signed mean left"] == ("0.00000", "0.00088")
    assert rows["deviation left"] == ("0.00300", "0.06419")
    assert rows["mean distance right"] == ("0.00500", "-")


@pytest.mark.parametrize("flat", [from_above, in_space])
def test_the_figures_are_whole_svg_with_a_line_for_each_hand(flat: Flat) -> None:
    root = ET.fromstring(figure("paths", [run_of(0, left=True, right=True)], flat))  # noqa: S314 - our own
    assert len(root.findall("{http://www.w3.org/2000/svg}polyline")) == 2
