"""The driver: each topic to its key, velocities to cmd_vel, and zero when the Tandem side falls silent."""

from __future__ import annotations

import logging

import numpy as np
import pytest

from tandem.skills.ports import keys
from tandem.skills.ports.hardware import Answer, BaseVelocity, Stop, StopRelease
from tandem.skills.ports.hearing import Reason
from tandem.skills.ports.image import decode
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ros import types
from tandem.skills.ros.naming import data_key
from tandem.skills.ros.wheels import ZEROS_FOR
from tests.skills.ros.ros_rig import ODOM, ROS, SCAN, SONAR, TF_POSE, Rig

CLIFFS = {"topic": "/cliff", "type": types.RANGE, "to": "cliff"}
BUMP = {"topic": "/bump", "type": types.BOOL, "to": "bumper", "sensor": "left"}
AHEAD = BaseVelocity(linear=0.2, angular=-0.1)


def sonar(rig: Rig, frame: str, distance: float, topic: str = "/sonar") -> None:
    rig.tell(
        topic,
        types.RANGE,
        header=rig.header(frame),
        radiation_type=0,
        field_of_view=0.5,
        min_range=0.1,
        max_range=5.0,
        range=distance,
        variance=0.0,
    )


def scan(rig: Rig, ranges: list[float], step: float | None = None) -> None:
    laser = rig.description.lasers[0]
    values = np.full(laser.beams, 2.0, np.float32)
    values[: len(ranges)] = ranges
    rig.tell(
        "/scan",
        types.LASER_SCAN,
        header=rig.header(laser.frame),
        angle_min=laser.angle_min,
        angle_max=0.0,
        angle_increment=step or laser.angle_step,
        time_increment=0.0,
        scan_time=0.1,
        range_min=0.05,
        range_max=10.0,
        ranges=values,
        intensities=np.array([], np.float32),
    )


def test_odometry_comes_with_its_time_and_velocity() -> None:
    rig = Rig("p3dx", [ODOM])
    heard = Latest(rig.bus, keys.ODOMETRY)
    rig.step(1.0)
    rig.tell("/odom", types.ODOMETRY, **rig.odometry(1.0, 2.0, 0.5, 0.3))
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert (told.stamp.boot, told.stamp.seconds, told.linear) == ("b", pytest.approx(1.0, abs=0.011), 0.3)
    assert (told.base_in_odom.x, told.base_in_odom.y) == (1.0, 2.0)
    assert told.base_in_odom.yaw == pytest.approx(0.5)


def test_a_pose_out_of_tf_is_followed_over_its_links() -> None:
    rig = Rig("p3dx", [TF_POSE])
    heard = Latest(rig.bus, keys.POSE_READING)
    rig.tell("/tf", types.TF, transforms=[rig.transform("odom", "base_link", (1.0, 0.0, 0.0))])
    rig.step()
    assert heard.refresh() is None, "nobody has told of odom in the map yet"
    rig.tell("/tf", types.TF, transforms=[rig.transform("map", "odom", (0.0, 5.0, np.pi / 2))])
    rig.tell("/tf", types.TF, transforms=[rig.transform("odom", "base_link", (1.0, 0.0, 0.0))])
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert told.sensor == "markers"
    found = told.base_in_map
    assert (found.x, found.y, found.yaw) == pytest.approx((0.0, 6.0, np.pi / 2))


def test_odometry_out_of_tf_has_the_velocity_between_its_poses() -> None:
    mapped = {"topic": "/tf", "type": types.TF, "to": "odometry", "parent": "odom", "child": "base_link"}
    rig = Rig("p3dx", [mapped])
    heard = Latest(rig.bus, keys.ODOMETRY)
    for x in (0.0, 0.05):
        rig.tell("/tf", types.TF, transforms=[rig.transform("odom", "base_link", (x, 0.0, 0.0))])
        rig.step(0.1)
    told = heard.refresh()
    assert told is not None
    assert told.base_in_odom == FloorPose(x=0.05, y=0.0, yaw=0.0)
    assert told.linear == pytest.approx(0.5, abs=0.06)


def test_sonars_are_known_by_their_frames_and_one_that_is_silent_is_missing() -> None:
    rig = Rig("p3dx", [SONAR])
    heard = Latest(rig.bus, keys.RANGES)
    for frame, distance in (("sonar_0_frame", 1.25), ("sonar_3_frame", 0.01), ("nobodys", 1.0)):
        sonar(rig, frame, distance)
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert {each.sensor: each.distance for each in told.readings} == {"sonar_0": 1.25, "sonar_3": 0.15}
    rig.step(0.4)
    sonar(rig, "sonar_3_frame", float("inf"))
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert {each.sensor: each.distance for each in told.readings} == {"sonar_3": 5.0}


def test_cliff_sensors_are_known_by_their_frames_and_nothing_below_one_is_an_edge() -> None:
    rig = Rig("locobot", [CLIFFS])
    heard = Latest(rig.bus, keys.CLIFFS)
    for frame, distance in (
        ("cliff_left", 0.0316),
        ("cliff_center", float("inf")),
        ("cliff_right", float("nan")),
    ):
        sonar(rig, frame, distance, "/cliff")
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert {each.sensor: each.distance for each in told.readings} == {
        "cliff_left": 0.0316,
        "cliff_center": 0.15,
    }


