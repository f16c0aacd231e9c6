"""Scan matching: the pose at which the scan's points lie best on the map's surfaces.

Gauss-Newton on signed distances with Geman-McClure weights whose scale shrinks (graduated non-convexity,
Black & Rangarajan 1996), and the predicted pose as a prior: what the map does not explain loses its say.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.floor import FloatArray, points_in
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose

NEAR: Final = 0.1
"""Metres: a beam that ends as near to a mapped surface counts as explained."""
SIGMA: Final = 0.03
"""Metres: what a beam is trusted to; the laser's noise and the map's errors."""
CORRELATION: Final = 6.0
"""Neighbouring beams err alike: as many count as one."""
SCALES: Final = (0.30, 0.15, 0.08, 0.05, 0.05, 0.05)
"""Metres: the weights' scale in each iteration of a normal match."""


@dataclass(frozen=True)
class Match:
    """The matched pose, its covariance (x, y, yaw; m2 and rad2), and the share of beams explained there."""

    pose: FloorPose
    covariance: FloatArray
    fit: float
    residual: FloatArray
    """Signed distances of the points at the pose, shape (n,)."""


def match(
    field: DistanceField,
    points_in_base: FloatArray,
    predicted: FloorPose,
    prior: FloatArray,
    scales: tuple[float, ...] = SCALES,
) -> Match:
    """Return the pose that fits the points, shape (n, 2), given the prediction and its covariance (3, 3)."""
    mean = np.array([predicted.x, predicted.y, predicted.yaw])
    belief = np.linalg.inv(prior)
    state = mean.copy()
    information = belief
    for scale in scales:
        pose = FloorPose(x=float(state[0]), y=float(state[1]), yaw=float(state[2]))
        placed = points_in(pose, points_in_base)
        distance, gradient = field.with_gradient(placed)
        weight = (scale * scale / (scale * scale + distance * distance)) ** 2 / (SIGMA * SIGMA * CORRELATION)
        lever = placed - state[:2]
        jacobian = np.stack(
            (gradient[:, 0], gradient[:, 1], gradient[:, 1] * lever[:, 0] - gradient[:, 0] * lever[:, 1]),
            axis=1,
        )
        weighted = jacobian * weight[:, None]
        information = weighted.T @ jacobian + belief
        slope = weighted.T @ distance + belief @ (state - mean)
        change = np.linalg.solve(information, slope)
        state = state - np.clip(change, -0.2, 0.2)
    pose = FloorPose(x=float(state[0]), y=float(state[1]), yaw=wrap(float(state[2])))
    residual = field.at(points_in(pose, points_in_base))
    return Match(pose, np.linalg.inv(information), share_near(residual), residual)


def share_near(distances: FloatArray) -> float:
    """Return the share of beams within ``NEAR`` of a mapped surface; 0 without beams."""
    return float(np.mean(np.abs(distances) < NEAR)) if len(distances) else 0.0


def share_behind(distances: FloatArray) -> float:
    """Return the share of beams that end more than ``NEAR`` behind a mapped surface; 0 without beams."""
    return float(np.mean(distances < -NEAR)) if len(distances) else 0.0


def diagonal(position_sigma: float, yaw_sigma: float) -> FloatArray:
    """Return the covariance (3, 3) of these standard deviations (m, rad)."""
    return np.diag([position_sigma**2, position_sigma**2, yaw_sigma**2])


def carried(covariance: FloatArray, before: FloorPose, after: FloorPose) -> FloatArray:
    """Return the covariance after moving: an error of heading becomes one of position on the way."""
    jacobian = np.eye(3)
    jacobian[0, 2] = -(after.y - before.y)
    jacobian[1, 2] = after.x - before.x
    moved = math.hypot(after.x - before.x, after.y - before.y)
    turned = abs(wrap(after.yaw - before.yaw))
    grown: FloatArray = jacobian @ covariance @ jacobian.T
    return grown + diagonal(0.06 * moved, 0.06 * turned + 0.03 * moved)
