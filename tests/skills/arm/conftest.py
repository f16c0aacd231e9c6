"""The arm of a Panda: its hulls take a second to load, and the rig is for one test alone."""

from __future__ import annotations

import pytest

from tandem.skills.kinematics.described import load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tests.fakes.arm_rig import ArmRig, panda


@pytest.fixture(scope="module")
def hulls() -> RobotHulls:
    return load_hulls(panda())


@pytest.fixture
def rig(hulls: RobotHulls) -> ArmRig:
    return ArmRig(panda(), "arm", hulls=hulls)
