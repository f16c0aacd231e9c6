"""Where all joints of a chain's model are, for many configurations at once.

As ``BatchChain``, but of every joint and in the base: joint k's frame in the one before is A_k + sin(q) B_k +
(1 - cos(q)) C_k, or A_k + q B_k for one that shifts (Rodrigues' formula).
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.batch import axis_of
from tandem.skills.kinematics.model import Chain
from tandem.skills.kinematics.transforms import Array


class Forward:
    """Forward kinematics of a chain in arrays, told in a frame of one's own.

    Args:
        chain: its joints are the columns of every array of configurations.
        scale: what metres are multiplied by.
        shift: what is then added (3,).
    """

    def __init__(self, chain: Chain, scale: float, shift: Array) -> None:
        model = chain.model
        self.joints = model.njoints
        """How many frames are told: the base's (0), and each joint's by pinocchio's number."""
        names = list(model.names)
        self.columns = np.array([chain.joints.index(names[j]) for j in range(1, self.joints)])
        self.parents = [int(model.parents[j]) for j in range(1, self.joints)]
        constant, first, second, turning = [], [], [], []
        for j in range(1, self.joints):
            placed = np.array(model.jointPlacements[j].homogeneous)
            axis, turns = axis_of(model.joints[j])
            slope, bend = np.zeros((4, 4)), np.zeros((4, 4))
            if turns:
                slope[:3, :3] = pin.skew(axis)
                bend[:3, :3] = slope[:3, :3] @ slope[:3, :3]
            else:
                slope[:3, 3] = axis
            constant.append(placed)
            first.append(placed @ slope)
            second.append(placed @ bend)
            turning.append(turns)
        self._turning = np.array(turning)[:, None]
        self._all_turn = bool(self._turning.all())
        self.base = np.eye(4)
        self.base[:3, :3] *= scale
        self.base[:3, 3] = shift
        self.base = self.base[:3]
        self._a, self._b, self._c = (np.array(each)[:, None] for each in (constant, first, second))

    def frames(self, q: Array) -> Array:
        """Return the upper rows of the frames of configurations (m, n): (joints, m, 3, 4)."""
        turned = q.T[self.columns]
        one, two = np.sin(turned), 1.0 - np.cos(turned)
        if not self._all_turn:
            one, two = np.where(self._turning, one, turned), np.where(self._turning, two, 0.0)
        steps = self._a + one[:, :, None, None] * self._b + two[:, :, None, None] * self._c
        found = np.empty((self.joints, len(q), 3, 4))
        found[0] = self.base
        for k, parent in enumerate(self.parents):
            np.matmul(found[parent], steps[k], out=found[k + 1])
        return found

    def constants(self) -> Array:
        """Return each joint's A, B and C, upper rows, and whether it turns: (joints, 4, 12)."""
        turning = np.zeros((self.joints - 1, 1, 12))
        turning[:, 0] = self._turning
        parts = [each[:, :, :3].reshape(-1, 1, 12) for each in (self._a, self._b, self._c)]
        return np.concatenate([*parts, turning], axis=1)
