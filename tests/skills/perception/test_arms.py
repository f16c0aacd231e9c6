"""How far arms reach, as far as it matters to a look around."""

from __future__ import annotations

import math

import numpy as np
import pytest

from tandem.sim.robots.registry import robot_model
from tandem.skills.perception.arms import Arms
from tandem.skills.ports.robot_description import RobotDescription
from tandem.trees.leaves.look_closely import REACH
from tests.skills.perception.stage import DESCRIPTION

LOCOBOT = robot_model("locobot").description


@pytest.mark.parametrize("description", [DESCRIPTION, LOCOBOT])
def test_no_posture_gets_a_hand_beyond_an_arms_reach(description: RobotDescription) -> None:
    arms, rng = Arms(description), np.random.default_rng(1)
    names = sorted(description.joints)
    for _ in range(200):
        hands = arms.hands(dict(zip(names, rng.uniform(-1.5, 1.5, len(names)), strict=True)))
        assert all(math.hypot(*hand.position[:2]) < arms.reach for hand in hands.values())


def test_a_small_arm_reaches_less_than_a_look_around_asks_for() -> None:
    assert Arms(LOCOBOT).reach == pytest.approx(0.86, abs=0.01)
    assert Arms(DESCRIPTION).reach > REACH


def test_without_an_arm_nothing_bounds_it() -> None:
    assert Arms(LOCOBOT.model_copy(update={"end_effectors": ()})).reach == math.inf
