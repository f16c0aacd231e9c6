"""Arms crossing control: two-arm thesis, Algorithm 2, with the order of the hands of its eq. 4.1.

The thesis has x to the right; here y is to the left. Its distance along that axis is an absolute value and
takes hands that have crossed by far for safe; here d = y_left - y_right has its sign, so that hands in
the wrong order (eq. 4.1) are always a risk.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from tandem.skills.geometry.poses import rotate, wrap
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import ArmsCrossing


@dataclass(frozen=True)
class Verdict:
    """Metres: between the hands along the base's y, and what they must keep."""

    distance: float
    threshold: float

    @property
    def risk(self) -> bool:
        """Whether the arms are in danger of crossing."""
        return self.distance < self.threshold


def pitch_and_yaw(tool_in_base: Pose) -> tuple[float, float]:
    """Return pitch and yaw (rad) of R = R_z(yaw) R_y(pitch) R_x(roll): the tool's x, down and to the left."""
    x, y, z = rotate(tool_in_base.orientation, (1.0, 0.0, 0.0))
    return math.atan2(-z, math.hypot(x, y)), math.atan2(y, x)


def arms_crossing(left: Pose, right: Pose, how: ArmsCrossing) -> Verdict:
    """Judge both tools' poses in the base.

    K = max(k, k + gamma |yaw_right - yaw_left| - mu |pitch_right + pitch_left|); the yaws' difference is
    the smaller angle between them, in [0, pi].
    """
    left_pitch, left_yaw = pitch_and_yaw(left)
    right_pitch, right_yaw = pitch_and_yaw(right)
    turned = abs(wrap(right_yaw - left_yaw))
    lowered = abs(right_pitch + left_pitch)
    return Verdict(
        distance=left.position[1] - right.position[1],
        threshold=max(how.k, how.k + how.gamma * turned - how.mu * lowered),
    )
