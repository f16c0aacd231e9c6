"""The camera's next picture for whoever asks."""

from __future__ import annotations

import cv2
import numpy as np

from tandem.skills.perception.snapshot import Snapshots
from tandem.skills.ports.actions.perception import PICTURE, AskView
from tandem.skills.ports.hearing import Reason
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.keys import rgbd
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.wire.workers import InlineCompute
from tests.skills.perception.pictures import picture
from tests.skills.perception.stage import Stage


def painter(_: Pose, now: RobotTime) -> RgbdImage:
    image = picture((), np.random.default_rng(1), seconds=now.seconds)
    red = np.zeros_like(image.colour)
    red[..., 0] = 200
    return RgbdImage(image.header, red, image.depth)


def ask(stage: Stage, seconds: float = 1.5) -> bytes | None:
    node = Snapshots(stage.bus, stage.clocks, InlineCompute(stage.clocks), ("head",))
    node.step()
    assert not stage.bus.listened(rgbd("head")), "nobody asked"
    pending = stage.bus.query(PICTURE, b"")
    for _ in range(round(seconds / 0.01)):
        stage.step()
        node.step()
        if (answer := pending.poll()) is not None:
            assert not stage.bus.listened(rgbd("head")), "it goes on listening"
            return answer
    return None


def test_the_next_picture_comes_as_jpeg_in_its_colours() -> None:
    answer = ask(Stage(painter))
    assert answer is not None
    image = cv2.imdecode(np.frombuffer(answer, np.uint8), cv2.IMREAD_COLOR)
    assert image is not None
    assert image.shape == (360, 640, 3)
    blue, green, red = image.reshape(-1, 3).mean(axis=0)
    assert red > 190
    assert max(blue, green) < 10


def test_a_silent_camera_gives_nothing_within_its_time() -> None:
    assert ask(Stage(painter, camera_works=False), seconds=1.1) == b""


def test_a_camera_is_chosen_by_its_name() -> None:
    stage = Stage(painter)
    node = Snapshots(stage.bus, stage.clocks, InlineCompute(stage.clocks), ("head", "wrist"))
    wrist, unknown = (
        stage.bus.query(PICTURE, AskView(camera=name).model_dump_json().encode())
        for name in ("wrist", "tail")
    )
    node.step()
    assert (stage.bus.listened(rgbd("wrist")), stage.bus.listened(rgbd("head"))) == (True, False)
    assert (wrist.poll(), unknown.poll()) == (None, b"")
    node.close()
    assert wrist.poll() == b""


def test_what_is_no_picture_is_not_taken_for_the_next_one() -> None:
    stage = Stage(painter, camera_works=False)
    node = Snapshots(stage.bus, stage.clocks, InlineCompute(stage.clocks), ("head",))
    pending = stage.bus.query(PICTURE, b"")
    node.step()
    for payload in (b"", b"\x01\x00\x00\x00{", b"\xff" * 100):
        stage.bus.publish(rgbd("head"), payload)
        stage.step()
        node.step()
        assert pending.poll() is None
    assert stage.bus.ear.refused[(rgbd("head"), Reason.MALFORMED)] == 3
