"""Algorithm 2 of the two-arm thesis, on a grid, against matrices."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from tandem.skills.geometry.poses import from_rpy
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import ArmsCrossing
from tandem.skills.reflex.crossing import arms_crossing, pitch_and_yaw

HOW = ArmsCrossing(k=0.1, gamma=0.05, mu=0.08, clearance=0.03)


def matrix(pitch: float, yaw: float) -> np.ndarray:
    turn = np.array([[math.cos(yaw), -math.sin(yaw), 0], [math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]])
    tilt = np.array(
        [[math.cos(pitch), 0, math.sin(pitch)], [0, 1, 0], [-math.sin(pitch), 0, math.cos(pitch)]]
    )
    return turn @ tilt


def tool(y: float, pitch: float, yaw: float, roll: float = 0.0) -> Pose:
    return Pose(position=(0.6, y, 0.9), orientation=from_rpy(roll, pitch, yaw))


@pytest.mark.parametrize("pitches", list(itertools.product((-0.4, 0.0, 0.7, 1.3), repeat=2)), ids=str)
def test_the_verdict_is_the_algorithms(pitches: tuple[float, float]) -> None:
    for yaws in itertools.product((-3.0, -1.0, 0.0, 0.8, 2.9), repeat=2):
        for d in (-0.3, 0.0, 0.05, 0.12, 0.2, 0.4):
            verdict = arms_crossing(tool(d, pitches[0], yaws[0], 0.3), tool(0.0, pitches[1], yaws[1]), HOW)
            ahead = [matrix(p, w)[:2, 0] for p, w in zip(pitches, yaws, strict=True)]
            cosine = ahead[0] @ ahead[1] / np.linalg.norm(ahead[0]) / np.linalg.norm(ahead[1])
            turned, lowered = math.acos(np.clip(cosine, -1.0, 1.0)), abs(sum(pitches))
            threshold = max(0.1, 0.1 + 0.05 * turned - 0.08 * lowered)
            assert verdict.threshold == pytest.approx(threshold, abs=1e-6)
            assert verdict.distance == pytest.approx(d)
            assert verdict.risk is (d < threshold)


def test_hands_in_the_wrong_order_are_a_risk_however_far_apart() -> None:
    """Eq. 4.1; the algorithm's absolute value would see 0.8 m and be content."""
    assert arms_crossing(tool(-0.4, 0.0, 0.0), tool(0.4, 0.0, 0.0), HOW).risk
    assert not arms_crossing(tool(0.4, 0.0, 0.0), tool(-0.4, 0.0, 0.0), HOW).risk


def test_pitch_is_down_and_yaw_to_the_left() -> None:
    assert pitch_and_yaw(tool(0.0, 0.5, 1.2, 2.0)) == pytest.approx((0.5, 1.2))
