"""Which head positions look where."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import product
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import invert, transform
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import JointGroup, RobotDescription

HEAD: Final = "head"
APART: Final = 0.1
"""Radians between neighbouring head positions of the lattice, at the most."""
_ROUNDS: Final = 12
"""Of Gauss-Newton at the most; a step of less than ``_STEP`` ends it sooner."""
_STEP: Final = 1e-4
"""Radians: of a finite difference, and what is taken for none."""


class Aim:
    """Head positions from points and tilts, within the head joints' limits."""

    def __init__(self, description: RobotDescription) -> None:
        """Read the camera's chain and the head's limits; without a head the camera looks one way."""
        heads = [group for group in description.groups if group.name == HEAD]
        self.group: JointGroup = heads[0] if heads else JointGroup(name=HEAD, limits=())
        self._chain = Chain.from_urdf(description.urdf, description.base_frame, description.camera.frame)

    def tilted(self, tilt: float) -> tuple[float, ...]:
        """Return the head straight ahead and tilted by its last joint; radians, down is negative."""
        if not self.group.limits:
            return ()
        ahead = (0.0,) * (len(self.group.limits) - 1)
        return self._clipped(np.array([*ahead, tilt]))

    def at(self, point_in_base: Vector3, joint_positions: dict[str, float]) -> tuple[float, ...]:
        """Return the head positions that bring a point nearest to the middle of the picture.

        Gauss-Newton on the point's place in the picture; out of the head's reach, the nearest within it.
        """
        head = np.zeros(len(self.group.limits))
        if not self.group.limits:
            return ()
        for _ in range(_ROUNDS):
            miss = self._miss(head, point_in_base, joint_positions)
            slopes = np.empty((2, len(head)))
            for i in range(len(head)):
                moved = head.copy()
                moved[i] += _STEP
                slopes[:, i] = (self._miss(moved, point_in_base, joint_positions) - miss) / _STEP
            step = np.linalg.lstsq(slopes, -miss, rcond=None)[0]
            head = np.array(self._clipped(head + np.clip(step, -0.4, 0.4)))
            if float(np.abs(step).max()) < _STEP:
                break
        return self._clipped(head)

    def lattice(self, apart: float = APART) -> tuple[tuple[float, ...], ...]:
        """Return head positions all over its range, ``apart`` radians or less from each other."""
        return tuple(
            product(
                *(
                    np.linspace(limit.lower, limit.upper, 1 + math.ceil((limit.upper - limit.lower) / apart))
                    .round(6)
                    .tolist()
                    for limit in self.group.limits
                )
            )
        )

    def camera_in_base(self, head: tuple[float, ...], joint_positions: Mapping[str, float]) -> Pose:
        """Return where the camera is with the head there and all else as given."""
        return self._chain.pose({**joint_positions, **dict(zip(self.group.joints, head, strict=True))})

    def _miss(
        self, head: NDArray[np.float64], point: Vector3, positions: dict[str, float]
    ) -> NDArray[np.float64]:
        """Return the angles (rad, right and down) between the line of sight and the point."""
        joints = positions | dict(zip(self.group.joints, head.tolist(), strict=True))
        x, y, z = transform(invert(self._chain.pose(joints)), point)
        return np.array([np.arctan2(x, z), np.arctan2(y, np.hypot(x, z))])

    def _clipped(self, head: NDArray[np.float64]) -> tuple[float, ...]:
        return tuple(
            min(max(float(value), limit.lower), limit.upper)
            for value, limit in zip(head, self.group.limits, strict=True)
        )
