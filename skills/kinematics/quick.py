"""Which states are free and which are in contact, as far as balls and one distance field can tell.

A state is proven free if all balls that cover the moving bodies are farther from everything than their radii,
and proven in contact if a ball within a body reaches into something. What is neither is in doubt, and coal
decides it. Nothing here is ever wrong, so the answer of both together is coal's. The arithmetic is in
``kernel``, which numba compiles: docs/decisions/012-balls-compiled.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from tandem.skills.kinematics.balls import Body, Meeting
from tandem.skills.kinematics.distance_field import HALF_DIAGONAL, DistanceField
from tandem.skills.kinematics.forward import Forward
from tandem.skills.kinematics.kernel import judge
from tandem.skills.kinematics.model import Chain
from tandem.skills.kinematics.pair_tables import SIDE, Angles
from tandem.skills.kinematics.spheres import Spheres
from tandem.skills.kinematics.transforms import Array

SAFE: Final = 2e-5
"""Metres that a proof must have to spare, more than the field's floats and coal round."""


class Quick:
    """Looks at states of one checker.

    Args:
        chain: the joints.
        field: the world, in the base frame; no moving body can leave its grid.
        bodies: those that move and those that stand.
        meetings: which two of them may not touch.
    """

    def __init__(
        self, chain: Chain, field: DistanceField, bodies: Sequence[Body], meetings: Sequence[Meeting]
    ) -> None:
        self.field = field
        """What it looks into."""
        forward = Forward(chain, 1.0 / field.cell, -field.low / field.cell)
        pairs = [each for each in meetings if each.table is None]
        moving = [k for k, body in enumerate(bodies) if body.joint > 0]
        standing = sorted({k for each in pairs for k in (each.first, each.second) if bodies[k].joint == 0})
        used = [*moving, *standing]
        if max((bodies[k].joint for k in used), default=0) >= forward.joints:
            raise ValueError(f"bodies of a model with more than the chain's {forward.joints - 1} joints")
        rank = {k: i for i, k in enumerate(used)}
        known = [(each.table, not each.may_touch) for each in meetings if each.table is not None]
        angles = Angles(chain.joints, [table for table, _ in known], [strict for _, strict in known])
        tables, ranges, answers = angles.arrays()
        both = [tuple(sorted((rank[each.first], rank[each.second]))) for each in pairs]
        numbers = [
            len(moving),
            field.shape[1] * field.shape[2],
            field.shape[2],
            SAFE,
            HALF_DIAGONAL * field.cell + SAFE,
            SAFE / field.cell,
            field.cell,
            *forward.base.reshape(-1),
        ]
        self._fixed = (
            forward.constants(),
            np.array(forward.parents, dtype=np.int64),
            forward.columns.astype(np.int64),
            np.array([bodies[k].joint for k in used], dtype=np.int64),
            np.array([not bodies[k].may_touch for k in used]),
            _packed([bodies[k].placed(bodies[k].balls.one) for k in used], field.cell),
            _packed([bodies[k].placed(bodies[k].balls.few) for k in used], field.cell),
            _packed([bodies[k].placed(bodies[k].balls.covering) for k in used], field.cell),
            _packed([bodies[k].placed(bodies[k].balls.within) for k in used], field.cell),
            np.array(both, dtype=np.int64).reshape(-1, 2),
            tables,
            ranges,
            answers.reshape(-1, SIDE, SIDE),
            field.least.reshape(-1),
            field.samples.reshape(-1),
            np.array(numbers, dtype=float),
        )

    def look(self, states: Array) -> npt.NDArray[np.int8]:
        """Return ``FREE``, ``CONTACT`` or ``DOUBT`` (of ``pair_tables``) for states (m, n): (m,)."""
        found = np.empty(len(states), dtype=np.int8)
        judge(np.ascontiguousarray(states, dtype=float), *self._fixed, False, found)
        return found

    def first(self, states: Array, begin: int, found: npt.NDArray[np.int8]) -> int:
        """Return the first state from ``begin`` on that is not proven free, or their number.

        Args:
            states: joint positions (m, n), C-contiguous.
            begin: where to begin.
            found: takes the answers (m,), as far as it went.
        """
        return begin + int(judge(states[begin:], *self._fixed, True, found[begin:]))


def _packed(placed: Sequence[Spheres], cell: float) -> Array:
    """Return centres, and radii in cells, (bodies, k, 4); a body with fewer repeats its last ball."""
    most = max(len(each.radii) for each in placed)
    found = np.empty((len(placed), most, 4))
    for k, each in enumerate(placed):
        fill = np.minimum(np.arange(most), len(each.radii) - 1)
        found[k, :, :3], found[k, :, 3] = each.centres[fill], each.radii[fill] / cell
    return found
