"""The wrapped pybullet world."""

from __future__ import annotations

import pytest

from tandem.sim.physics import GRAVITY, Physics


def test_two_worlds_live_side_by_side() -> None:
    first, second = Physics(), Physics()
    ball = first.add_box((0.1, 0.1, 0.1), 1.0, (0.0, 0.0, 5.0))
    still = second.add_box((0.1, 0.1, 0.1), 1.0, (0.0, 0.0, 5.0))
    first.step(150)
    fallen = 5.0 - first.body_pose(ball)[0][2]
    assert fallen == pytest.approx(0.5 * GRAVITY * first.seconds**2, rel=0.05)
    assert second.body_pose(still)[0][2] == 5.0
    first.close()
    second.close()


def test_no_coefficient_is_above_one() -> None:
    physics = Physics()
    floor = physics.add_floor()
    with pytest.raises(ValueError, match="between 0 and 1"):
        physics.set_surface(floor, -1, friction=1.2)
    physics.close()
