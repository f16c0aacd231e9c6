"""How far joints go until they rest, against a braking that is added up step by step."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.kinematics.clearance import braking_way

STEP = 1e-5


def added_up(speed: float, acceleration: float, jerk: float) -> float:
    """Brake as hard as the bounds let, easing off so as to end at rest with no deceleration left."""
    way = deceleration = 0.0
    while speed > 1e-4:
        eases = speed <= deceleration**2 / (2.0 * jerk)
        change = -jerk if eases else jerk
        deceleration = min(acceleration, max(1e-3, deceleration + change * STEP))
        speed -= deceleration * STEP
        way += speed * STEP
    return way


@pytest.mark.parametrize("speed", [0.1, 0.5, 1.0, 1.95])
def test_the_way_to_rest_with_bounded_jerk(speed: float) -> None:
    (way,) = braking_way(np.array([speed]), np.array([5.0]), np.array([50.0]))
    assert way == pytest.approx(added_up(speed, 5.0, 50.0), rel=0.01)


def test_joints_that_stop_in_step_go_as_far_as_their_speeds_are_to_each_other() -> None:
    speeds = np.array([1.0, -0.4, 0.0])
    way = braking_way(speeds, np.full(3, 5.0), np.full(3, 50.0))
    assert way / way[0] == pytest.approx(speeds)
    assert way[0] == pytest.approx(added_up(1.0, 5.0, 50.0), rel=0.01), "the fastest needs longest"
