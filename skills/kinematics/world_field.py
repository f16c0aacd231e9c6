"""The distance field that the checkers of one group share, and what is known of the robot's bodies for it."""

from __future__ import annotations

import importlib.util
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.bodies import BoxShape, Carried, CellsShape, Obstacle
from tandem.skills.kinematics.distance_field import DistanceField
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.model import Chain
from tandem.skills.kinematics.transforms import Array

if TYPE_CHECKING:
    from tandem.skills.kinematics.quick import Quick

ACROSS: Final = 100
"""Cells along the longest side of what can be reached: 2.4 cm for the Panda, 1.4 cm for a LoCoBot. With 120
the field takes twice as long to make, and easy plans cost little more than that."""
REACH: Final = 5.0
"""Cells: more than the radius of a limb's balls; a field that tells more takes longer to make."""
MARGIN: Final = 0.05
"""Metres that the grid is larger than what can be reached."""


def installed() -> bool:
    """Say whether states can be looked at in the field: numba compiles what does that (extra ``fast``)."""
    return importlib.util.find_spec("numba") is not None


@dataclass(frozen=True)
class Around:
    """What a checker has besides the robot.

    Attributes:
        carried: what hands hold.
        obstacles: what stands around.
        may_touch: numbers of bodies of which some contact with an obstacle is permitted, now or later.
        resting: pairs of bodies that are permitted to rest on each other.
    """

    carried: tuple[Carried, ...] = ()
    obstacles: tuple[Obstacle, ...] = ()
    may_touch: frozenset[int] = frozenset()
    resting: frozenset[tuple[int, int]] = frozenset()


class WorldField:
    """One field, kept between checkers: what stands as it stood is not measured again.

    Args:
        hulls: the robot's bodies.
    """

    def __init__(self, hulls: RobotHulls) -> None:
        self._hulls = hulls
        self._field: DistanceField | None = None
        self._holds: tuple[Obstacle, ...] | None = None

    def warm(self, joints: Sequence[str]) -> None:
        """Find the balls and tables of a group's bodies and load the kernel now, and not in the first plan.

        It takes some tenths of a second; where the kernel was never used before, ten seconds to compile it.
        """
        links = len(self._hulls.links)
        for k in range(links):
            self._hulls.balls(k)
        for first in range(links):
            for second in range(first + 1, links):
                if not self._hulls.harmless[first, second]:
                    self._hulls.tables.table(first, second, joints)
        chain = Chain(self._hulls.robot, joints, {})
        _, reduced = pin.buildReducedModel(
            self._hulls.robot.model, self._hulls.geometry, chain.locked, chain.reference
        )
        self.quick(chain, reduced, Around()).look(np.zeros((1, len(joints))))

    def quick(self, chain: Chain, geometry: pin.GeometryModel, around: Around) -> Quick:
        """Return what looks at many states of a checker.

        Args:
            chain: its joints.
            geometry: its bodies (links, carried things, obstacles) and the pairs that may not touch.
            around: what is not the robot's own.
        """
        from tandem.skills.kinematics.balls import Body, Meeting  # noqa: PLC0415 - numba is an extra
        from tandem.skills.kinematics.quick import Quick  # noqa: PLC0415
        from tandem.skills.kinematics.spheres import model  # noqa: PLC0415

        links = len(self._hulls.links)
        objects = list(geometry.geometryObjects)[: links + len(around.carried)]
        bodies = [
            Body(
                int(each.parentJoint),
                each.placement,
                self._hulls.balls(k) if k < links else model(each.geometry),
                k in around.may_touch,
            )
            for k, each in enumerate(objects)
        ]
        meetings = []
        for pair in geometry.collisionPairs:
            first, second = int(pair.first), int(pair.second)
            if max(first, second) < len(bodies):
                known = max(first, second) < links
                table = self._hulls.tables.table(first, second, chain.joints) if known else None
                meetings.append(Meeting(first, second, table, (first, second) in around.resting))
        return Quick(chain, self._take(chain, around), bodies, meetings)

    def _take(self, chain: Chain, around: Around) -> DistanceField:
        """Return the field of what is around, large enough for all that the joints can do."""
        low, high = self._room(chain, around.carried)
        kept = self._field
        if kept is None or bool(np.any(low < kept.low) or np.any(high > kept.high)):
            cell = float(np.max(high - low)) / ACROSS
            kept = DistanceField(low - MARGIN, high + MARGIN, cell=cell, reach=REACH * cell)
            self._field, self._holds = kept, None
        self.hold(kept, around.obstacles)
        return kept

    def hold(self, field: DistanceField, obstacles: tuple[Obstacle, ...]) -> None:
        """Make a field be that of these obstacles; nothing to do if it is.

        It may be an earlier one: a checker keeps its field when a larger one takes the place.
        """
        if field is not self._field:
            field.set_obstacles(obstacles)
        elif self._holds is not obstacles:
            field.set_obstacles(obstacles)
            self._holds = obstacles

    def _room(self, chain: Chain, carried: Sequence[Carried]) -> tuple[Array, Array]:
        """Return the corners of a box that no moving body leaves."""
        longest = max((_length(each) for each in carried), default=0.0)
        lows, highs = [], []
        for each in self._hulls.reach(chain):
            metres = float(each.metres.max()) + longest
            lows.append(each.origin - metres)
            highs.append(each.origin + metres)
        return np.min(lows, axis=0), np.max(highs, axis=0)


def _length(each: Carried) -> float:
    """Return how far the farthest point of a carried thing is from its link's origin, or a little more."""
    shape = each.shape
    size = (
        shape.size
        if isinstance(shape, BoxShape | CellsShape)
        else (2 * shape.radius, 2 * shape.radius, shape.length)
    )
    return float(np.linalg.norm(each.pose_in_link.position)) + float(np.linalg.norm(size)) / 2.0
