"""MCAP as a recording writes it: survives kill -9 in mid-write, and has what Foxglove draws by itself."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from mocked_fetch import FACTS
from synthetic_record import motion, one_fetch, write_mcap

from tandem.executive.records.cutting import cut
from tandem.executive.records.foxglove_view import FoxgloveView, put_picture
from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.mcap_file import picture_in
from tandem.executive.records.mcap_writing import McapFile
from tandem.executive.records.pictures import as_jpeg
from tandem.executive.records.recording import Attachment, Recorded, Span, open_recording
from tandem.executive.records.recovering import recover
from tandem.skills.ports.hardware import JointStates, RgbdHeader, StopState
from tandem.skills.ports.image import RgbdImage, encode
from tandem.skills.ports.keys import DESCRIPTION, JOINT_STATES, STOP_STATE
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.pose import IDENTITY, FloorPose
from tandem.skills.ports.sensors import LaserScan
from tandem.skills.ports.world import ROBOT_POSE, SCENE, Box, PlanningScene, RobotPose, SceneObject
from tandem.skills.testing.mock_description import mock_description

STAMP = RobotTime(boot="b", seconds=1.5)
WRITES = """
import os, signal, sys
from pathlib import Path
from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.recording import Facts, Recorded
from tandem.executive.records.recording_sink import RecordingSink
from tandem.skills.ports.message import RobotTime
from tandem.skills.wire.clocks import SteppedClocks

clocks = SteppedClocks()
facts = Facts(site="lab", robot="tiago", release="0", began=0.0)
sink = RecordingSink(Path(sys.argv[1]), facts, clocks, schema_of=JsonSchemas().of, tell=lambda _: None)
for number in range(1, 1000):
    clocks.advance(0.1)
    at = round(number / 10, 9)
    sink.take([Recorded("hw/clock", at, RobotTime(boot="b", seconds=at), number, b"{}")])
    if number == 555:
        os.kill(os.getpid(), signal.SIGKILL)
