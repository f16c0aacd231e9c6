"""Whether an arm takes any pose as it is follows from how its joints lie, not from their number."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.kinematics.batch import BatchChain
from tandem.skills.kinematics.ik import SeedTable, Solver
from tandem.skills.kinematics.model import Chain, Limits, RobotKinematics
from tandem.skills.kinematics.transforms import Array

AXES = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1", "lift": "0 0 1"}


def solver(*axes: str) -> Solver:
    """Return the solver of an arm whose joints turn about these axes, one 0.3 m ahead of the other."""
    joints = [f"j{k}" for k in range(len(axes))]
    links = "".join(f'<link name="l{k}"/>' for k in range(len(axes) + 1))
    told = "".join(
        f'<joint name="j{k}" type="{"prismatic" if axis == "lift" else "revolute"}"><parent link="l{k}"/>'
        f'<child link="l{k + 1}"/><origin xyz="0.3 0 0"/><axis xyz="{AXES[axis]}"/>'
        '<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>'
        for k, axis in enumerate(axes)
    )
    robot = RobotKinematics(f'<robot name="r">{links}{told}</robot>', {"arm": joints})
    batch = BatchChain(Chain(robot, joints, dict.fromkeys(joints, 0.0)), f"l{len(axes)}")
    bounds = Limits(-np.ones(len(axes)), np.ones(len(axes)), np.ones(len(axes)))
    return Solver(batch, bounds, SeedTable(batch, bounds, np.random.default_rng(1), _all, size=50))


def _all(_: Array) -> bool:
    return True


@pytest.mark.parametrize(
    ("axes", "exact"),
    [
        (("z", "y", "y", "x", "y", "x"), True),
        (("z", "y", "y", "y", "x"), False),
        (("lift", "z", "y", "y", "y", "x"), False),
        (("z", "y", "y", "y", "y", "y", "x"), False),
        (("lift", "z", "y", "y", "z", "y", "x"), True),
    ],
)
def test_an_arm_is_exact_if_its_hand_moves_in_all_ways(axes: tuple[str, ...], *, exact: bool) -> None:
    assert solver(*axes).exact is exact
