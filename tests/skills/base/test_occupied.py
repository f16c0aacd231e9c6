"""The base keeps clear of what depth shows, be it lower or higher than the laser's plane."""

import math

import numpy as np
import pytest

from tandem.skills.base.map import build_map
from tandem.skills.base.occupied import OccupiedFloor
from tandem.skills.ports.actions.base import DriveGoal
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import OccupancySetting
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import Command
from tandem.skills.ports.world import OCCUPANCY, Box
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.base_rig import make_rig
from tests.fakes.occupied import occupied
from tests.fakes.planar_robot import describe

LAB = load("lab")
WATCHFUL = LAB.model_copy(update={"occupancy": OccupancySetting()})
PLAN = build_map(LAB, describe()).plan
STAMP = RobotTime(boot="b", seconds=1.0)


def block(bottom: float, top: float, x: float = 0.5, y: float = -1.6) -> Box:
    return Box(size=(0.3, 0.3, top - bottom), pose=Pose(position=(x, y, (top + bottom) / 2.0)))


@pytest.mark.parametrize(
    ("box", "counts"),
    [
        (block(0.05, 0.2), True),
        (block(0.9, 1.0), True),
        (block(1.2, 1.6), False),
        (block(0.8, 1.0, *LAB.furniture[1].boxes[0].centre[:2]), False),
    ],
    ids=["low", "at the head's height", "above the robot", "on the table"],
)
def test_cells_between_clearance_and_height_are_on_the_floor_plan(box: Box, counts: bool) -> None:  # noqa: FBT001
    bus = MemoryBus()
    floor = OccupiedFloor(bus, 1.1, PLAN)
    assert len(floor.points()) == 0
    OCCUPANCY.publish(bus, occupied(STAMP, box))
    points = floor.points()
    assert (len(points) > 0) is counts
    if counts:
        assert np.abs(points - np.array(box.pose.position[:2])).max() < 0.2
        assert np.unique(points[:, 0]).size == pytest.approx(12, abs=2)


def nearest_of(site: Site, shelf: Box) -> float:
    """Drive past a shelf; return how near the base's axis came to its middle (m)."""
    rig = make_rig(site, FloorPose(x=-1.0, y=-1.6, yaw=0.0))
    OCCUPANCY.publish(rig.bus, occupied(rig.robot.clocks.robot(), shelf))
    gaps, (x, y, _) = list[float](), shelf.pose.position

    def watched(_: float) -> Command:
        gaps.append(math.hypot(rig.robot.truth.x - x, rig.robot.truth.y - y))
        return Command.GO_ON

    goal = DriveGoal(poses=(FloorPose(x=2.0, y=-1.6, yaw=0.0),))
    assert rig.run(rig.base.drive.run(goal, "g"), watched).result is not None
    return min(gaps)


def test_a_low_shelf_that_no_map_and_no_laser_knows_is_driven_around() -> None:
    shelf = block(0.0, 0.15)
    assert nearest_of(LAB, shelf) < 0.1
    assert nearest_of(WATCHFUL, shelf) > 0.15 + describe().footprint_radius
