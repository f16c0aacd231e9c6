"""Records in which everything is known: a joint that says the time, tasks, leaves, coloured pictures."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from tandem.executive.records.foxglove_view import put_picture
from tandem.executive.records.json_schemas import JsonSchemas
from tandem.executive.records.mcap_writing import McapFile
from tandem.executive.records.pictures import as_jpeg
from tandem.executive.records.recording import Attachment, Facts, Recorded
from tandem.skills.ports.hardware import BaseVelocity, JointStates, RgbdHeader, SetPoint
from tandem.skills.ports.image import RgbdImage, encode
from tandem.skills.ports.keys import (
    BASE_VELOCITY,
    DESCRIPTION,
    JOINT_STATES,
    group_setpoint,
    rgbd,
)
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TaskState, TaskStatus
from tandem.skills.ports.world import ROBOT_POSE, RobotPose
from tandem.skills.testing.mock_description import mock_description

FACTS = Facts(site="lab", robot="mock", scenario="Demo", seed=7, release="0.1.0", commit="c0ffee", began=0.0)
JOINTS = ("arm_left_joint", "arm_right_joint", "gripper_left_joint")
BLUE, RED = (0, 0, 255), (255, 0, 0)
STARTED, CLOSES, ENDED, LAST = 1.0, 2.5, 3.0, 4.0
"""Of the task: it starts with no leaf, drives from 1.5, closes from 2.5 and ends."""
STREAMED = (2.02, 2.48)
"""From when to when the right arm is streamed to, at 9 rad; it stands at 0."""


def stamp(at: float) -> RobotTime:
    return RobotTime(boot="b", seconds=at)


def message(key: str, at: float, said: Message) -> Recorded:
    return Recorded(key, at, stamp(at), round(at * 1e9), said.model_dump_json().encode())


def status(
    at: float, task: str = "fetch-0001", *leaves: str, state: TaskState = TaskState.RUNNING
) -> Recorded:
    ended = stamp(at) if state.terminal else None
    said = TaskStatus(
        task=task,
        kind="fetch",
        request={"task": "fetch", "item": 3, "to": "depot", "priority": 5},
        state=state,
        accepted_at=0.0,
        started=None if state is TaskState.QUEUED else stamp(STARTED),
        ended=ended,
        running=leaves,
    )
    return message(f"task/{task}/status", at, said)


def one_fetch() -> list[Recorded]:
    """Return the states of one task from start to end."""
    return [
        status(0.5, state=TaskState.QUEUED),
        status(STARTED),
        status(1.5, "fetch-0001", "drive to item"),
        status(CLOSES, "fetch-0001", "close", "watch the hand"),
        status(ENDED, state=TaskState.SUCCEEDED),
    ]


def motion(joints: tuple[str, ...] = JOINTS) -> Iterator[Recorded]:
    """Yield what the robot says of itself: the first joint stands where the time is, the base drives."""
    zeros = (0.0,) * (len(joints) - 1)
    for number in range(round(LAST * 20) + 1):
        at = round(number / 20, 9)
        joint = JointStates(
            stamp=stamp(at),
            names=joints,
            positions=(at, *zeros),
            velocities=(0.0, *zeros),
            efforts=(0.0, *zeros),
        )
        yield message(JOINT_STATES.key, at, joint)
        place = FloorPose(x=at / 10, y=0.0, yaw=0.5)
        pose = RobotPose(
            stamp=stamp(at),
            localised=True,
            base_in_map=place,
            odom_in_map=FloorPose(x=0.0, y=0.0, yaw=0.0),
            position_sigma=0.01,
            yaw_sigma=0.01,
            moving=True,
        )
        yield message(ROBOT_POSE.key, at, pose)
        if at < 2.0:
            yield message(BASE_VELOCITY.key, at, BaseVelocity(linear=0.1, angular=0.0))
        if STREAMED[0] <= at <= STREAMED[1]:
            point = SetPoint(stamp=stamp(at), positions=(9.0,), velocities=(0.0,))
            yield message(group_setpoint("arm_right").key, at, point)


def write_mcap(
    path: Path,
    messages: list[Recorded],
    *,
    cameras: tuple[str, ...] = ("head",),
    size: tuple[int, int] = (36, 64),
    facts: Facts = FACTS,
    shown: Callable[[float], bool] = lambda _: True,
) -> Path:
    """Write a recording: the messages in order, and five pictures a second, blue until 2 s, then red.

    ``shown`` says at which times there is one.
    """
    with path.open("wb") as file:
        made = McapFile(file, facts, 0.0, JsonSchemas().of)
        made.attach(Attachment(DESCRIPTION.key, 0.0, mock_description().model_dump_json().encode()))
        at = 0.0
        for each in sorted(messages, key=lambda one: one.at):
            made.put(each)
            while at <= each.at:
                for camera in cameras if shown(at) else ():
                    jpeg = picture(camera, BLUE if at < 2.0 - 1e-6 else RED, size)
                    put_picture(made, rgbd(camera), camera, jpeg, message("x", round(at, 9), stamp(at)))
                at += 0.2
        made.finish()
    return path


def picture(camera: str, colour: tuple[int, int, int], size: tuple[int, int]) -> bytes:
    height, width = size
    header = RgbdHeader(
        stamp=stamp(0.0), camera=camera, width=width, height=height, fx=50.0, fy=50.0, cx=1.0, cy=1.0
    )
    pixels = np.full((height, width, 3), colour, np.uint8)
    return as_jpeg(encode(RgbdImage(header, pixels, np.zeros((height, width), np.uint16))))
