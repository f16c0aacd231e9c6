"""Processes that are killed and start again: a short form of ``tandem campaign crash``."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.trials.campaigns.crash import (
    CrashRun,
    Kill,
    never_reached,
    one_run,
    point_run,
    random_kills,
)
from tandem.executive.trials.campaigns.crash_rig import CrashRig
from tandem.executive.trials.campaigns.crash_world import Deed, wrong_deeds
from tests.fakes.ports import free_endpoint

POINTS = (
    "after keeping request",
    "after keeping request and RUNNING",
    "before answer task/request",
    "after keeping goal of gripper_left/grip",
    "after query skill/gripper_left/grip/goal",
    "before keeping SUCCEEDED",
)
"""A few of those that the campaign goes through."""


@pytest.mark.processes
@pytest.mark.xdist_group("processes")
def test_nothing_is_lost_doubled_or_stuck(tmp_path: Path) -> None:
    """One run with kills of each kind, a kill at each of a few points, and a point that is never reached."""
    kills = [
        Kill(victim=victim, after=after)
        for victim, after in (("executive", 0.4), ("mock", 0.9), ("all", 1.3))
    ]
    with CrashRig(tmp_path, free_endpoint()) as rig:
        runs: list[CrashRun] = [one_run(rig, 0, kills)]
        runs += [point_run(rig, 1 + number, point) for number, point in enumerate(POINTS)]
        nowhere = point_run(rig, 1 + len(POINTS), "before the end of the world", tries=2)
    assert {run.point or "random": run.wrong for run in runs} == dict.fromkeys(("random", *POINTS), ())
    assert [kill.victim for kill in runs[0].kills] == ["executive", "mock", "all"]
    assert all(len(run.kills) == 1 for run in runs[1:])
    assert nowhere.wrong == (never_reached("before the end of the world"),), "it has shown nothing"


def test_the_same_seed_draws_the_same_kills() -> None:
    assert random_kills(1, 7) == random_kills(1, 7)
    assert random_kills(1, 7) != random_kills(2, 7)


def began(goal_id: str, at: float = 1.0, action: str = "base/drive", **more: bool) -> Deed:
    return Deed(what="began", at=at, action=action, goal_id=goal_id, **more)


def ended(goal_id: str, action: str = "base/drive") -> Deed:
    return Deed(what="ended", at=1.5, action=action, goal_id=goal_id)


BORN = Deed(what="born", at=0.0)
WRONG = {
    "nothing": ([began("t/a/1"), ended("t/a/1"), began("t/a/2")], ""),
    "the same twice": ([began("t/a/1"), ended("t/a/1"), began("t/a/1")], "t/a/1 was started twice"),
    "the same twice, over a death": ([began("t/a/1"), BORN, began("t/a/1")], "t/a/1 was started twice"),
    "at once": ([began("t/a/1"), began("t/b/1", action="base/rotate")], "while t/a/1 was under way"),
    "after a death": ([began("t/a/1"), BORN, began("t/b/1", action="base/rotate")], ""),
    "by two arms": ([began("t/a/1", action="arm_left/move"), began("t/b/1", action="arm_right/move")], ""),
    "by one arm and its hand": (
        [began("t/a/1", action="arm_left/move"), began("t/b/1", action="gripper_left/grip")],
        "while t/a/1 was under way",
    ),
    "by one arm and its empty hand": (
        [began("t/pre-grasp/1", action="arm_left/move"), began("t/open/1", action="gripper_left/grip")],
        "",
    ),
    "by an empty hand twice": (
        [began("t/open/1", action="gripper_left/grip"), began("t/close/1", action="gripper_left/grip")],
        "while t/open/1 was under way",
    ),
    "by one arm whose hand lets go": (
        [began("t/place/1", action="arm_left/move"), began("t/let go/1", action="gripper_left/grip")],
        "while t/place/1 was under way",
    ),
    "done before": ([began("t/a/1", done_before=True)], "was so already"),
    "after the end": ([began("t/a/1", at=9.0)], "after its task had ended"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_must_not_be_done_is_seen(case: str) -> None:
    done, expected = WRONG[case]
    found = wrong_deeds(done, {"t": 5.0}.get)
    assert len(found) == bool(expected)
    assert expected in "".join(found)
