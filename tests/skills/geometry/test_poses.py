"""Poses against 4x4 matrices of numpy, which know nothing of quaternions."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tandem.skills.geometry.poses import (
    about,
    angle_between,
    compose,
    from_axes,
    from_rpy,
    invert,
    to_floor,
    to_pose,
    transform,
    wrap,
    yaw_of,
)
from tandem.skills.ports.pose import FloorPose, Pose

angles = st.floats(-math.pi, math.pi)
metres = st.floats(-5.0, 5.0)
poses = st.builds(
    lambda x, y, z, roll, pitch, yaw: Pose(position=(x, y, z), orientation=from_rpy(roll, pitch, yaw)),
    *[metres] * 3,
    *[angles] * 3,
)


def about_axis(axis: int, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    i, j = [k for k in range(3) if k != axis] if axis != 1 else (2, 0)
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = c
    matrix[i, j], matrix[j, i] = -s, s
    return matrix


def matrix(pose: Pose) -> np.ndarray:
    columns = [
        transform(Pose(orientation=pose.orientation), axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    ]
    out = np.eye(4)
    out[:3, :3] = np.array(columns).T
    out[:3, 3] = pose.position
    return out


@given(angles, angles, angles)
def test_roll_pitch_yaw_is_three_turns_about_fixed_axes(roll: float, pitch: float, yaw: float) -> None:
    expected = about_axis(2, yaw) @ about_axis(1, pitch) @ about_axis(0, roll)
    assert matrix(Pose(orientation=from_rpy(roll, pitch, yaw)))[:3, :3] == pytest.approx(expected, abs=1e-9)


@given(poses, poses)
def test_compose_is_the_product_of_matrices(a: Pose, b: Pose) -> None:
    assert matrix(compose(a, b)) == pytest.approx(matrix(a) @ matrix(b), abs=1e-8)


@given(poses)
def test_invert_is_the_inverse_matrix(a: Pose) -> None:
    assert matrix(invert(a)) == pytest.approx(np.linalg.inv(matrix(a)), abs=1e-8)


@given(poses)
def test_axes_give_their_rotation_back(a: Pose) -> None:
    x, y, z = (tuple(column) for column in matrix(a)[:3, :3].T)
    assert angle_between(from_axes(x, y, z), a.orientation) == pytest.approx(0.0, abs=1e-6)


@given(metres, metres, angles)
def test_a_floor_pose_comes_back(x: float, y: float, yaw: float) -> None:
    back = to_floor(to_pose(FloorPose(x=x, y=y, yaw=yaw)))
    assert (back.x, back.y) == pytest.approx((x, y))
    assert math.remainder(back.yaw - yaw, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    ("angle", "expected"), [(0.0, 0.0), (math.pi, math.pi), (-math.pi, math.pi), (7.0, 7.0 - 2 * math.pi)]
)
def test_wrap(angle: float, expected: float) -> None:
    assert wrap(angle) == pytest.approx(expected)


def test_a_heading_is_that_of_the_turned_x_axis() -> None:
    assert yaw_of(about((0, 0, 1), 0.7)) == pytest.approx(0.7)


@pytest.mark.parametrize("orientation", [(0.0, 0.0, 0.0, 0.5), (1.0, 1.0, 0.0, 0.0)])
def test_an_orientation_that_is_no_rotation_is_refused(
    orientation: tuple[float, float, float, float],
) -> None:
    with pytest.raises(ValueError, match="unit quaternion"):
        Pose(orientation=orientation)