"""


def test_kill_9_in_mid_write_costs_a_second_at_the_most(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-c", WRITES, str(tmp_path)], check=False)
    assert done.returncode == -9
    (path,) = tmp_path.iterdir()
    mended = tmp_path / "mended.mcap"
    recover(path, mended)
    record = open_recording(mended)
    times = [each.at for each in record.messages()]
    assert times == [round(each / 10, 9) for each in range(1, len(times) + 1)]
    assert 54.5 <= times[-1] <= 55.5
    record.close()


def said(key: str, message: Message) -> Recorded:
    return Recorded(key, 1.5, STAMP, 7, message.model_dump_json().encode())


SHOWN: list[tuple[str, Message, str, str]] = [
    (
        JOINT_STATES.key,
        JointStates(stamp=STAMP, names=("a",), positions=(0.5,), velocities=(0.0,), efforts=(0.0,)),
        "foxglove/joints",
        "foxglove.JointStates",
    ),
    (
        ROBOT_POSE.key,
        RobotPose(
            stamp=STAMP,
            localised=True,
            base_in_map=FloorPose(x=1.0, y=2.0, yaw=0.3),
            odom_in_map=FloorPose(x=0.0, y=0.0, yaw=0.0),
            position_sigma=0.01,
            yaw_sigma=0.01,
            moving=False,
        ),
        "foxglove/transforms",
        "foxglove.FrameTransforms",
    ),
    (
        SCENE.key,
        PlanningScene(
            stamp=STAMP,
            version=1,
            objects=(SceneObject(name="t", kind="furniture", box=Box(size=(1, 1, 1), pose=IDENTITY)),),
        ),
        "foxglove/scene",
        "foxglove.SceneUpdate",
    ),
    ("hw/base/laser", LaserScan(stamp=STAMP, ranges=(1.0, 2.0)), "foxglove/base", "foxglove.LaserScan"),
    (STOP_STATE.key, StopState(stopped=True, by="anna"), "foxglove/log", "foxglove.Log"),
]


@pytest.mark.parametrize(("key", "message", "topic", "schema"), SHOWN, ids=[each[2] for each in SHOWN])
def test_foxglove_finds_its_own_messages(
    key: str, message: Message, topic: str, schema: str, tmp_path: Path
) -> None:
    from mcap.reader import make_reader  # noqa: PLC0415

    path = tmp_path / "run.mcap"
    view = FoxgloveView()
    view.learn(Attachment(DESCRIPTION.key, 0.0, mock_description().model_dump_json().encode()))
    with path.open("wb") as file:
        made = McapFile(file, FACTS, 1.5, JsonSchemas().of)
        made.put(said(key, message))
        view(made, said(key, message))
        made.finish()
    with path.open("rb") as file:
        found = {
            channel.topic: (known.name, known.encoding, told.log_time)
            for known, channel, told in make_reader(file).iter_messages()
            if known is not None
        }
    assert found[topic] == (schema, "protobuf", 1_500_000_000)
    assert found[key] == (f"tandem.{type(message).__name__}", "jsonschema", 1_500_000_000)
    record = open_recording(path)
    assert [each.key for each in record.messages()] == [key]
    record.close()


def test_the_scene_has_cylinders_and_what_hands_hold() -> None:
    view = FoxgloveView()
    robot = mock_description()
    view.learn(Attachment(DESCRIPTION.key, 0.0, robot.model_dump_json().encode()))
    hand = robot.end_effectors[0]

    def drawn(*objects: SceneObject) -> dict[str, tuple[str, int, int]]:
        told = PlanningScene(stamp=STAMP, version=1, objects=objects)
        update = view.scene(said(SCENE.key, told))
        # The vendor's messages show their fields in their text only.
        _, *entities = repr(update).split("SceneEntity {")
        return {
            re.findall(r' id: "([^"]+)"', each)[0]: (
                re.findall(r'frame_id: "([^"]+)"', each)[0],
                each.count("CubePrimitive {"),
                each.count("CylinderPrimitive {"),
            )
            for each in entities
        }

    size = (0.06, 0.06, 0.1)
    tin = SceneObject(name="i", kind="item", box=Box(size=size, pose=IDENTITY, shape="cylinder"), item=3)
    table = SceneObject(name="t", kind="furniture", box=Box(size=(1, 1, 1), pose=IDENTITY))
    nothing = {f"held/{each.side}": (each.frame, 0, 0) for each in robot.end_effectors}
    assert drawn(table, tin) == {**nothing, "scene": ("map", 1, 1)}
    held = tin.model_copy(update={"attached_to": hand.side})
    assert drawn(table, held) == {**nothing, "scene": ("map", 1, 0), f"held/{hand.side}": (hand.frame, 0, 1)}


def picture(width: int, height: int) -> bytes:
    header = RgbdHeader(
        stamp=STAMP, camera="head", width=width, height=height, fx=1.0, fy=1.0, cx=0.0, cy=0.0
    )
    colour = np.zeros((height, width, 3), np.uint8)
    colour[:, :, 0] = 200
    return encode(RgbdImage(header, colour, np.zeros((height, width), np.uint16)))


def test_pictures_are_read_back_as_jpeg(tmp_path: Path) -> None:
    jpeg = as_jpeg(picture(1280, 720))
    path = tmp_path / "run.mcap"
    when = said(STOP_STATE.key, StopState(stopped=False))
    with path.open("wb") as file:
        made = McapFile(file, FACTS, 1.5, JsonSchemas().of)
        put_picture(made, "hw/camera/head/rgbd", "head", jpeg, when)
        made.finish()
    record = open_recording(path)
    (found,) = record.pictures()
    assert (found.key, found.at, found.stamp, found.payload) == ("hw/camera/head/rgbd", 1.5, STAMP, jpeg)
    assert jpeg[:2] == b"\xff\xd8"
    assert list(record.messages()) == []
    record.close()


def test_what_is_no_picture_is_none() -> None:
    assert as_jpeg(b"not a picture") == b""
    assert picture_in(b"") == b""


def test_a_part_keeps_its_pictures(tmp_path: Path) -> None:
    whole = open_recording(write_mcap(tmp_path / "a.mcap", [*motion(), *one_fetch()]))
    cut(whole, tmp_path / "part.mcap", Span(2.1, 3.0))
    part = open_recording(tmp_path / "part.mcap")
    kept, expected = list(part.pictures()), list(whole.pictures(2.0, 3.0))
    assert [(each.key, each.at, each.payload) for each in kept] == [
        (each.key, each.at, each.payload) for each in expected
    ]
    assert kept[0].at == 2.0, "what the camera had shown last"
    for record in (whole, part):
        record.close()