def test_bumpers_are_told_on_each_change_and_now_and_then() -> None:
    rig = Rig("p3dx", [BUMP])
    heard = Latest(rig.bus, keys.BUMPERS)
    rig.step(1.0)
    assert heard.take() == [], "nobody has said anything yet"
    rig.tell("/bump", types.BOOL, data=True)
    rig.step()
    assert [each.pressed for each in heard.take()] == [("left",)]
    rig.step(1.0)
    assert len(heard.take()) in {4, 5}


def test_a_scan_is_cut_to_what_the_laser_can_measure() -> None:
    rig = Rig("tiago_base", [SCAN])
    heard = Latest(rig.bus, keys.laser("base"))
    scan(rig, [float("nan"), float("inf"), float("-inf"), 0.0, 0.01, 99.0, 1.5])
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert told.ranges[:8] == (10.0, 10.0, 0.05, 10.0, 0.05, 10.0, 1.5, 2.0)


def test_a_scan_of_other_beams_is_refused_and_said(caplog: pytest.LogCaptureFixture) -> None:
    rig = Rig("tiago_base", [SCAN])
    heard = Latest(rig.bus, keys.laser("base"))
    with caplog.at_level(logging.WARNING):
        scan(rig, [], step=0.001)
        rig.step()
    assert heard.refresh() is None
    assert "topic /scan (sensor_msgs/msg/LaserScan): expected 541 beams from" in caplog.text


def test_joints_of_several_nodes_are_told_together() -> None:
    rig = Rig("tiago", [{"topic": "/joint_states", "type": types.JOINT_STATE, "to": "joints"}])
    heard = Latest(rig.bus, keys.JOINT_STATES)
    names = sorted(rig.description.joints)
    for some in (names[:3], ["a_wheel_joint", *names[3:]]):
        rig.step()
        assert heard.refresh() is None, "some are missing"
        values = np.arange(len(some), dtype=float)
        rig.tell(
            "/joint_states",
            types.JOINT_STATE,
            header=rig.header(),
            name=some,
            position=values,
            velocity=np.array([]),
            effort=np.array([]),
        )
    rig.step()
    told = heard.refresh()
    assert told is not None
    assert sorted(told.names) == names
    assert told.position_of((names[2], names[3])) == (2.0, 1.0)


def test_a_robot_without_joints_says_so_once_a_period() -> None:
    rig = Rig("p3dx", [ODOM])
    heard = Latest(rig.bus, keys.JOINT_STATES)
    rig.step(0.5)
    assert len(heard.take()) in {49, 50}


def test_colour_and_depth_of_one_moment_are_one_picture() -> None:
    mapped = [
        {"topic": f"/{name}", "type": kind, "to": name, "sensor": "head"}
        for name, kind in (
            ("colour", types.IMAGE),
            ("depth", types.IMAGE),
            ("camera_info", types.CAMERA_INFO),
        )
    ]
    rig = Rig("tiago_base", mapped)
    camera = rig.description.cameras[0]
    wide, high = camera.width, camera.height
    heard = rig.bus.subscribe(keys.rgbd("head"))
    lens = np.array([800.0, 0, 640, 0, 0, 800, 360, 0, 0, 0, 1, 0])
    region = rig.codec.message(
        "sensor_msgs/msg/RegionOfInterest", x_offset=0, y_offset=0, height=0, width=0, do_rectify=False
    )
    rig.tell(
        "/camera_info",
        types.CAMERA_INFO,
        header=rig.header(),
        height=high,
        width=wide,
        distortion_model="plumb_bob",
        d=np.array([]),
        k=np.zeros(9),
        r=np.zeros(9),
        p=lens,
        binning_x=0,
        binning_y=0,
        roi=region,
    )
    blue = np.tile(np.array([255, 0, 0], np.uint8), high * wide)
    shared = {"height": high, "width": wide, "is_bigendian": 0}
    rig.tell(
        "/colour",
        types.IMAGE,
        header=rig.header(),
        encoding="bgr8",
        step=3 * wide,
        data=blue,
        **shared,
    )
    rig.step()
    assert heard.drain() == [], "its depth has not come"
    metres = np.full(high * wide, 1.5, np.float32)
    metres[0] = np.nan
    rig.tell(
        "/depth",
        types.IMAGE,
        header=rig.header(),
        encoding="32FC1",
        step=4 * wide,
        data=metres.view(np.uint8),
        **shared,
    )
    rig.step()
    (sample,) = heard.drain()
    picture = decode(sample.payload)
    assert picture.colour[0, 0].tolist() == [0, 0, 255]
    assert picture.depth[0, :2].tolist() == [0, 1500]
    assert (picture.header.fx, picture.header.cx, picture.header.cy) == (800.0, 640.0, 360.0)


