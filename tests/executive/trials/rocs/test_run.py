"""Runs of the RoCS experiments: with physics, each case once; what is drawn, and what is judged."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.executive.trials.rocs.draws import APART, draw
from tandem.executive.trials.rocs.figures import figure
from tandem.executive.trials.rocs.run import Bump, Point, RocsRun, missed, run_rocs
from tandem.executive.trials.rocs.settings import Case, RocsOptions
from tandem.executive.trials.rocs.summary import summary


@pytest.mark.lockstep
def test_the_pioneer_reaches_the_origin_by_both_routes_and_touches_nothing() -> None:
    run = run_rocs(RocsOptions(case=1), 0)
    assert run.state == "SUCCEEDED"
    assert run.off_goal is not None
    assert run.off_goal <= 0.15
    assert run.bumps == ()
    assert run.replans >= 1
    assert {each.reactive for each in run.paths["r2"]} == {False, True}
    assert math.dist(*((p.x, p.y) for p in (run.paths["r1"][0], run.paths["r1"][-1]))) > 0.1, "R1 moves"
    drawn = figure(run, "EXP1")
    assert drawn.count("<rect") > 5
    assert "reactive" in drawn


@pytest.mark.lockstep
def test_the_summit_goes_there_with_the_same_tree_and_stays() -> None:
    run = run_rocs(RocsOptions(case=2), 2)
    assert run.reached
    assert run.lasted > 20.0
    assert run.off_goal is not None
    assert run.off_goal <= 0.15


@pytest.mark.lockstep
def test_the_summit_follows_the_pioneer_along_the_corners() -> None:
    run = run_rocs(RocsOptions(case=3), 4)
    assert run.state == "SUCCEEDED"
    assert run.kept is not None
    assert run.kept >= 0.9
    assert run.missed == 0
    assert run.caused == ()
    assert set(run.paths) == {"r1", "r2", "r3"}


@pytest.mark.lockstep
def test_by_reflexes_alone_it_gets_there_without_a_task() -> None:
    run = run_rocs(RocsOptions(case=1, route="reactive"), 1)
    assert run.reached
    assert run.reactive > 0.9


@pytest.mark.parametrize("case", [1, 2])
def test_draws_differ_keep_their_distance_and_are_the_same_for_the_same_seed(case: Case) -> None:
    draws = [draw(case, np.random.default_rng((1, run))) for run in range(30)]
    assert draws[3] == draw(case, np.random.default_rng((1, 3)))
    assert len({each.model_dump_json() for each in draws}) == len(draws)
    for each in draws:
        one, other = (robot.start for robot in each.robots)
        assert math.hypot(one.x - other.x, one.y - other.y) >= APART
        assert [robot.drives for robot in each.robots] == ["executive", "wander"]
        assert len(each.obstacles) == 2


def bump(*, stood: bool = False, unseen: bool = False) -> Bump:
    return Bump(robot="r2", what="near_box", at=1.0, force=5.0, stood=stood, unseen=unseen)


def made(*bumps: Bump, off: float = 0.1, state: str = "SUCCEEDED") -> RocsRun:
    return RocsRun(
        run=0,
        state=state,
        failure=None,
        lasted=10.0,
        off_goal=off,
        bumps=bumps,
        replans=1,
        reactive=0.25,
        paths={"r2": (Point(at=0.0, x=0.0, y=0.0, reactive=False),)},
    )


def test_a_follower_keeps_near_for_most_of_the_time_and_who_leads_leaves_no_corner_out() -> None:
    assert made().model_copy(update={"kept": 0.9}).reached
    assert not made().model_copy(update={"kept": 0.89}).reached
    assert not made().model_copy(update={"kept": 0.9, "missed": 1}).reached


@pytest.mark.parametrize(
    ("visited", "count"),
    [
        ([(0.0, 0.0), (1.0, 0.1), (1.1, 1.0)], 0),
        ([(0.0, 0.0), (1.1, 1.0), (1.0, 0.1)], 1),
        ([(0.0, 0.0), (1.0, 0.2), (1.1, 1.0)], 1),
        ([(0.5, 0.5)], 2),
    ],
)
def test_a_place_counts_when_its_turn_has_come(visited: list[tuple[float, float]], count: int) -> None:
    path = [Point(at=0.1 * k, x=x, y=y, reactive=False) for k, (x, y) in enumerate(visited)]
    assert missed(path, [(1.0, 0.0), (1.0, 1.0)]) == count


JUDGED = [
    (made(), True),
    (made(off=0.16), False),
    (made(state="FAILED"), False),
    (made(bump()), False),
    (made(bump(stood=True)), True),
    (made(bump(unseen=True)), True),
]


@pytest.mark.parametrize(("run", "reached"), JUDGED)
def test_a_run_is_right_at_the_goal_without_a_contact_that_it_caused(run: RocsRun, *, reached: bool) -> None:
    assert run.reached == reached


def test_the_summary_counts_contacts_by_who_is_to_blame() -> None:
    lines = summary(RocsOptions(case=1), [run for run, _ in JUDGED])
    assert "  as aimed at, having caused no contact: 3 of 6" in lines
    assert "  contacts: 1 caused, 1 while it had stood for 1 s, 1 where no sensor looks" in lines
