"""What gets in from the bus, and what is refused and counted."""

from __future__ import annotations

import json
import logging

import pytest

from tandem.skills.ports.hardware import (
    Clock,
    GroupStatus,
    JointStates,
    MotionState,
    RgbdHeader,
    SetPoint,
    StopState,
)
from tandem.skills.ports.hearing import KINDS, Ear, Heard, Reason
from tandem.skills.ports.image import header_of
from tandem.skills.ports.keys import (
    BUMPERS,
    CLIFFS,
    CLOCK,
    JOINT_STATES,
    POSE_READING,
    RANGES,
    ROBOTS_SEEN,
    Latest,
    Topic,
    group_setpoint,
    group_status,
    laser,
    rgbd,
)
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.pose import IDENTITY, FloorPose
from tandem.skills.ports.refusals import CHANGED_EVERY, REPEATED_EVERY, RefusalTeller
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import (
    Bumpers,
    Cliffs,
    LaserScan,
    PoseReading,
    RangeReading,
    Ranges,
    RobotsSeen,
)
from tandem.skills.ports.world import (
    SCENE,
    WORLD,
    Box,
    HeldItem,
    ItemFact,
    PlanningScene,
    SceneObject,
    WorldState,
)
from tandem.skills.testing.mock_description import mock_description
from tandem.skills.wire.memory import MemoryBus, MemoryHub

ROBOT = mock_description()
JOINTS = tuple(sorted(ROBOT.joints))


def at(seconds: float, boot: str = "b") -> RobotTime:
    return RobotTime(boot=boot, seconds=seconds)


def states(seconds: float, names: tuple[str, ...] = JOINTS) -> JointStates:
    zeros = tuple(0.0 for _ in names)
    return JointStates(stamp=at(seconds), names=names, positions=zeros, velocities=zeros, efforts=zeros)


CARRIED = SceneObject(
    name="item_1",
    kind="item",
    box=Box(size=(0.1, 0.1, 0.1), pose=IDENTITY),
    item=1,
    attached_to="tail",
)
HELD = ItemFact(
    item=1,
    size=(0.1, 0.1, 0.1),
    tag_in_map=IDENTITY,
    seen=at(1),
    quality=1.0,
    position_sigma=0.0,
    held="tail",
)


class Stand:
    """One who tells, and one who hears and knows the robot."""

    def __init__(self) -> None:
        hub = MemoryHub()
        self.teller, self.bus = MemoryBus(hub), MemoryBus(hub)
        self.bus.ear.know(ROBOT)

    def refused(self) -> dict[tuple[str, Reason], int]:
        return dict(self.bus.ear.refused)


@pytest.fixture
def stand() -> Stand:
    return Stand()


def document(**other: object) -> bytes:
    return json.dumps(states(1.0).model_dump(mode="json") | other).encode()


@pytest.mark.parametrize(
    ("payload", "reason"),
    [
        (b"", Reason.MALFORMED),
        (b"\xff\x00", Reason.MALFORMED),
        (b"[" * 10_000, Reason.MALFORMED),
        (b'{"stamp": null}', Reason.MALFORMED),
        (document(velocities=[]), Reason.MALFORMED),
        (document(names=[JOINTS[0]] * len(JOINTS)), Reason.MALFORMED),
        (document(positions=[1e300] * len(JOINTS)), Reason.MALFORMED),
        (document().replace(b"0.0", b"NaN", 1), Reason.MALFORMED),
        (states(1.0, JOINTS[1:]).model_dump_json().encode(), Reason.MISFIT),
        (states(1.0, (*JOINTS, "tail")).model_dump_json().encode(), Reason.MISFIT),
        (states(1.0, ()).model_dump_json().encode(), Reason.MISFIT),
    ],
)
def test_a_wrong_message_is_silence(stand: Stand, payload: bytes, reason: Reason) -> None:
    latest, all_of_them = Latest(stand.bus, JOINT_STATES), Latest(stand.bus, JOINT_STATES)
    stand.teller.publish(JOINT_STATES.key, payload)
    assert (latest.refresh(), all_of_them.take()) == (None, [])
    assert stand.refused() == {(JOINT_STATES.key, reason): 2}
    JOINT_STATES.publish(stand.teller, states(1.0))
    stand.teller.publish(JOINT_STATES.key, payload)
    assert latest.refresh() == states(1.0)
    assert all_of_them.take() == [states(1.0)]


