"""A parallel gripper's controller: closes until a width or until it stalls, then keeps on squeezing.

Why it holds: docs/decisions/001-grasp-by-friction.md.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import Final

from tandem.skills.ports.hardware import Answer, GripperCommand, GripperMotion
from tandem.skills.ports.robot_description import Gripper

WIDTH_TOLERANCE: Final = 0.001
"""Metres of width within which a command is done."""
STALL_TIME: Final = 0.12
"""Seconds over which the width is watched for a stall."""
STALL_TRAVEL: Final = 0.0005
"""Metres: less travel than this in that time is a stall."""
FOLLOW_GAIN: Final = 5.0
"""1/s: how fast a finger closes in on its reference."""
SQUEEZE_SPEED: Final = 0.03
"""m/s that the pushing finger strives for when stalled; its force limit is what it exerts."""
LOST_TRAVEL: Final = 0.003
"""Metres of closing after a stall that mean the item is gone."""
SELF_LOCK: Final = 200.0
"""N that a standing finger's spindle withstands."""
LEAD: Final = 0.01
"""Metres by which a finger's reference may run ahead of the finger."""


@dataclass(frozen=True)
class FingerDrive:
    """For each finger, inner first: speed in m/s (positive opens) and the most that the motor exerts, N."""

    speeds: tuple[float, float]
    forces: tuple[float, float]


@dataclass(frozen=True)
class HandDefects:
    """What is wrong with a hand: fingers that stay, come apart, or have a share of their force."""

    stuck: bool = False
    opens: bool = False
    force: float = 1.0

    def bend(self, drive: FingerDrive, speed: float, force: float) -> FingerDrive:
        """Return what the motors do instead; ``speed`` (m/s) and ``force`` (N) are a finger's most."""
        if self.stuck:
            return FingerDrive((0.0, 0.0), (SELF_LOCK, SELF_LOCK))
        if self.opens:
            return FingerDrive((speed, speed), (force, force))
        return FingerDrive(drive.speeds, (self.force * drive.forces[0], self.force * drive.forces[1]))


SOUND: Final = HandDefects()


class GripperController:
    """Drives the two fingers of one hand, each by its own motor, both along one reference.

    Args:
        gripper: limits of the hand.
        fingers: where the inner and the outer finger are, in metres from closed.
    """

    def __init__(self, gripper: Gripper, fingers: tuple[float, float]) -> None:
        self._gripper = gripper
        self._reference = sum(fingers) / 2.0
        self._target = self._reference
        self._speed = gripper.speed
        self._force = gripper.force
        self._widths: deque[float] = deque()
        self._stall_width = 0.0
        self._outer_lock: float | None = None
        self.command_id = ""
        self.motion = GripperMotion.IDLE
        self.width = sum(fingers)
        self.force = 0.0

    @property
    def squeezing(self) -> bool:
        """Whether something is held: the fingers closed on it and go on pressing."""
        return self.motion is GripperMotion.STALLED and self._outer_lock is not None

    def accept(self, command: GripperCommand) -> Answer:
        """Start the command in place of the last, or say why not. One that is known goes on."""
        if command.id == self.command_id:
            return Answer(accepted=True, reason="known already")
        if command.width > self._gripper.max_width + WIDTH_TOLERANCE:
            return Answer(accepted=False, reason=f"width: at most {self._gripper.max_width} m")
        self.command_id = command.id
        self._target = min(command.width, self._gripper.max_width) / 2.0
        self._speed = min(command.speed, self._gripper.speed)
        self._force = min(command.force, self._gripper.force)
        self._move_from(self.width / 2.0)
        return Answer(accepted=True)

    def stop(self) -> None:
        """Stand still; what is held is held on to."""
        if self.motion is GripperMotion.MOVING:
            self._target = self._reference = self.width / 2.0
            self.motion = GripperMotion.IDLE

    def _move_from(self, reference: float) -> None:
        self._reference = reference
        self._widths.clear()
        self._outer_lock = None
        self.motion = GripperMotion.MOVING

    def advance(
        self, period: float, fingers: tuple[float, float], efforts: tuple[float, float]
    ) -> FingerDrive:
        """Judge the last period's positions (m) and motor forces (N), and return what to do in the next."""
        self.width = fingers[0] + fingers[1]
        stalled = self.motion is GripperMotion.STALLED
        self.force = max(0.0, -efforts[0]) if self.squeezing else 0.0
        if stalled and self._stall_width - self.width > LOST_TRAVEL:
            self._move_from(self.width / 2.0)
        if self.motion is GripperMotion.MOVING:
            self._judge(period, fingers)
        if self.motion is GripperMotion.STALLED and self._outer_lock is not None:
            hold = 20.0 * (self._outer_lock - fingers[1])
            return FingerDrive((-SQUEEZE_SPEED, hold), (self._force, SELF_LOCK))
        return self._track(period, fingers)

    def _judge(self, period: float, fingers: tuple[float, float]) -> None:
        if abs(self.width - 2.0 * self._target) <= WIDTH_TOLERANCE:
            self.motion = GripperMotion.AT_WIDTH
            return
        self._widths.append(self.width)
        if len(self._widths) * period <= STALL_TIME:
            return
        if abs(self._widths.popleft() - self.width) >= STALL_TRAVEL:
            return
        self.motion = GripperMotion.STALLED
        self._stall_width = self.width
        self._outer_lock = fingers[1] if self.width > 2.0 * self._target else None
        if self._outer_lock is None:
            self._reference = self._target = self.width / 2.0

    def _track(self, period: float, fingers: tuple[float, float]) -> FingerDrive:
        step = self._speed / 2.0 * period
        before = self._reference
        middle = self.width / 2.0
        wish = min(max(self._target, before - step), before + step)
        self._reference = min(max(wish, middle - LEAD), middle + LEAD)
        feed = (self._reference - before) / period
        top = self._gripper.speed / 2.0
        first, second = (min(max(feed + FOLLOW_GAIN * (before - at), -top), top) for at in fingers)
        return FingerDrive((first, second), (self._force, self._force))
