"""A line through a stretched wrist is followed; one on which the arm folds over is not."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.sim.robots.registry import robot_model
from tandem.skills.arm.planning.straight import JUMP, Hand, _on_the_line, follow
from tandem.skills.arm.problem import Arm
from tandem.skills.kinematics.described import home_positions, load_hulls
from tandem.skills.ports.steps import run_through

ABOVE = np.array((-0.00267, 0.18613, 0.02826, 0.00851, 0.30924, -0.00966))
"""A LoCoBot's arm above a slot: on the way down its wrist is stretched, and both rolls turn by 0.26 rad."""


@pytest.fixture(scope="module")
def hand() -> Hand:
    description = robot_model("locobot").description
    hulls = load_hulls(description, 0)
    arm = Arm(hulls, description, "arm_single")
    assert arm.hand is not None
    assert arm.solver is not None
    positions = dict(home_positions(description))
    return Hand(arm.solver, arm.hand.frame, hulls.robot.chain(arm.group.joints, positions))


def test_a_hand_goes_down_through_a_stretched_wrist(hand: Hand) -> None:
    here = hand.chain.pose(ABOVE, hand.frame)
    x, y, z = here.position
    down = run_through(follow(hand, None, ABOVE, here.model_copy(update={"position": (x, y, z - 0.10)})))
    assert down.broken is None
    assert np.abs(np.diff(down.path, axis=0)).max() > JUMP


def test_an_arm_that_folds_over_takes_the_hand_off_the_line(hand: Hand) -> None:
    folded = ABOVE + np.array((0.0, 0.6, -1.2, 0.0, 0.6, 0.0))
    assert not _on_the_line(hand, ABOVE, folded)
