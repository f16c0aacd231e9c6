"""A robot: whoever tells a description and serves the hardware's keys. This one has a left gripper alone.

The skill ``gripper_left/grip`` works with it as it is. In place of the arithmetic in ``_move`` a real robot's
driver would talk to its motors.
"""
# ruff: noqa: INP001 - an example: a file of its own

from __future__ import annotations

from typing import Final

from tandem.skills.ports.bus import Bus
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.hardware import Answer, Clock, GripperCommand, GripperMotion, GripperState, StopState
from tandem.skills.ports.keys import CLOCK, DESCRIPTION, STOP_STATE, gripper_command, gripper_state
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.serving import Endpoints

PERIOD: Final = 0.01
"""Seconds between two steps."""


class OneGripper:
    """A ``Node``: one step is one period of the hardware.

    Args:
        bus: where the skills are.
        description: who the robot is: its URDF, groups, hands, sensors, limits.
        boot: names this start of the hardware; its seconds count from here.
        between: metres of what lies between the pads.
    """

    name = "hardware"

    def __init__(self, bus: Bus, description: RobotDescription, *, boot: str, between: float = 0.0) -> None:
        self._bus, self._description, self._boot, self._between = bus, description, boot, between
        self._endpoints = Endpoints(
            bus,
            lambda: self._tick * PERIOD,
            (
                answering(DESCRIPTION, lambda _: self._description),
                answering(gripper_command("left"), self._take),
            ),
        )
        self._gripper = description.end_effector("left").gripper
        self._width = self._gripper.max_width
        self._command: GripperCommand | None = None
        self._tick = 0

    def step(self) -> bool:
        """Hear, move, tell; the clock last, so that what belongs to a tick has come before it."""
        self._tick += 1
        stamp = RobotTime(boot=self._boot, seconds=self._tick * PERIOD)
        self._endpoints.step()
        gripper_state("left").publish(self._bus, self._move(stamp))
        STOP_STATE.publish(self._bus, StopState(stopped=False))
        CLOCK.publish(self._bus, Clock(stamp=stamp, tick=self._tick))
        return False

    def close(self) -> None:
        """Stop serving."""
        self._endpoints.close()

    def _take(self, command: GripperCommand) -> Answer:
        self._command = command
        return Answer(accepted=True)

    def _move(self, stamp: RobotTime) -> GripperState:
        command = self._command
        motion, force = GripperMotion.IDLE, 0.0
        if command is not None:
            step = command.speed * PERIOD
            wanted = max(command.width, self._width - step) if command.width < self._width else (
                min(command.width, self._width + step)
            )  # fmt: skip
            stalled = wanted < self._between <= self._width
            self._width = self._between if stalled else wanted
            force = command.force if stalled else 0.0
            there = GripperMotion.AT_WIDTH if self._width == command.width else GripperMotion.MOVING
            motion = GripperMotion.STALLED if stalled else there
        return GripperState(
            stamp=stamp,
            side="left",
            command_id="" if command is None else command.id,
            motion=motion,
            width=self._width,
            force=force,
        )
