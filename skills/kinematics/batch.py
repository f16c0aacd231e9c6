"""Many configurations of one serial chain at once: poses, Jacobians and descents as arrays.

A call of numpy costs as much for thirty configurations as for one, so starts of inverse kinematics, or all
points of a line, are best treated together.
"""

from __future__ import annotations

import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.model import Chain, Limits
from tandem.skills.kinematics.transforms import Array


class BatchChain:
    """The joints up to one frame, for arrays of configurations; all is told in the first joint's own frame.

    That frame is where the joint is at zero, so that it does not matter where the joints below (the torso)
    stand: ``root`` tells where it is.

    Joint k's frame in the one before it is constant up to a turn about (or a shift along) its axis:
    G_k(q) = A_k + sin(q) B_k + (1 - cos(q)) C_k, or A_k + q B_k, with constant 4x4 matrices
    (Rodrigues' formula).

    Args:
        chain: the joints, in the order of the arrays' columns; all of them must carry the frame.
        frame: what is moved.
    """

    def __init__(self, chain: Chain, frame: str) -> None:
        model = chain.model
        number = chain.frame(frame)
        carrying = [int(j) for j in model.supports[model.frames[number].parentJoint] if j > 0]
        names = [str(model.names[j]) for j in carrying]
        if sorted(names) != sorted(chain.joints):
            raise ValueError(f"{frame} is carried by {names}, not by {chain.joints}")
        self.columns = np.array([chain.joints.index(name) for name in names])
        self._first = names[0]
        self._order = np.argsort(self.columns)
        self._tip = model.frames[number].placement.homogeneous.copy()
        axes: list[Array] = []
        constant: list[Array] = []
        first, second, turning = [], [], []
        for j in carrying:
            placed = model.jointPlacements[j].homogeneous.copy() if constant else np.eye(4)
            axis, turns = axis_of(model.joints[j])
            axes.append(axis)
            turning.append(turns)
            constant.append(placed)
            first.append(placed @ (_homogeneous(pin.skew(axis)) if turns else _shift(axis)))
            second.append(placed @ _homogeneous(pin.skew(axis) @ pin.skew(axis)))
        self._axes, self._turning = np.array(axes), np.array(turning)
        self._a, self._b, self._c = np.array(constant), np.array(first), np.array(second)

    def root(self, chain: Chain) -> pin.SE3:
        """Return the first joint's frame in the base, as it is in a chain of the same joints."""
        return chain.model.jointPlacements[chain.model.getJointId(self._first)]

    def frames(self, q: Array) -> tuple[Array, Array]:
        """Return the joints' frames (m, n, 4, 4) in their own order, and the tip's (m, 4, 4)."""
        q = q[:, self.columns]
        turned = self._turning
        one = np.where(turned, np.sin(q), q)[:, :, None, None]
        two = np.where(turned, 1.0 - np.cos(q), 0.0)[:, :, None, None]
        steps = self._a + one * self._b + two * self._c
        frames = np.empty_like(steps)
        frames[:, 0] = steps[:, 0]
        for k in range(1, steps.shape[1]):
            np.matmul(frames[:, k - 1], steps[:, k], out=frames[:, k])
        return frames, frames[:, -1] @ self._tip

    def error(self, q: Array, targets: Array) -> tuple[Array, Array]:
        """Return the twists (m, 6) from the tip to the targets (m, 4, 4), and their Jacobians (m, 6, n).

        Along and about the root's axes: the tip's way, and the rotation vector of R_target R^T.
        """
        frames, tip = self.frames(q)
        twist = np.empty((len(q), 6))
        twist[:, :3] = targets[:, :3, 3] - tip[:, :3, 3]
        twist[:, 3:] = _turn(targets[:, :3, :3] @ tip[:, :3, :3].transpose(0, 2, 1))
        axes = np.matmul(frames[:, :, :3, :3], self._axes[:, :, None])[..., 0]
        arms = tip[:, None, :3, 3] - frames[:, :, :3, 3]
        jacobian = np.empty((len(q), 6, q.shape[1]))
        linear = np.where(self._turning[:, None], _cross(axes, arms), axes)
        angular = np.where(self._turning[:, None], axes, 0.0)
        jacobian[:, :3] = linear.transpose(0, 2, 1)[:, :, self._order]
        jacobian[:, 3:] = angular.transpose(0, 2, 1)[:, :, self._order]
        return twist, jacobian

    def descend(
        self, q: Array, targets: Array, limits: Limits, *, damping: float, largest: float
    ) -> tuple[Array, Array]:
        """Return one step's q (m, n) and the twists (m, 6) that were left before it."""
        twist, jacobian = self.error(q, targets)
        return stepped(q, twist, jacobian, limits, damping=damping, largest=largest), twist


