"""The tracker on the planar fake: who walks is a person, what stands is none, who is gone is forgotten."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from tandem.skills.base.people.person_track import Track, goes
from tandem.skills.base.people.segments import Candidate
from tandem.skills.base.people.still import HITS, StillPlaces
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import SiteBox
from tandem.skills.ports.world import PEOPLE
from tandem.skills.site import load
from tests.fakes.base_rig import Rig, make_rig

LAB = load("lab").model_copy(update={"local_planner": "people"})
SOUTH = FloorPose(x=-1.0, y=-1.6, yaw=0.0)


def leg(x: float, y: float) -> SiteBox:
    return SiteBox(size=(0.09, 0.09, 0.8), centre=(x, y, 0.4))


def legs(x: float, y: float) -> list[SiteBox]:
    """Return somebody's two legs, who walks along y."""
    return [leg(x - 0.1, y), leg(x + 0.1, y)]


def walk(rig: Rig, where: Callable[[float], tuple[float, float] | None], seconds: float) -> None:
    """Let time pass with somebody where the function of the seconds says."""
    before, start = list(rig.robot.boxes), rig.now
    while rig.now - start < seconds:
        at = where(rig.now - start)
        rig.robot.boxes = [*before, *([] if at is None else legs(*at))]
        rig.tick()
    rig.robot.boxes = before


def test_somebody_who_walks_is_told_with_place_and_speed() -> None:
    rig = make_rig(LAB, SOUTH)
    heard = Latest(rig.bus, PEOPLE)
    walk(rig, lambda t: (0.8, -2.2 + 0.8 * t), 1.5)
    (person,) = heard.refresh().people  # type: ignore[union-attr]
    assert math.dist((person.x, person.y), (0.8, -1.0)) < 0.15
    assert person.vy == pytest.approx(0.8, abs=0.2)
    assert abs(person.vx) < 0.2
    assert person.unseen == 0.0


def test_a_chair_is_nobody_and_a_person_stays_one_when_they_stand() -> None:
    rig = make_rig(LAB, SOUTH)
    rig.robot.boxes += [leg(x, y) for x in (0.4, 0.75) for y in (-1.7, -1.35)]
    rig.wait(3.0)
    assert rig.base.people is not None
    assert rig.base.people.people == ()
    walk(rig, lambda t: (1.4, min(-2.2 + 0.8 * t, -0.7)), 4.0)
    (person,) = rig.base.people.people
    assert person.speed < 0.1
    assert rig.base.people.walking == ()


def test_who_is_no_longer_there_is_forgotten() -> None:
    rig = make_rig(LAB, SOUTH)
    assert rig.base.people is not None
    walk(rig, lambda t: (0.8, -2.2 + 0.8 * t), 1.5)
    assert len(rig.base.people.people) == 1
    walk(rig, lambda _: None, 1.2)
    assert rig.base.people.people == ()


def test_who_walks_leaves_no_obstacles_behind() -> None:
    rig = make_rig(LAB, SOUTH)
    walk(rig, lambda t: (0.8, -2.2 + 0.8 * t), 1.5)
    assert len(rig.base.obstacles.points) == 0


def test_without_the_setting_nobody_is_tracked() -> None:
    assert make_rig(load("lab"), SOUTH).base.people is None


@pytest.mark.parametrize(
    ("places", "walks"),
    [
        ([(0.1 * k, 0.0) for k in range(6)], True),
        ([(0.03 * k, 0.0) for k in range(12)], True),
        ([(0.1 * k, 0.0) for k in range(4)], False),
        ([(0.0, 0.0)] * 12, False),
        ([(0.0, 0.0), (0.0, 0.0), (0.18, 0.18), (0.0, 0.36), (0.0, 0.36), (0.18, 0.18)], False),
    ],
)
def test_an_even_pace_is_walking_and_jumps_between_legs_are_not(
    places: list[tuple[float, float]],
    walks: bool,  # noqa: FBT001 - a column of the table
) -> None:
    assert goes(places) is walks


def test_where_something_has_stood_nobody_is_born() -> None:
    still = StillPlaces()
    for _ in range(HITS):
        still.see([(1.0, 1.0)], 0.1)
    assert still.holds(1.05, 1.0)
    assert not still.holds(1.3, 1.0)
    still.see([], 5.0)
    assert not still.holds(1.0, 1.0)


def test_a_track_takes_up_the_velocity() -> None:
    track = Track.of(1, Candidate(0.0, 0.0, 0.05, paired=True, parts=()))
    for k in range(1, 11):
        track.predict(0.1)
        track.update(Candidate(0.1 * k, 0.0, 0.05, paired=True, parts=()))
    assert track.velocity == pytest.approx((1.0, 0.0), abs=0.1)
    assert track.walked
