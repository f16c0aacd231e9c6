"""The base leaves its path for people by a band, and follows it as before where there is none."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.skills.base.band.bend import LOST, STALE, Bend
from tandem.skills.base.path import Path
from tandem.skills.base.path_follower import Follower
from tandem.skills.base.people.caution import Caution
from tandem.skills.base.people.forecast import forecast
from tandem.skills.base.people.person_track import Track
from tandem.skills.base.planner import Clearances
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load
from tests.fakes.base_rig import make_rig
from tests.skills.base.people.test_keeping_away import OPEN, drive, track
from tests.skills.base.people.test_tracker import SOUTH

BAND = load("lab").model_copy(update={"local_planner": "band"})
HERE = FloorPose(x=0.0, y=0.0, yaw=0.0)


def bend_for(monkeypatch: pytest.MonkeyPatch, *people: Track) -> tuple[Bend, Follower]:
    """Return a bend along two metres of x, among people whom the tracker is said to know."""
    rig = make_rig(BAND, SOUTH)
    base = rig.base
    caution = base.drive.course.caution
    assert caution is not None
    monkeypatch.setattr(Caution, "ahead", lambda _: forecast(people, OPEN))
    monkeypatch.setattr(Caution, "age", lambda _: 0.0)
    path = Path(np.array([[0.0, 0.0], [2.0, 0.0]]))
    follower = Follower(path, base.drive.course.drive, Clearances(OPEN, 0.3, HERE))
    nobody = base.drive.course.watch()
    monkeypatch.setattr(type(nobody), "block", lambda *_: None)
    return Bend(caution, 0.3, lambda: nobody, follower), follower


def test_a_band_gives_speeds_within_the_drives_and_is_not_driven_for_long(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    bend, follower = bend_for(monkeypatch, track(1.2, 0.1, 0.0, 0.0))
    assert bend.due(1.0, HERE, slowed=True)
    list(bend.plan(1.0, HERE, 0.3, 0.0))
    speeds = bend.speeds(1.02, HERE)
    assert speeds is not None
    assert 0.0 < speeds[0] <= follower.drive.forward
    assert speeds[1] < 0.0
    assert not bend.due(1.1, HERE, slowed=True)
    assert bend.due(1.2, HERE, slowed=True)
    assert bend.speeds(1.0 + STALE + 0.1, HERE) == (0.0, 0.0)


def test_without_a_band_the_path_is_followed(monkeypatch: pytest.MonkeyPatch) -> None:
    bend, _ = bend_for(monkeypatch, track(0.9, 0.0, -1.2, 0.0))
    assert bend.due(1.0, HERE, slowed=True)
    list(bend.plan(1.0, HERE, 0.6, 0.0))
    assert bend.speeds(1.02, HERE) is None


def test_a_base_that_is_not_slowed_and_on_its_path_plans_no_band(monkeypatch: pytest.MonkeyPatch) -> None:
    bend, _ = bend_for(monkeypatch)
    assert not bend.due(1.0, HERE, slowed=False)


def test_off_the_path_without_a_band_the_base_stands_and_then_is_astray(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    beside = FloorPose(x=0.0, y=0.4, yaw=math.pi)
    bend, _ = bend_for(monkeypatch)
    for now in (1.0, 1.0 + LOST / 2):
        bend.due(now, beside, slowed=False)
        list(bend.plan(now, beside, 0.0, 0.0))
        assert bend.speeds(now, beside) == (0.0, 0.0)
        assert not bend.astray
    bend.due(1.1 + LOST, beside, slowed=False)
    assert bend.astray


@pytest.mark.thorough
def test_a_drive_across_somebodys_way_ends_where_it_should() -> None:
    rig = make_rig(BAND, SOUTH)
    across = [(0.0, 0.6, -2.3), (0.8, 0.6, -2.3), (3.8, 0.6, -0.5), (60.0, 0.6, -0.5)]
    outcome, nearest = drive(rig, FloorPose(x=2.0, y=-1.6, yaw=0.0), across)
    assert outcome.result is not None, outcome.failure
    assert nearest > 0.3 + 0.25