@pytest.mark.parametrize(
    ("topic", "message"),
    [
        (
            group_status("arm_left"),
            GroupStatus(stamp=at(1), group="arm_right", goal_id="", state=MotionState.ACTIVE),
        ),
        (group_status("tail"), GroupStatus(stamp=at(1), group="tail", goal_id="", state=MotionState.ACTIVE)),
        (group_setpoint("arm_left"), SetPoint(stamp=at(1), positions=(0.0,) * 9, velocities=(0.0,) * 9)),
        (laser("base"), LaserScan(stamp=at(1), ranges=(1.0,))),
        (laser("tail"), LaserScan(stamp=at(1), ranges=(1.0,) * ROBOT.laser.beams)),
        (RANGES, Ranges(stamp=at(1), readings=(RangeReading(sensor="tail", distance=1.0),))),
        (RANGES, Ranges(stamp=at(1), readings=(RangeReading(sensor="front", distance=0.1),))),
        (CLIFFS, Cliffs(stamp=at(1), readings=(RangeReading(sensor="tail", distance=0.03),))),
        (POSE_READING, PoseReading(stamp=at(1), sensor="tail", base_in_map=FloorPose(x=0, y=0, yaw=0))),
        (ROBOTS_SEEN, RobotsSeen(stamp=at(1), sensor="tail", robots=())),
        (SCENE, PlanningScene(stamp=at(1), version=1, objects=(CARRIED,))),
        (
            WORLD,
            WorldState(stamp=at(1), version=1, held=(HeldItem(side="tail", item=1, item_in_tool=IDENTITY),)),
        ),
        (WORLD, WorldState(stamp=at(1), version=1, items=(HELD,))),
    ],
    ids=[
        "another group's",
        "no group of the robot",
        "too many joints",
        "too few beams",
        "no laser of the robot",
        "no range sensor of the robot",
        "nearer than the sensor can see",
        "no cliff sensor of the robot",
        "no pose sensor of the robot",
        "no robot sensor of the robot",
        "carried by no hand of the robot",
        "no hand of the robot is full",
        "held by no hand of the robot",
    ],
)
def test_what_does_not_fit_key_or_robot_is_refused(
    stand: Stand, topic: Topic[Message], message: Message
) -> None:
    latest = Latest(stand.bus, topic)
    topic.publish(stand.teller, message)
    assert latest.refresh() is None
    assert stand.refused() == {(topic.key, Reason.MISFIT): 1}


def test_a_picture_on_the_key_of_another_camera_is_silence(stand: Stand) -> None:
    pictures: Heard[RgbdHeader] = Heard(stand.bus, rgbd("tail"), header_of)
    stand.teller.publish(rgbd("tail"), picture())
    assert pictures.take() == []
    assert stand.refused() == {(rgbd("tail"), Reason.MISFIT): 1}


def picture(**other: object) -> bytes:
    camera = ROBOT.camera
    header = {"stamp": {"boot": "b", "seconds": 1.0}, "camera": camera.name, "width": camera.width}
    header |= {"height": camera.height, "fx": 500.0, "fy": 500.0, "cx": 0.0, "cy": 0.0} | other
    text = json.dumps(header).encode()
    pixels = camera.width * camera.height * 5
    return len(text).to_bytes(4, "little") + text + bytes(pixels)


