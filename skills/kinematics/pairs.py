"""The bodies of one checker, and which pairs of them can meet at all."""

from __future__ import annotations

from collections.abc import Sequence

import coal
import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.bodies import BoxShape, Carried, CellsShape, Obstacle, geometry
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.model import Chain
from tandem.skills.kinematics.transforms import Array, to_se3

Pairs = npt.NDArray[np.bool_]
SLACK = 0.01
"""Metres more than what can be reached."""


class Bodies:
    """Gathers the bodies of one checker: the robot's links, what is carried, obstacles.

    Args:
        hulls: the robot's.
        chain: the joints that move.
        reduced: the robot's bodies on the chain's model.
    """

    def __init__(self, hulls: RobotHulls, chain: Chain, reduced: pin.GeometryModel) -> None:
        self._chain, self._hulls, self._model = chain, hulls, reduced
        self.names = list(hulls.links)
        self._links = len(self.names)
        self._carried: list[Carried] = []
        self._obstacles: list[tuple[pin.SE3, Array]] = []

    def is_carried(self, body: int) -> bool:
        """Say whether the body is one that is carried."""
        return self._links <= int(body) < self._links + len(self._carried)

    def has_world(self, pair: pin.CollisionPair) -> bool:
        """Say whether one body of the pair is an obstacle."""
        return max(int(pair.first), int(pair.second)) >= self._links + len(self._carried)

    def add_carried(self, carried: Sequence[Carried]) -> None:
        """Add what is carried; before the obstacles."""
        for each in carried:
            frame = self._chain.model.frames[self._chain.frame(each.link)]
            placement = frame.placement * to_se3(each.pose_in_link)
            self._add(each.name, frame.parentJoint, placement, geometry(each.shape))
            self._carried.append(each)

    def add_obstacles(self, obstacles: Sequence[Obstacle]) -> None:
        """Add what stands around."""
        for each in obstacles:
            placement = to_se3(each.pose_in_base)
            self._add(each.name, 0, placement, geometry(each.shape, each.padding))
            self._obstacles.append((placement, _half(each)))

    def _add(self, name: str, joint: int, placement: pin.SE3, shape: coal.CollisionGeometry) -> None:
        label = f"{name}#{len(self.names)}"
        self._model.addGeometryObject(pin.GeometryObject(label, int(joint), placement, shape))
        self.names.append(name)

    def build(
        self, allowed: Sequence[tuple[str, str]], touchable: Sequence[tuple[str, str]]
    ) -> tuple[pin.GeometryModel, tuple[int, ...]]:
        """Return the geometry with its pairs, and the numbers of the touchable pairs."""
        bodies = self._model.geometryObjects
        joints = np.array([int(body.parentJoint) for body in bodies])
        matrix = np.triu(joints[:, None] != joints[None, :], 1)
        matrix[: self._links, : self._links] &= ~self._hulls.harmless
        touching = [(each.name, link) for each in self._carried for link in each.touch]
        matrix &= ~self._named([*allowed, *touching])
        matrix &= self._near(bodies, joints)
        self._model.setCollisionPairs(matrix)
        special = matrix & self._named(touchable)
        return self._model, tuple(int(k) for k in np.flatnonzero(special[matrix]))

    def _named(self, pairs: Sequence[tuple[str, str]]) -> Pairs:
        """Return the upper triangle with the named pairs set."""
        rows: dict[str, list[int]] = {}
        for i, name in enumerate(self.names):
            rows.setdefault(name, []).append(i)
        found = np.zeros((len(self.names), len(self.names)), dtype=bool)
        for one, other in pairs:
            for i in rows.get(one, ()):
                for j in rows.get(other, ()):
                    found[min(i, j), max(i, j)] = True
        return found

    def _near(self, bodies: Sequence[pin.GeometryObject], joints: npt.NDArray[np.int_]) -> Pairs:
        """Return which pairs of a moving and a standing body can meet; True for all other pairs.

        Whatever the joints do, a moving body stays within a ball about the origin of the first joint that
        moves it, of the length of the links to it.
        """
        near = np.ones((len(joints), len(joints)), dtype=bool)
        links, first = self._links, self._links + len(self._carried)
        reach = self._hulls.reach(self._chain)
        places = np.array([bodies[i].placement.translation for i in range(links)])
        standing = np.flatnonzero(joints == 0)
        for each in reach:
            away = np.linalg.norm(places - each.origin, axis=1) - self._hulls.radii
            gaps = np.concatenate((away, np.zeros(first - links), self._gaps(each.origin)))
            far = gaps[standing][None, :] > each.metres[:, None] + SLACK
            near[each.bodies[:, None], standing[None, :]] &= ~far
            near[standing[:, None], each.bodies[None, :]] &= ~far.T
        return near

    def _gaps(self, origin: Array) -> Array:
        """Return the metres between a point and each obstacle."""
        if not self._obstacles:
            return np.zeros(0)
        places = np.array([placement.translation for placement, _ in self._obstacles])
        turns = np.array([placement.rotation for placement, _ in self._obstacles])
        halves = np.array([half for _, half in self._obstacles])
        inside = np.einsum("kji,kj->ki", turns, origin - places)
        return np.asarray(np.linalg.norm(np.maximum(np.abs(inside) - halves, 0.0), axis=1))


def _half(each: Obstacle) -> Array:
    around, along = each.padding
    if isinstance(each.shape, BoxShape | CellsShape):
        size = np.array(each.shape.size) / 2.0
    else:
        size = np.array([each.shape.radius, each.shape.radius, each.shape.length / 2.0])
    return np.asarray(size + np.array([around, around, along]))
