"""By how much a joint's turn can move a body at the most."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.transforms import Array


def supports(model: pin.Model, parents: Sequence[int]) -> npt.NDArray[np.bool_]:
    """Return which joints move which bodies: (bodies, joints), the joints as in a full configuration.

    Args:
        model: each joint of it is one number.
        parents: pinocchio's number of the joint that each body hangs on.
    """
    found = np.zeros((len(parents), model.nq), dtype=bool)
    for row, parent in enumerate(parents):
        for joint in model.supports[parent]:
            if joint > 0:
                found[row, model.joints[int(joint)].idx_q] = True
    return found


def reach_of(body: pin.GeometryObject) -> float:
    """Return the metres from a body's origin to its farthest point, or a little more."""
    box = body.geometry.aabb_local
    return float(np.linalg.norm(np.maximum(np.abs(np.array(box.min_)), np.abs(np.array(box.max_)))))


def lever_arms(
    model: pin.Model, bodies: Sequence[pin.GeometryObject], support: npt.NDArray[np.bool_]
) -> Array:
    """Return metres a radian (or a metre) by which a joint can move any point of a body: (bodies, joints).

    A turn moves no point farther than its distance from the joint, and that is at most the sum of the links
    between, with all that joints which shift can add, and the body's own size.
    """
    levers = np.zeros(support.shape)
    for row, body in enumerate(bodies):
        length = float(np.linalg.norm(body.placement.translation)) + reach_of(body)
        for joint in reversed([int(j) for j in model.supports[int(body.parentJoint)] if j > 0]):
            kind = model.joints[joint]
            shifts = kind.shortname().startswith("JointModelP")
            if shifts:
                k = kind.idx_q
                length += float(max(abs(model.lowerPositionLimit[k]), abs(model.upperPositionLimit[k])))
            levers[row, kind.idx_q] = 1.0 if shifts else length
            length += float(np.linalg.norm(model.jointPlacements[joint].translation))
    return levers
