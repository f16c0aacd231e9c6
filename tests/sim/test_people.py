"""People: they walk where their file says, stop and give way by chance, and only where there is room."""

from __future__ import annotations

import itertools
import math
from pathlib import Path

import pytest

from tandem.sim.people import Person
from tandem.sim.scenario import Scenario, load_scenario
from tandem.sim.scene import build_scene
from tandem.sim.station import Station, StationSettings
from tandem.sim.truth import Truth
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sources import DocumentError
from tandem.skills.site import load

SITE = load("picking")
CROSSES = Person(name="anna", path=((-1.0, 1.0), (-1.0, -1.2)), speed=1.0)


def room(*people: Person, x: float = 1.2, y: float = 1.0) -> Scenario:
    start = FloorPose(x=x, y=y, yaw=0.0)
    return Scenario(name="crossing", site="picking", robot="locobot", start=start, people=people)


def watched(scenario: Scenario, seconds: float, seed: int = 1) -> list[Truth]:
    """Return what was so each tenth of a second."""
    station = Station({}, SITE, scenario, StationSettings(boot="b", seed=seed))
    seen = []
    try:
        for tick in range(round(seconds * 100)):
            station.step()
            if tick % 10 == 0:
                seen.append(station.truth())
    finally:
        station.close()
    return seen


def places(seen: list[Truth], who: int = 0) -> list[tuple[float, float]]:
    return [(each.people[who].x, each.people[who].y) for each in seen]


def test_a_person_walks_its_path_to_and_fro_at_its_pace() -> None:
    seen = watched(room(CROSSES), 8.0)
    at = places(seen)
    assert all(abs(x + 1.0) < 0.05 and -1.25 < y < 1.05 for x, y in at)
    assert min(y for _, y in at) < -1.1
    assert at[-1][1] > at[35][1], "on the way back"
    assert 0.9 < max(math.hypot(*each.people[0].linear) for each in seen) < 1.1


def test_a_person_may_stay_at_the_end() -> None:
    at = places(watched(room(CROSSES.model_copy(update={"then": "stay", "after": 1.0})), 6.0))
    assert at[8] == pytest.approx((-1.0, 1.0), abs=0.01)
    assert at[-1] == pytest.approx((-1.0, -1.2), abs=0.03)


def test_the_seed_decides_when_somebody_stops_or_turns() -> None:
    restless = CROSSES.model_copy(update={"stops": 0.5, "turns": 0.3})
    one, same, other = (places(watched(room(restless), 6.0, seed)) for seed in (1, 1, 2))
    assert one == same
    assert one != other
    assert any(math.dist(a, b) < 0.001 for a, b in itertools.pairwise(one)), "it stands now and then"


@pytest.mark.parametrize(("gives_way", "touches"), [(1.0, 0), (0.0, 1)])
def test_who_gives_way_waits_and_who_does_not_bumps_into_a_standing_robot(
    gives_way: float, touches: int
) -> None:
    last = watched(
        room(CROSSES.model_copy(update={"gives_way": gives_way, "after": 1.0}), x=-1.0, y=-0.4), 6.0
    )[-1]
    assert len(last.touches) == touches
    assert all(touch.person == "anna" and touch.stood >= 1.0 for touch in last.touches)


def test_the_later_one_of_two_people_waits() -> None:
    ben = Person(name="ben", path=((-1.6, 0.0), (0.0, -0.4)), speed=1.0)
    one, two = (places(watched(room(CROSSES, ben), 6.0), who) for who in (0, 1))
    assert min(math.dist(a, b) for a, b in zip(one, two, strict=True)) > 0.4


def test_the_earlier_one_turns_round_before_one_who_stands_in_its_way() -> None:
    ben = Person(name="ben", path=((-1.0, -0.3), (0.0, -0.3)), speed=1.0, after=60.0)
    one, two = (places(watched(room(CROSSES, ben), 8.0), who) for who in (0, 1))
    assert max(math.dist(two[0], b) for b in two) < 0.01, "ben is not pushed"
    assert min(math.dist(a, two[0]) for a in one) > 0.4
    assert one[-1][1] > 0.5, "anna walks back"


def test_who_is_touched_from_behind_goes_on() -> None:
    turned = watched(room(CROSSES.model_copy(update={"gives_way": 0.0, "after": 1.0}), x=-1.0, y=-0.4), 6.0)
    at = places(turned)
    assert [touch.person for touch in turned[-1].touches] == ["anna"]
    assert max(y for _, y in at[45:]) > 0.9, "anna bumps once, and then walks all the way back"


@pytest.mark.parametrize(
    ("people", "path", "said"),
    [
        ("[{name: a, path: [[0, -1]], speed: 1}]", "people.0.path", "at least 2"),
        ("[{name: a, path: [[0, -1], [1, -1]], speed: 2}]", "people.0.speed", "1.4"),
        ("[{name: a, path: [[0, -1], [1, .nan]], speed: 1}]", "people.0.path.1", "finite"),
        ("[{name: a, path: [[0, -1], [0, -1]], speed: 1}]", "people.0.path.1", "more than"),
        ("[{name: a, path: [[0.3, -1], [0.3, 1]], speed: 1}]", "people.0.path.1", "pillar"),
        ("[{name: a, path: [[0, -1], [5, -1]], speed: 1}]", "people.0.path.1", "in the room"),
        ("[{name: a, path: [[1.2, 1.1], [0, -1]], speed: 1}]", "people.0.path.0", "the robot"),
        ("[{name: robot, path: [[0, -1], [1, -1]], speed: 1}]", "people.0.name", "something else"),
    ],
)
def test_wrong_people_are_refused_with_path_and_reason(
    tmp_path: Path, people: str, path: str, said: str
) -> None:
    file = tmp_path / "mine.yaml"
    start = "{x: 1.2, y: 1.0, yaw: 0}"
    file.write_text(f"name: x\nsite: picking\nrobot: locobot\nstart: {start}\npeople: {people}\n")
    with pytest.raises(DocumentError) as caught:
        build_scene(SITE, load_scenario(file))
    assert path in str(caught.value)
    assert said in str(caught.value)


def test_the_camera_sees_them_and_a_reset_puts_them_back() -> None:
    station = Station({}, SITE, room(CROSSES), StationSettings(boot="b", seed=1))
    try:
        for _ in range(200):
            station.step()
        (figure,) = station.world.figures()
        assert figure.pose.position[1] < 0.0
        station.reset(1)
        (figure,) = station.world.figures()
        assert figure.pose.position[:2] == pytest.approx((-1.0, 1.0), abs=0.01)
        assert len(station.physics.watchers) == 1
    finally:
        station.close()
