"""A camera on a post looks one way, whatever it is to look at."""

from __future__ import annotations

from tandem.sim.robots.registry import robot_model
from tandem.skills.perception.aim import Aim


def test_a_camera_without_a_head_has_one_position() -> None:
    aim = Aim(robot_model("panda").description)
    assert aim.tilted(-0.9) == ()
    assert aim.at((0.6, 0.0, 0.7), {}) == ()
    assert aim.lattice() == ((),)
    assert aim.camera_in_base((), {}).position[2] > 1.0
