"""What is held is held by Coulomb's friction, and by nothing else."""

from __future__ import annotations

import pytest

from benchmarks.rig import GRASP, LIFT, Rig, slip
from tandem.skills.ports.hardware import GripperMotion


def _lift(*, mass: float, friction: float, force: float) -> tuple[float, Rig]:
    rig = Rig(size=0.06, mass=mass, friction=friction)
    rig.grip(0.09)
    rig.move("arm_left", GRASP, 1.0)
    rig.grip(0.0, force)
    before = rig.physics.body_pose(rig.item)[0][2]
    rig.move("arm_left", LIFT, 1.0)
    rig.ticks(50)
    return rig.physics.body_pose(rig.item)[0][2] - before, rig


@pytest.mark.parametrize(("force", "lifted"), [(1.6, False), (2.6, True)])
def test_an_item_is_lifted_just_when_friction_can_carry_it(force: float, *, lifted: bool) -> None:
    """2 mu F = m g: 200 g at mu = 0.5 x 1.0 need 1.96 N."""
    rise, rig = _lift(mass=0.2, friction=0.5, force=force)
    assert (rise > 0.095) is lifted
    rig.close()


def test_a_full_hand_tells_width_and_force_and_holds_still() -> None:
    rise, rig = _lift(mass=0.1, friction=0.9, force=16.0)
    held = rig.item_in_hand()
    state = rig.gripper()
    assert rise == pytest.approx(0.1, abs=0.001)
    assert state.motion is GripperMotion.STALLED
    assert state.width == pytest.approx(0.06, abs=0.001)
    assert state.force == pytest.approx(16.0, abs=1.0)
    rig.ticks(300)
    rig.move("arm_left", GRASP, 2.0)
    rig.move("arm_left", LIFT, 2.0)
    millimetres, degrees = slip(held, rig.item_in_hand())
    assert millimetres < 0.5
    assert degrees < 0.5
    rig.close()


def test_an_item_that_is_let_go_falls() -> None:
    rise, rig = _lift(mass=0.1, friction=0.9, force=16.0)
    assert rise > 0.09
    rig.ticks(300)  # longer than a body needs to fall asleep, where bodies may
    rig.grip(0.09)
    rig.ticks(50)
    assert rig.physics.body_pose(rig.item)[0][2] < 0.79
    rig.close()


def test_an_empty_hand_closes_fully() -> None:
    rig = Rig(friction=None)
    rig.grip(0.09)
    state = rig.grip(0.0)
    assert (state.motion, state.force) == (GripperMotion.AT_WIDTH, 0.0)
    assert state.width < 0.002
    rig.close()