@pytest.mark.parametrize(("told", "taken"), [("TypeHashNotSupported", 1), ("RIHS01_" + "0" * 64, 0)])
def test_humbles_missing_hash_is_taken_and_another_definition_is_not(told: str, taken: int) -> None:
    rig = Rig("p3dx", [BUMP])
    heard = Latest(rig.bus, keys.BUMPERS)
    rig.net.put(data_key(0, "/bump", types.BOOL, told), bytes.fromhex("0001000001"))
    rig.step()
    assert len(heard.take()) == taken


def test_a_velocity_goes_out_at_once_within_the_limits_with_attachments() -> None:
    rig = Rig("p3dx", [ODOM])
    keys.BASE_VELOCITY.publish(rig.bus, BaseVelocity(linear=9.0, angular=-0.1))
    rig.driver.step()
    assert rig.velocities() == [(0.75, -0.1)]
    (put,) = (each for each in rig.net.puts if each.key.startswith("0/cmd_vel/"))
    assert int.from_bytes(put.attachment[:8], "little") == 1
    assert int.from_bytes(put.attachment[8:16], "little") == round(ROS * 1e9)


def test_a_stamped_velocity_has_the_bases_frame() -> None:
    stamped = {"topic": "/cmd", "type": types.TWIST_STAMPED}
    rig = Rig("p3dx", [ODOM], stamped)
    heard = rig.ros.subscription("/cmd", types.TWIST_STAMPED)
    keys.BASE_VELOCITY.publish(rig.bus, AHEAD)
    rig.driver.step()
    (told,) = heard.take()
    assert f"frame_id='{rig.description.base_frame}'" in repr(told)
    assert "x=0.2" in repr(told)


def test_when_the_tandem_side_falls_silent_the_base_is_told_zero_and_then_nothing() -> None:
    rig = Rig("p3dx", [ODOM])
    keys.BASE_VELOCITY.publish(rig.bus, AHEAD)
    dead_man = rig.description.driven.dead_man
    rig.step(dead_man)
    assert set(rig.velocities()) == {(0.2, -0.1)}
    rig.step(0.05)
    assert rig.velocities()[-1] == (0.0, 0.0)
    rig.step(ZEROS_FOR)
    assert set(rig.velocities()) == {(0.0, 0.0)}
    rig.step(0.1)
    rig.velocities()
    rig.step(1.0)
    assert rig.velocities() == [], "others may use the topic"


def test_a_driver_that_ends_leaves_the_base_standing() -> None:
    rig = Rig("p3dx", [ODOM])
    keys.BASE_VELOCITY.publish(rig.bus, AHEAD)
    rig.step()
    rig.driver.close()
    assert rig.velocities()[-1] == (0.0, 0.0)


def test_while_the_stop_is_set_zero_is_told_and_no_velocity_is_obeyed() -> None:
    rig = Rig("p3dx", [ODOM])
    keys.BASE_VELOCITY.publish(rig.bus, AHEAD)
    rig.step()
    keys.STOP.query(rig.bus, Stop(by="test", reason=""))
    rig.step()
    rig.velocities()
    keys.BASE_VELOCITY.publish(rig.bus, AHEAD)
    rig.step(ZEROS_FOR * 3)
    told = rig.velocities()
    assert len(told) > ZEROS_FOR * 3 / 0.06
    assert set(told) == {(0.0, 0.0)}
    keys.STOP_RELEASE.query(rig.bus, StopRelease(by="test"))
    rig.step()
    keys.BASE_VELOCITY.publish(rig.bus, AHEAD)
    rig.step()
    assert rig.velocities()[-1] == (0.2, -0.1)


def test_joints_are_not_moved_and_the_answer_says_so() -> None:
    rig = Rig("panda", [{"topic": "/j", "type": types.JOINT_STATE, "to": "joints"}], None)
    group = rig.description.groups[0].name
    goal = b'{"id": "g", "points": [{"time": 0.0, "positions": [], "velocities": []}]}'
    pending = rig.bus.query(keys.group_goal(group).key, goal)
    rig.step()
    answer = pending.poll()
    assert answer is not None
    assert (
        Answer.model_validate_json(answer).reason == "the role ros moves no joints; it drives the base only"
    )


@pytest.mark.parametrize(("type_name", "kept"), [(types.BOOL, 64), (types.IMAGE, 2)])
def test_sensors_that_share_a_topic_lose_nothing_and_pictures_do_not_pile_up(
    type_name: str, kept: int
) -> None:
    rig = Rig("p3dx", [ODOM])
    topic = rig.ros.subscription("/shared", type_name)
    for _ in range(64):
        rig.net.put(data_key(0, "/shared", type_name, types.HASHES[type_name]), b"")
    topic.take()
    assert topic.ear.refused == {("/shared", Reason.MALFORMED): kept}


def test_topics_that_nobody_publishes_are_named(caplog: pytest.LogCaptureFixture) -> None:
    rig = Rig("p3dx", [ODOM, BUMP])
    rig.ros.publisher("/odom", types.ODOMETRY)
    rig.ros.publisher("/bump", types.TWIST)
    with caplog.at_level(logging.WARNING):
        rig.step(6.0)
    assert "/odom" not in caplog.text
    assert "topic /bump (std_msgs/msg/Bool): expected std_msgs::msg::dds_::Bool_" in caplog.text
