"""Go to: it gets there, gives way to reflexes and plans again, and says so when it does not get through."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.ports.actions.base import GoGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.site import load
from tandem.skills.testing.mock_base import FOR_EVER, MockReflex
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.testing.mock_skill import Fault
from tandem.trees.course import NAME, OVERRIDES, CourseNotes
from tandem.trees.subtrees.travel import FREE_WITHIN
from tandem.trees.tasks.go_to import TASK, GoToRequest, GoToResult

SITE = load("lab")
ROOT = Path(__file__).parents[2]
PLACE = {"x": -1.2, "y": 0.5}
AWAY = math.hypot(PLACE["x"], PLACE["y"])


def bench(reflex: MockReflex | None = None) -> TreeBench:
    made = TreeBench(SITE, items={}, localised=True, step=0.05)
    made.robot.wheels.reflex = reflex or MockReflex()
    return made


def result(run: TreeBench) -> GoToResult:
    return GoToResult.model_validate(run.result())


def calls(run: TreeBench) -> list[str]:
    return [name for name, _ in run.robot.calls]


def test_it_goes_there_and_ends_on_arrival() -> None:
    run = bench()
    assert run.run("go_to", PLACE) is Status.SUCCESS
    told = result(run)
    assert (told.position_error, told.overridden, told.replans) == (0.0, 0, 0)
    assert (told.base_in_map.x, told.base_in_map.y) == (PLACE["x"], PLACE["y"])
    (goal,) = [each for _, each in run.robot.calls]
    assert isinstance(goal, GoGoal)
    assert (goal.x, goal.y, goal.yaw) == (-1.2, 0.5, None)
    assert goal.position_tolerance < 0.15, "noise at the end must not put it outside"


def test_one_that_is_there_sends_no_goal() -> None:
    run = bench()
    assert run.run("go_to", {"x": 0.05, "y": 0.0}) is Status.SUCCESS
    assert calls(run) == []


def test_a_heading_that_is_asked_for_is_turned_to() -> None:
    run = bench()
    assert run.run("go_to", {"x": 0.0, "y": 0.0, "yaw": 1.5}) is Status.SUCCESS
    assert result(run).base_in_map.yaw == 1.5


@pytest.mark.parametrize("times", [1, 3, OVERRIDES - 1])
def test_after_each_reflex_it_waits_until_the_base_is_free_and_goes_on(times: int) -> None:
    run = bench(MockReflex(times=times, holds=2.0))
    assert run.run("go_to", PLACE) is Status.SUCCESS
    told = result(run)
    assert (told.overridden, told.replans, told.reflexes) == (times, times, {"avoid_collision": times})
    assert told.reactive == pytest.approx(2.0 * times, rel=0.2)
    assert calls(run) == ["base/go"] * (times + 1), "it never asks while the reflex has the base"


def test_a_base_that_tells_nothing_of_its_reflex_is_asked_again_after_a_moment() -> None:
    run = bench(MockReflex(times=1, holds=5.0, tells=False))
    assert run.run("go_to", PLACE) is Status.SUCCESS
    assert result(run).overridden == 1
    assert len(calls(run)) <= 6


def test_it_cannot_be_starved() -> None:
    run = bench(MockReflex(times=FOR_EVER))
    assert run.run("go_to", PLACE) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert failure.kind is FailureKind.OVERRIDDEN
    assert f"{OVERRIDES} times (avoid_collision {OVERRIDES})" in failure.message
    assert f"{AWAY:.2f} m from (-1.20, 0.50) m" in failure.message
    assert failure.evidence["nearest_m"] == pytest.approx(AWAY, abs=1e-3)
    assert "robot_is" in failure.evidence
    assert len(calls(run)) == OVERRIDES, "nothing above tries again what was given up"
    assert result(run).overridden == OVERRIDES


def test_progress_resets_the_count() -> None:
    run = bench(MockReflex(times=3 * OVERRIDES, gains=0.06))
    assert run.run("go_to", {"x": 2.0, "y": -1.5}) is Status.SUCCESS
    assert result(run).overridden > OVERRIDES


def test_a_reflex_that_keeps_the_base_ends_it() -> None:
    run = bench(MockReflex(times=1, holds=10 * FREE_WITHIN))
    assert run.run("go_to", PLACE) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert failure.kind is FailureKind.OVERRIDDEN
    assert failure.message == "waits: reflex avoid_collision has the base: something is 0.25 m ahead"
    assert calls(run) == ["base/go"]


def test_while_it_waits_the_tree_says_for_which_reflex() -> None:
    run = bench(MockReflex(times=1, holds=5.0))
    run.start("go_to", PLACE)
    for _ in range(40):
        run.step()
    (leaf,) = run.running_leaves()
    assert leaf.feedback_message == "waits: reflex avoid_collision has the base: something is 0.25 m ahead"


def test_what_the_skill_does_is_shown_the_outermost_action_first() -> None:
    run = bench()
    run.robot.leaf_faults["go"] = Fault(hangs=True)
    run.start("go_to", PLACE)
    for _ in range(10):
        run.step()
    (leaf,) = run.running_leaves()
    assert leaf.feedback_message.startswith("running: GoTo > TurnTo, remaining")


@pytest.mark.parametrize(
    ("kind", "tries"),
    [(FailureKind.HARDWARE_STOPPED, 1), (FailureKind.LASER_SILENT, 5), (FailureKind.BASE_BLOCKED, 4)],
)
def test_other_failures_are_answered_by_their_kind(kind: FailureKind, tries: int) -> None:
    run = bench()
    run.robot.leaf_faults["go"] = Fault(failure=Failure(kind=kind, message="as planned"))
    assert run.run("go_to", PLACE) is Status.FAILURE
    failure = run.failure()
    assert failure is not None
    assert (failure.kind, len(calls(run))) == (kind, tries)


def test_a_reflex_that_braked_since_the_stop_is_set_does_not_count_as_giving_way() -> None:
    stopped = Failure(kind=FailureKind.HARDWARE_STOPPED, message="stopped by an operator")
    run = bench(MockReflex(times=FOR_EVER, name="base_guard", why=stopped))
    assert run.run("go_to", PLACE) is Status.FAILURE
    assert calls(run) == ["base/go"]


def test_it_holds_its_place_and_goes_back_when_it_was_pushed_away() -> None:
    run = bench(MockReflex(holds=1.0))
    run.start("go_to", {**PLACE, "stay": 10.0})
    while run.step() is Status.RUNNING:
        if run.clocks.robot().seconds == pytest.approx(5.0):
            run.robot.wheels.shove(0.6, 0.0)
    told = result(run)
    assert run.root is not None
    assert run.root.status is Status.SUCCESS
    assert (told.returns, calls(run)) == (1, ["base/go"] * 2)
    assert told.position_error < 0.15
    assert told.reactive == pytest.approx(1.0, abs=0.2)
    assert 10.0 < run.clocks.robot().seconds < 13.0


def test_counts_outlive_a_restart() -> None:
    run = bench(MockReflex(times=1))
    run.start("go_to", PLACE)
    run.context.notes.keep(NAME, CourseNotes(overridden=4, reactive=3.0, reflexes={"bumper": 4}))
    while run.step() is Status.RUNNING:
        pass
    told = result(run)
    assert (told.overridden, told.reflexes) == (5, {"bumper": 4, "avoid_collision": 1})
    assert told.reactive > 3.0


def test_a_robot_with_a_laser_and_no_pose_sensor_takes_a_planned_way() -> None:
    run = bench()
    run.robot.description = mock_description().model_copy(update={"pose_sensors": ()})
    assert run.run("go_to", PLACE) is Status.SUCCESS
    assert calls(run) == ["base/drive"]


def test_a_robot_that_knows_not_where_it_is_finds_out() -> None:
    run = bench()
    run.robot.localised = False
    assert run.run("go_to", PLACE) is Status.SUCCESS
    assert calls(run) == ["base/localise", "base/go"]


@pytest.mark.parametrize(
    ("x", "y", "wrong"), [(0.0, 0.0, ()), (99.0, 0.0, ("x",)), (99.0, -99.0, ("x", "y"))]
)
def test_a_place_outside_the_site_is_refused(x: float, y: float, wrong: tuple[str, ...]) -> None:
    found = TASK.problems(GoToRequest(x=x, y=y), SITE)
    assert tuple(problem.path for problem in found) == wrong


def test_a_robot_without_wheels_or_place_is_refused_with_what_is_missing() -> None:
    bare = mock_description().model_copy(update={"drive": None, "lasers": (), "pose_sensors": ()})
    (problem,) = TASK.against(GoToRequest(x=0.0, y=0.0), bare)
    assert problem.found == (
        "go_to needs a base that drives and a laser or a pose sensor, to know where it is"
    )


SHARED = (
    "trees/tasks/go_to.py",
    "trees/tasks/patrol.py",
    "trees/tasks/follow.py",
    "trees/rounds.py",
    "trees/pursuit.py",
    "trees/leaves/follow.py",
    "trees/course.py",
    "trees/leaves/go.py",
    "trees/subtrees/travel.py",
    "trees/behaviours/give_way.py",
)


@pytest.mark.parametrize("path", SHARED)
def test_no_file_of_it_knows_a_robot(path: str) -> None:
    text = (ROOT / path).read_text("utf-8")
    robots = [
        each.stem for each in (ROOT / "sim/robots").glob("*.py") if "\nROBOT" in each.read_text("utf-8")
    ]
    assert "p3dx" in robots
    names = [*robots, "tiago", "pioneer", "summit", "panda"]
    assert [name for name in names if re.search(rf"\b{name}", text, re.IGNORECASE)] == []
    assert [line for line in text.splitlines() if re.match(r"\s*(from|import) tandem\.sim", line)] == []
