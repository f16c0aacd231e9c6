"""Clauses about the states of groups, grippers and the stop."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import MotionState

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench

BEYOND: Final = 0.005
"""Metres by which a width may be beyond closed or open: soft pads give way."""


def _groups(bench: Bench) -> Steps:
    if not bench.robot.groups:
        raise Skip("the robot has no joint groups")
    for group in bench.robot.groups:
        topic = keys.group_status(group.name)
        status = bench.recording.latest(topic)
        if status is None:
            raise Broken(f"a status on {topic.key} each second", "none")
        if status.state is MotionState.ACTIVE and status.at_rest:
            raise Broken(f"{group.name} not at rest while a goal is ACTIVE", "at_rest")
    yield


def _grippers(bench: Bench) -> Steps:
    if not bench.robot.hands:
        raise Skip("the robot has no hands")
    for hand in bench.robot.end_effectors:
        topic = keys.gripper_state(hand.side)
        states = bench.recording.messages(topic)
        if not states:
            raise Broken(f"states on {topic.key}", "none")
        for state in states:
            least, most = hand.gripper.min_width, hand.gripper.max_width
            if not least - BEYOND <= state.width <= most + BEYOND:
                raise Broken(f"widths of {hand.side} from {least:g} to {most:g} m", f"{state.width:.4f} m")
    yield


def _stop(bench: Bench) -> Steps:
    if bench.recording.latest(keys.STOP_STATE) is None:
        raise Broken(f"the stop's state on {keys.STOP_STATE.key}, for those who connect later", "none")
    yield


CLAUSES: Final = (
    Clause(
        "group_status_told",
        "Each group tells its status on each change and once a second.",
        "interface.md#groupstatus",
        _groups,
    ),
    Clause(
        "gripper_state_told",
        "Each gripper tells its state, with a width from closed to open.",
        "interface.md#gripperstate",
        _grippers,
    ),
    Clause(
        "stop_state_told",
        "Whether the stop is set is told on each change and once a second.",
        "interface.md#hardware",
        _stop,
    ),
)
