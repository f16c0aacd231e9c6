"""What the coordination sees of both arms, out of what joints, approaches and the reflex tell."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tandem.skills.bimanual.coordination import ArmNow
from tandem.skills.geometry.chain import Chain
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.approach import ApproachPhase, ApproachStatus, approach_status
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import HandName, RobotTimer
from tandem.skills.ports.robot_description import ArmsCrossing, RobotDescription

STILL: Final = 0.02
"""rad/s below which a joint stands."""
SAFE_WITHIN: Final = 0.10
"""Radians by which an arm may be off its safe posture and still be in its safe place."""
ASIDE: Final = 0.05
"""Metres by which a hand that holds something may be off its safe point."""
SILENT_AFTER: Final = 0.5
"""Robot seconds after which an approach that tells nothing is taken for ended."""
WAITS_AFTER: Final = 2.0
"""Robot seconds for which an arm without a field must have stood to be waiting: longer than a grasp."""
EVERY: Final = 0.1
"""Robot seconds between two positions that are remembered of an approach."""


class ArmObserver:
    """Watches one arm.

    Args:
        bus: where the arm tells of its approach.
        description: the robot.
        how: names the safe posture.
        side: which arm.
    """

    def __init__(self, bus: Bus, description: RobotDescription, how: ArmsCrossing, side: HandName) -> None:
        group = description.group(description.end_effector(side).group)
        self.side, self.group, self.joints = side, group.name, group.joints
        self.safe_at: Array = np.array(description.posture(group.name, how.safe_posture).positions)
        self._approach = Latest(bus, approach_status(group.name))
        self.record: list[Array] = []
        """Positions (n,) of the approach that runs, from its start to the farthest that it got."""
        self._timer, self._recorded_at = RobotTimer(), float("-inf")
        self._stands_since: float | None = None
        self.waits = False
        """Whether it has stood for long, and no field of its own runs: for something else than a way."""
        self.now = ArmNow(safe=True)
        """What was seen last."""
        self.goal_at: Array | None = None
        """Positions (n,) at the proximity pose of its approach, or of the last one until it is back."""
        self.speeds: Array = np.zeros(len(self.joints))
        """rad/s (n,)."""
        self.q: Array = self.safe_at
        hand = description.end_effector(side)
        self._safe_point = hand.safe_point
        self._hand = Chain.from_urdf(description.urdf, description.base_frame, hand.frame)

    @property
    def approach(self) -> ApproachStatus | None:
        """What the arm last told of its approach."""
        return self._approach.value

    @property
    def approaching(self) -> bool:
        """Whether its field runs."""
        return self.now.approaching

    @property
    def back_home(self) -> bool:
        """Whether it has done what it was at, and is in its safe place."""
        return self.now.back_home

    def look(self, joints: JointStates) -> ArmNow:
        """Return what the arm does now."""
        told, now = self._approach.refresh(), joints.stamp
        q = np.array(joints.position_of(self.joints))
        speeds = dict(zip(joints.names, joints.velocities, strict=True))
        self.speeds = np.array([speeds[joint] for joint in self.joints])
        moving = float(np.max(np.abs(self.speeds))) > STILL
        age = None if told is None else now.since(told.stamp)
        active = told is not None and told.active and age is not None and age < SILENT_AFTER
        at = self._timer.read(now)
        self._remember(q, told if active else None, at)
        away = float(np.max(np.abs(q - self.safe_at)))
        self.q = q
        self._note_goal(told if active else None, away)
        if moving or active or self._stands_since is None:
            self._stands_since = at
        self.waits = at - self._stands_since > WAITS_AFTER
        self.now = self._seen(joints, told if active else None, moving=moving, away=away)
        return self.now

    def _seen(self, joints: JointStates, told: ApproachStatus | None, *, moving: bool, away: float) -> ArmNow:
        if told is None:
            safe = away < SAFE_WITHIN or (not moving and self._holds_aside(joints))
            return ArmNow(moving=moving, safe=safe, away=away)
        return ArmNow(
            approaching=True,
            distance=told.distance,
            recorded=told.recorded,
            at=told.at,
            # It tells the sample to which it goes back as soon as it sets out.
            moving=moving or told.phase is ApproachPhase.BACK,
            safe=away < SAFE_WITHIN,
            away=away,
        )

    def _holds_aside(self, joints: JointStates) -> bool:
        """Say whether the hand is where it holds what it has picked, out of the other's way."""
        if self._safe_point is None:
            return False
        at = self._hand.pose(dict(zip(joints.names, joints.positions, strict=True))).position
        return math.dist(at, self._safe_point) < ASIDE

    def ahead(self) -> list[Array]:
        """Return the positions of its record that lie before it once it has gone back."""
        if not self.record:
            return []
        here = int(np.argmin([float(np.max(np.abs(q - self.q))) for q in self.record]))
        return self.record[here + 1 :]

    def close(self) -> None:
        """End the subscription."""
        self._approach.close()

    def _remember(self, q: Array, told: ApproachStatus | None, now: float) -> None:
        if told is None:
            self.record = []
        elif now - self._recorded_at >= EVERY - 1e-6 and not self._going_back(told):
            self.record.append(q)
            self._recorded_at = now

    def _note_goal(self, told: ApproachStatus | None, away: float) -> None:
        if told is not None:
            self.goal_at = np.array(told.goal_positions) if told.goal_positions else None
        elif away < SAFE_WITHIN:
            self.goal_at = None

    def _going_back(self, told: ApproachStatus) -> bool:
        return told.phase in {ApproachPhase.BACK, ApproachPhase.HELD, ApproachPhase.STOPPING}
