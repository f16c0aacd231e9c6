"""Keeping track: odometry that drifts, scans that correct it."""

import math

import numpy as np
import pytest

from tandem.skills.base.floor import compose, invert
from tandem.skills.base.matcher import diagonal, match
from tandem.skills.base.odometry import OdometryBuffer
from tandem.skills.base.scan import ScanGeometry
from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.actions.base import DriveGoal, RotateGoal
from tandem.skills.ports.hardware import Odometry
from tandem.skills.ports.keys import ODOMETRY, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import LaserScan
from tandem.skills.ports.site import SiteBox
from tandem.skills.ports.world import ROBOT_POSE
from tandem.skills.site import load
from tests.fakes.base_rig import Rig, make_rig
from tests.fakes.planar_robot import PlanarNoise

LAB = load("lab")
START = FloorPose(x=-1.0, y=-1.6, yaw=0.3)


def error_of(rig: Rig) -> tuple[float, float]:
    odometry = rig.base.localiser.odometry
    assert odometry is not None
    believed = compose(rig.base.localiser.odom_in_map, odometry.base_in_odom)
    return floor_distance(believed, rig.robot.truth), abs(wrap(believed.yaw - rig.robot.truth.yaw))


def test_composing_with_the_inverse_is_nothing() -> None:
    there = compose(START, invert(START))
    assert (there.x, there.y, there.yaw) == pytest.approx((0.0, 0.0, 0.0))


def test_odometry_is_interpolated_the_short_way_round() -> None:
    buffer = OdometryBuffer()
    for seconds, yaw in ((1.0, math.pi - 0.1), (2.0, -math.pi + 0.1)):
        pose = FloorPose(x=seconds, y=0.0, yaw=yaw)
        buffer.add(
            Odometry(stamp=RobotTime(boot="b", seconds=seconds), base_in_odom=pose, linear=0, angular=0)
        )
    found = buffer.at(RobotTime(boot="b", seconds=1.5))
    assert found is not None
    assert found.x == pytest.approx(1.5)
    assert abs(found.yaw) == pytest.approx(math.pi)
    assert buffer.at(RobotTime(boot="b", seconds=2.5)) is None
    assert buffer.at(RobotTime(boot="another", seconds=1.5)) is None


def test_a_match_finds_the_pose_from_half_a_foot_away_although_something_unknown_stands_there() -> None:
    rig = make_rig(LAB, START)
    rig.robot.boxes.append(SiteBox(size=(0.3, 0.3, 1.0), centre=(0.2, -1.2, 0.5)))
    scan = LaserScan(stamp=rig.robot.clocks.robot(), ranges=tuple(rig.robot.ranges().tolist()))
    site_map = rig.base.drive.course.site_map
    points = ScanGeometry(rig.robot.description.laser, site_map.laser_in_base).points(scan)
    assert points is not None
    off = FloorPose(x=START.x + 0.1, y=START.y - 0.1, yaw=START.yaw + 0.06)
    found = match(site_map.laser, points.in_base, off, diagonal(0.2, 0.1))
    assert floor_distance(found.pose, START) < 0.005
    assert abs(found.pose.yaw - START.yaw) < 0.003
    assert found.fit < 0.98


@pytest.mark.parametrize("seed", [1, 2])
def test_after_twenty_metres_the_pose_is_within_two_centimetres(seed: int) -> None:
    noise = PlanarNoise(scale=0.05, turn_scale=-0.04, drift=0.03, laser_sigma=0.02)
    rig = make_rig(LAB, FloorPose(x=-1.5, y=-2.2, yaw=0.0), seed=seed, noise=noise)
    there, back = FloorPose(x=1.9, y=-1.7, yaw=math.pi), FloorPose(x=-1.6, y=-2.0, yaw=0.0)
    goals = [there, back] * 3
    for goal in goals:
        outcome = rig.run(rig.base.drive.run(DriveGoal(poses=(goal,)), "g"))
        assert outcome.result is not None
        metres, radians = error_of(rig)
        assert metres < 0.02
        assert radians < math.radians(0.5)
    assert rig.robot.driven > 20.0


def test_at_rest_the_pose_does_not_move_at_all() -> None:
    rig = make_rig(LAB, START)
    rig.wait(1.0)
    drift = rig.base.localiser.odom_in_map
    rig.wait(1.0)
    assert rig.base.localiser.odom_in_map == drift


@pytest.mark.parametrize("push", [(0.03, 0.0, 0.10), (0.10, 0.10, -0.12), (-0.12, 0.05, 0.2)])
@pytest.mark.parametrize("person", [False, True])
def test_a_push_that_odometry_does_not_notice_is_found_at_rest(
    push: tuple[float, float, float], *, person: bool
) -> None:
    rig = make_rig(LAB, START)
    rig.wait(1.0)
    rig.robot.truth = compose(START, FloorPose(x=push[0], y=push[1], yaw=push[2]))
    if person:
        rig.robot.boxes.append(SiteBox(size=(0.3, 0.3, 1.0), centre=(START.x + 0.6, START.y + 0.1, 0.5)))
    rig.wait(1.0)
    metres, radians = error_of(rig)
    assert metres < 0.02
    assert radians < math.radians(0.5)


def test_who_comes_and_hides_a_part_of_the_walls_moves_nothing() -> None:
    rig = make_rig(LAB, START)
    rig.wait(1.0)
    drift = rig.base.localiser.odom_in_map
    rig.robot.boxes.append(SiteBox(size=(0.5, 0.5, 1.0), centre=(START.x + 0.6, START.y + 0.1, 0.5)))
    rig.wait(1.0)
    assert rig.base.localiser.odom_in_map == drift


def test_the_pose_is_told_twenty_times_a_second_and_says_why_it_is_unknown() -> None:
    rig = make_rig(LAB, START, localised=False)
    poses = Latest(rig.bus, ROBOT_POSE)
    rig.wait(1.0)
    told = poses.take()
    assert len(told) == pytest.approx(20, abs=1)
    assert not told[-1].localised
    assert "localise" in told[-1].reason


def test_a_robot_that_was_carried_away_knows_that_it_is_lost() -> None:
    rig = make_rig(LAB, START)
    rig.robot.truth = FloorPose(x=2.3, y=1.6, yaw=-2.5)
    rig.wait(0.5)
    rig.run(rig.base.rotate.run(RotateGoal(angle=2 * math.pi), "g"))
    assert not rig.base.localiser.localised
    assert "fit" in rig.base.localiser.reason


def test_the_same_seed_gives_the_same_drift() -> None:
    def drift() -> FloorPose:
        rig = make_rig(LAB, START, seed=3)
        rig.run(rig.base.rotate.run(RotateGoal(angle=1.0), "g"))
        return rig.base.localiser.odom_in_map

    assert drift() == drift()


def test_a_new_boot_of_the_hardware_ends_what_was_known() -> None:
    rig = make_rig(LAB, START)
    stamp = RobotTime(boot="another", seconds=0.02)
    zero = FloorPose(x=0.0, y=0.0, yaw=0.0)
    ODOMETRY.publish(rig.bus, Odometry(stamp=stamp, base_in_odom=zero, linear=0, angular=0))
    rig.base.localiser.step()
    assert not rig.base.localiser.localised
    assert np.isfinite(rig.base.localiser.odom_in_map.x)
