"""Verbs and kills: a short form of what ``tandem campaign crash`` does, and how its points are counted."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.trials.campaigns import crash_points
from tandem.executive.trials.campaigns.crash_points import CrashPoints
from tandem.executive.trials.campaigns.crash_rig import CrashRig
from tandem.executive.trials.campaigns.crash_verbs import spread, verb_run
from tandem.executive.trials.campaigns.verb_cases import CASES
from tandem.skills.ports import tasks
from tandem.skills.ports.keys import Service
from tandem.skills.ports.tasks import ControlAnswer
from tests.fakes.ports import free_endpoint

PLACES = {"breakpoint": 4, "cancel": 30, "answer": 4}
"""Right after the answer; in the middle of the wind-down."""


@pytest.mark.processes
@pytest.mark.xdist_group("processes")
def test_verbs_hold_after_a_kill(tmp_path: Path) -> None:
    with CrashRig(tmp_path, free_endpoint()) as rig:
        runs = [
            verb_run(rig, case, number, PLACES[case.verb])
            for number, case in enumerate(CASES)
            if case.verb in PLACES
        ]
    assert {run.point: run.wrong for run in runs} == {run.point: () for run in runs}
    assert all(run.kills for run in runs)


def test_every_verb_is_in_the_campaign() -> None:
    services = [each for each in vars(tasks).values() if isinstance(each, Service)]
    assert {case.key for case in CASES} == {each.key for each in services if each.answered is ControlAnswer}


@pytest.mark.parametrize(
    ("at", "kills_at"),
    [
        ("asked a", 1),
        ("asked a +0", 1),
        ("asked a +1", 2),
        ("asked a +3", 5),
        ("asked a #2", 6),
        ("asked a #2 +1", 7),
        ("", None),
    ],
)
def test_points_are_counted_from_the_one_that_is_named(
    monkeypatch: pytest.MonkeyPatch, at: str, kills_at: int | None
) -> None:
    passed = [
        "before b",
        "asked a",
        "after b",
        "before c",
        "heard d",
        "after c",
        "asked a",
        "before answer a",
    ]
    killed: list[int] = []
    points = CrashPoints(at)
    monkeypatch.setattr(crash_points.os, "kill", lambda *_: killed.append(number))
    number = 0
    while number < len(passed) and not killed:
        points.passing(passed[number])
        number += 1
    assert killed == ([] if kills_at is None else [kills_at])


@pytest.mark.parametrize(
    ("count", "most", "expected"),
    [(1, 12, (0,)), (10, 12, (0, 1, 2, 3, 4, 5, 6, 7)), (100, 4, (0, 20, 40, 60))],
)
def test_places_are_spread_over_most_of_the_points(count: int, most: int, expected: tuple[int, ...]) -> None:
    assert spread(count, most) == expected
