"""The robot that drives about at random: slow enough, never into anything, the same with the same seed."""

from __future__ import annotations

import itertools
import math

import pytest

from tandem.sim.scenario import Scenario
from tandem.sim.starts import RobotStart
from tandem.sim.station import Station, StationSettings
from tandem.sim.things import CylinderShape, Obstacle
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load

POST = Obstacle(name="post", shape=CylinderShape(radius=0.1, height=0.5), x=-0.4, y=-1.9, mass=0.0)
ROOM = Scenario(
    name="wandering",
    robots=(
        RobotStart(name="r2", robot="tiago_base", start=FloorPose(x=-2.2, y=-0.2, yaw=0.0)),
        RobotStart(name="r1", robot="tiago_base", start=FloorPose(x=-1.3, y=-1.2, yaw=2.0), drives="wander"),
    ),
    obstacles=(POST,),
)


def wander(seconds: int, seed: int) -> tuple[list[tuple[float, float]], list[float], set[str]]:
    """Return the path (m, one place a tenth of a second), the speeds (m/s), and what r1 touched."""
    station = Station({}, load("lab"), ROOM, StationSettings(boot="b", seed=seed))
    path, speeds, touched = [], [], set()
    try:
        for tick in range(seconds * 100):
            station.step()
            if tick % 10 == 0:
                truth = station.truth()
                robot = truth.robot("r1")
                path.append(robot.base_in_map.position[:2])
                speeds.append(math.hypot(*robot.linear))
                touched |= {
                    f"{one.first} {one.second}"
                    for one in truth.contacts
                    if "r1/" in one.first + one.second and "floor" not in {one.first, one.second}
                }
    finally:
        station.close()
    return path, speeds, touched


@pytest.mark.parametrize("seed", [1, 2])
def test_it_goes_far_and_slowly_and_touches_nothing(seed: int) -> None:
    path, speeds, touched = wander(60, seed)
    assert sum(math.dist(a, b) for a, b in itertools.pairwise(path)) > 3.0
    assert max(speeds) < 0.3
    assert touched == set()
    # From the centre of the post to that of a robot of 0.27 m, which brakes within 0.08 m.
    assert min(math.dist(each, (POST.x, POST.y)) for each in path) > 0.1 + 0.27 + 0.1


def test_the_seed_decides_its_way() -> None:
    first, again, other = (wander(10, seed)[0] for seed in (3, 3, 4))
    assert first == again
    assert first != other


def test_it_turns_on_the_spot_before_what_is_close_ahead() -> None:
    # A wall 0.25 m before its rim: it may not come closer, and must look elsewhere.
    facing = FloorPose(x=-0.4 - 0.1 - 0.25 - 0.27, y=-1.9, yaw=0.0)
    room = ROOM.model_copy(
        update={"robots": (RobotStart(name="r1", robot="tiago_base", start=facing, drives="wander"),)}
    )
    station = Station({}, load("lab"), room, StationSettings(boot="b", seed=1))
    try:
        for _ in range(100):
            station.step()
        x, y, _ = station.truth().robot("r1").base_in_map.position
        assert (x, y) == pytest.approx((facing.x, facing.y), abs=0.02)
        assert abs(station.hardware.bases[0].odometer.pose.yaw) > 0.3
    finally:
        station.close()