@pytest.mark.parametrize(
    ("payload", "reason"),
    [
        (b"", Reason.MALFORMED),
        (b"\xff\xff\xff\xff", Reason.MALFORMED),
        (picture()[:-1], Reason.MALFORMED),
        (picture(fx=float("nan")), Reason.MALFORMED),
        (picture(width=-1, height=-1), Reason.MALFORMED),
        (picture(width=1 << 40), Reason.MALFORMED),
        (picture(camera="tail"), Reason.MISFIT),
        (picture(width=ROBOT.camera.height, height=ROBOT.camera.width), Reason.MISFIT),
    ],
)
def test_a_wrong_picture_is_silence(stand: Stand, payload: bytes, reason: Reason) -> None:
    pictures: Heard[RgbdHeader] = Heard(stand.bus, rgbd("head"), header_of)
    stand.teller.publish(rgbd("head"), payload)
    assert pictures.take() == []
    assert stand.refused() == {(rgbd("head"), reason): 1}
    stand.teller.publish(rgbd("head"), picture())
    assert [header.camera for _, header, _ in pictures.take()] == [ROBOT.camera.name]


def clocks(stand: Stand, latest: Latest[Clock], *seconds: float, boot: str = "b") -> list[float]:
    for each in seconds:
        CLOCK.publish(stand.teller, Clock(stamp=at(each, boot), tick=0))
    return [clock.stamp.seconds for clock in latest.take()]


def test_stamps_do_not_run_backwards_within_a_boot(stand: Stand) -> None:
    latest = Latest(stand.bus, CLOCK)
    assert clocks(stand, latest, 1.0, 2.0, 1.5, 2.0, 3.0) == [1.0, 2.0, 2.0, 3.0]
    assert stand.refused() == {(CLOCK.key, Reason.OLDER): 1}
    assert clocks(stand, latest, 0.5, boot="another") == [0.5]


def test_one_message_from_the_future_does_not_end_the_stream(stand: Stand) -> None:
    latest, newest = Latest(stand.bus, CLOCK), Latest(stand.bus, CLOCK)
    assert clocks(stand, latest, 1.0, 1e8, 1.1, 1.2, 1.3, 1.4) == [1.0, 1e8, 1.3, 1.4]
    for each in (1.0, 1e8, 1.1, 1.2, 1.3):
        CLOCK.publish(stand.teller, Clock(stamp=at(each), tick=0))
        newest.refresh()
    assert newest.value is not None
    assert newest.value.stamp == at(1.3)


def test_what_has_no_stamp_is_taken_as_it_comes(stand: Stand) -> None:
    topic = Topic("hw/stop/state", StopState)
    latest = Latest(stand.bus, topic)
    topic.publish(stand.teller, StopState(stopped=True))
    assert latest.take() == [StopState(stopped=True)]


def test_refusals_are_logged_once_a_minute_for_each_key_and_reason(caplog: pytest.LogCaptureFixture) -> None:
    now = [0.0]
    ear = Ear(lambda: now[0])
    with caplog.at_level(logging.WARNING):
        for each in range(130):
            now[0] = float(each)
            ear.refuse("hw/clock", Reason.MALFORMED, "no clock")
        ear.refuse("hw/clock", Reason.OLDER, "an old one")
    told = [(record.__dict__["reason"], record.__dict__["count"]) for record in caplog.records]
    assert told == [("malformed", 1), ("malformed", 61), ("malformed", 121), ("older", 1)]


def test_made_up_keys_take_no_room() -> None:
    ear = Ear()
    for each in range(10 * KINDS):
        ear.refuse(f"skill/{each}/status", Reason.MALFORMED, "")
    assert len(ear.refused) == KINDS + 1
    assert ear.total == sum(ear.refused.values()) == 10 * KINDS


def test_refusals_are_told_when_there_are_more_and_repeated_for_who_comes_late() -> None:
    ear = Ear()
    teller = RefusalTeller(ear)
    assert teller.due("base", 0.0) is None
    ear.refuse("hw/clock", Reason.OLDER, "")
    told = teller.due("base", 0.0)
    assert told is not None
    assert [(each.key, each.reason, each.count) for each in told.refused] == [("hw/clock", Reason.OLDER, 1)]
    ear.refuse("hw/clock", Reason.OLDER, "")
    assert teller.due("base", CHANGED_EVERY / 2) is None
    assert teller.due("base", CHANGED_EVERY) is not None
    assert teller.due("base", CHANGED_EVERY * 3) is None
    assert teller.due("base", CHANGED_EVERY + REPEATED_EVERY) is not None