def stepped(
    q: Array, twist: Array, jacobian: Array, limits: Limits, *, damping: float, largest: float
) -> Array:
    """Return q (m, n) one step further.

    Damped least squares, J^T (J J^T + w I)^-1 e, with w = damping * |e|^2 (Sugihara 2011, eq. 20);
    a joint at a limit that the step would push further out is taken out of the problem.
    """
    gradient = np.matmul(twist[:, None, :], jacobian)[:, 0]
    stuck = ((q <= limits.lower) & (gradient < 0.0)) | ((q >= limits.upper) & (gradient > 0.0))
    jacobian = np.where(stuck[:, None, :], 0.0, jacobian)
    weight = damping * np.minimum(np.einsum("ij,ij->i", twist, twist), 1.0) + 1e-6
    normal = np.matmul(jacobian, jacobian.transpose(0, 2, 1))
    normal[:, range(6), range(6)] += weight[:, None]
    solved = np.linalg.solve(normal, twist[:, :, None])
    step = np.matmul(jacobian.transpose(0, 2, 1), solved)[..., 0]
    biggest = np.max(np.abs(step), axis=1)
    step *= np.minimum(1.0, largest / np.maximum(biggest, 1e-12))[:, None]
    return np.asarray(np.minimum(np.maximum(q + step, limits.lower), limits.upper))


def left(twist: Array) -> tuple[Array, Array]:
    """Return the metres and radians (m,) of twists (m, 6)."""
    squares = twist * twist
    return np.sqrt(squares[:, :3].sum(axis=1)), np.sqrt(squares[:, 3:].sum(axis=1))


def axis_of(joint: pin.JointModel) -> tuple[Array, bool]:
    """Return a joint's unit axis in its own frame, and whether it turns about it (or shifts along it)."""
    data = joint.createData()
    joint.calc(data, np.zeros(1))
    column = np.array(data.S).reshape(6)
    turns = bool(np.linalg.norm(column[3:]) > 0.5)  # noqa: PLR2004
    return (column[3:] if turns else column[:3]), turns


def _homogeneous(rotation: Array) -> Array:
    matrix = np.zeros((4, 4))
    matrix[:3, :3] = rotation
    return matrix


def _shift(axis: Array) -> Array:
    matrix = np.zeros((4, 4))
    matrix[:3, 3] = axis
    return matrix


def _cross(a: Array, b: Array) -> Array:
    """Return a x b over the last axis (numpy's own is slow for small arrays)."""
    product = np.empty_like(a)
    product[..., 0] = a[..., 1] * b[..., 2] - a[..., 2] * b[..., 1]
    product[..., 1] = a[..., 2] * b[..., 0] - a[..., 0] * b[..., 2]
    product[..., 2] = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return product


def _turn(rotation: Array) -> Array:
    """Return the rotation vectors (m, 3) of rotations (m, 3, 3); of half a turn, something near it."""
    sine = 0.5 * np.stack(
        (
            rotation[:, 2, 1] - rotation[:, 1, 2],
            rotation[:, 0, 2] - rotation[:, 2, 0],
            rotation[:, 1, 0] - rotation[:, 0, 1],
        ),
        axis=1,
    )
    size = np.sqrt(np.einsum("ij,ij->i", sine, sine))
    cosine = 0.5 * (rotation[:, 0, 0] + rotation[:, 1, 1] + rotation[:, 2, 2] - 1.0)
    angle = np.arctan2(size, cosine)
    return np.asarray(sine * (angle / np.maximum(size, 1e-9))[:, None])
