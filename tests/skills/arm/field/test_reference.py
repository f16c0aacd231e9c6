"""Set-points along a planned motion leave a motor some of its speed to catch up with."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.field.reference import HEADROOM, with_headroom
from tandem.skills.arm.trajectory import MotionLimits, Trajectory

LIMITS = MotionLimits(np.array([3.0, 1.0]), np.array([5.0, 5.0]), np.array([50.0, 50.0]))


def motion(*fastest: float) -> Trajectory:
    """Return a motion whose joints have these speeds (rad/s) in its middle."""
    still = np.zeros(2)
    return Trajectory(
        np.array([0.0, 1.0, 2.0]),
        np.stack((still, np.array(fastest), 2.0 * np.array(fastest))),
        np.stack((still, np.array(fastest), still)),
    )


@pytest.mark.parametrize("fastest", [(3.0, 0.1), (0.1, -1.0)], ids=["first joint", "second, backwards"])
def test_a_motion_that_needs_all_of_a_joints_speed_is_slowed_down(fastest: tuple[float, float]) -> None:
    slower = with_headroom(motion(*fastest), LIMITS)
    assert slower.duration == pytest.approx(2.0 / HEADROOM)
    assert float((np.abs(slower.velocities) / LIMITS.velocity).max()) == pytest.approx(HEADROOM)
    halfway = slower.sample(np.array([slower.duration / 2]))[0]
    assert halfway == pytest.approx(np.array(fastest)), "the way is the same"


def test_another_one_stays_as_it_is() -> None:
    slow = with_headroom(motion(2.0, 0.5), LIMITS)
    assert slow.duration == 2.0