def test_what_several_nodes_hear_is_read_once(stand: Stand, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[bytes] = []
    decode = Topic.decode
    monkeypatch.setattr(Topic, "decode", lambda topic, body: read.append(body) or decode(topic, body))
    one, other = Latest(stand.bus, JOINT_STATES), Latest(stand.bus, JOINT_STATES)
    JOINT_STATES.publish(stand.teller, states(1.0))
    assert one.take() == other.take() == [states(1.0)]
    assert len(read) == 1


def test_what_was_read_for_another_robot_is_checked_again(stand: Stand) -> None:
    latest, later = Latest(stand.bus, JOINT_STATES), Latest(stand.bus, JOINT_STATES)
    JOINT_STATES.publish(stand.teller, states(1.0))
    assert latest.take()
    other = ROBOT.model_dump(mode="json")
    stand.bus.ear.know(
        RobotDescription.model_validate_json(json.dumps({**other, "groups": other["groups"][:1]}))
    )
    assert not later.take()


def test_a_late_message_hides_no_newer_one_that_arrived_before_it() -> None:
    """A network that delivers some messages twice must not silence a stream."""
    hub = MemoryHub()
    teller, bus = MemoryBus(hub), MemoryBus(hub)
    latest = Latest(bus, JOINT_STATES)
    JOINT_STATES.publish(teller, states(0.5))
    JOINT_STATES.publish(teller, states(1.0))
    assert latest.refresh() == states(1.0)
    for seconds in (1.1, 1.2, 0.5):
        JOINT_STATES.publish(teller, states(seconds))
    assert latest.refresh() == states(1.2)
    assert bus.ear.refused == {(JOINT_STATES.key, Reason.OLDER): 1}


def test_sensors_that_share_a_topic_each_have_an_order_of_their_own() -> None:
    """A slow sensor's readings were all refused beside those of a quick one."""
    hub = MemoryHub()
    teller, bus = MemoryBus(hub), MemoryBus(hub)
    latest = Latest(bus, POSE_READING)
    told = [("ceiling", 1.0), ("beacon", 0.8), ("ceiling", 1.1), ("beacon", 0.9), ("beacon", 0.7)]
    for sensor, seconds in told:
        POSE_READING.publish(
            teller,
            PoseReading(stamp=at(seconds), sensor=sensor, base_in_map=FloorPose(x=0.0, y=0.0, yaw=0.0)),
        )
    assert [(each.sensor, each.stamp) for each in latest.take()] == [
        (sensor, at(seconds)) for sensor, seconds in told[:-1]
    ]
    assert bus.ear.refused == {(POSE_READING.key, Reason.OLDER): 1}


def test_a_bumper_that_the_robot_does_not_have_stops_nobody() -> None:
    hub = MemoryHub()
    teller, bus = MemoryBus(hub), MemoryBus(hub)
    bus.ear.know(ROBOT)
    latest = Latest(bus, BUMPERS)
    BUMPERS.publish(teller, Bumpers(stamp=at(1.0), pressed=("tail",)))
    assert latest.take() == []
    assert bus.ear.refused == {(BUMPERS.key, Reason.MISFIT): 1}


def test_a_check_that_raises_costs_its_message_and_the_log_has_the_trace(
    caplog: pytest.LogCaptureFixture,
) -> None:
    def broken(payload: bytes) -> Clock:
        raise IndexError(payload)

    hub = MemoryHub()
    bus = MemoryBus(hub)
    heard = Heard(bus, "hw/*", broken)
    MemoryBus(hub).publish("hw/clock", b"{}")
    assert heard.take() == []
    assert bus.ear.refused == {("hw/clock", Reason.MALFORMED): 1}
    assert "IndexError" in caplog.text
