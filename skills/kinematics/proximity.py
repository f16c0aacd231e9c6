"""How far a group is from everything else, where it is nearest, and how its joints change that.

Unlike ``CollisionChecker`` nothing is locked: the other arm, the torso and the head stand wherever they are
told to be at each look. A distance changes by no more than the two bodies move, and how far a body moves is
bounded by the joints' changes times their lever arms. So a look measures only those pairs that may have
come near since they were last measured (the idea of conservative advancement: Mirtich, "Impulse-based
Dynamic Simulation", 1996, 2.3.2); most are skipped, and nothing is missed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.bodies import Carried, Obstacle, geometry
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.lever_arms import lever_arms, reach_of, supports
from tandem.skills.kinematics.transforms import Array, to_se3

MANY = 25
"""Pairs for which it pays to look at the balls around the bodies first."""
TOUCHING = 1e-6
"""Metres below which two points are no direction any more; then coal's own normal is taken."""


@dataclass(frozen=True)
class Nearby:
    """The pairs that are near, m of them.

    ``pair`` (m,), their numbers; ``distance`` (m,) in metres (below zero: overlap); ``gradient`` (m, n),
    metres a radian of the group's joints; ``normal`` (m, 3), unit, in the base, from the other body to the
    group's; ``body`` and ``other`` (m,), numbers of ``Proximity.names``.
    """

    pair: npt.NDArray[np.int_]
    distance: Array
    gradient: Array
    normal: Array
    body: npt.NDArray[np.int_]
    other: npt.NDArray[np.int_]


class Proximity:
    """Distances between a group with what it carries, and all other bodies.

    Args:
        hulls: the robot's bodies.
        joints: those of the group; the order of every gradient.
        carried: what hands hold.
        obstacles: the world, in the base frame.
    """

    def __init__(
        self,
        hulls: RobotHulls,
        joints: Sequence[str],
        carried: Sequence[Carried] = (),
        obstacles: Sequence[Obstacle] = (),
    ) -> None:
        self._hulls, self._model = hulls, hulls.robot.model
        self._data = self._model.createData()
        self._columns = np.array([hulls.robot.joint_index(joint) for joint in joints])
        self._joints = frozenset(int(k) + 1 for k in self._columns)
        self._carried, self._obstacles = tuple(carried), tuple(obstacles)
        self.built = 0
        """Counts how often the bodies were gathered anew; the pairs' numbers hold for one time."""
        self._build()

    def _build(self) -> None:
        self.built += 1
        self._geometry = pin.GeometryModel(self._hulls.geometry)
        self.names = list(self._hulls.links)
        for each in self._carried:
            frame = self._model.frames[self._hulls.robot.frame_index(each.link)]
            placed = frame.placement * to_se3(each.pose_in_link)
            self._add(each.name, int(frame.parentJoint), placed, geometry(each.shape))
        self.first_obstacle = len(self.names)
        """Number of the first obstacle; those below are links and carried things."""
        for obstacle in self._obstacles:
            self._add(
                obstacle.name, 0, to_se3(obstacle.pose_in_base), geometry(obstacle.shape, obstacle.padding)
            )
        bodies = self._geometry.geometryObjects
        support = supports(self._model, [int(body.parentJoint) for body in bodies])
        self._mine = support[:, self._columns]
        first, second = self._pairs([int(body.parentJoint) for body in bodies])
        self._first, self._second = first, second
        self._geometry.removeAllCollisionPairs()
        for i, j in zip(first, second, strict=True):
            self._geometry.addCollisionPair(pin.CollisionPair(int(i), int(j)))
        self._found = self._geometry.createData()
        self._radii = np.array([reach_of(body) for body in bodies])
        levers = lever_arms(self._model, bodies, support)
        both = support[first] & support[second]
        self._levers = np.where(both, 0.0, levers[first] + levers[second])
        self._at = np.zeros(self._model.nq)
        self.lower: Array = np.full(len(first), -np.inf)
        """Metres that each pair is apart at the last look, or fewer; exact where it is near, (pairs,)."""
        self.of_robot: npt.NDArray[np.bool_] = second < len(self._hulls.links)
        """Which pairs are two links of the robot, (pairs,)."""
        self.of_group: npt.NDArray[np.bool_] = np.asarray(self._mine[second].any(axis=1))
        """Which pairs are two bodies that the group moves, (pairs,)."""

    def _add(self, name: str, joint: int, placement: pin.SE3, shape: object) -> None:
        label = f"{name}#{len(self.names)}"
        self._geometry.addGeometryObject(pin.GeometryObject(label, joint, placement, shape))
        self.names.append(name)

    def _pairs(self, parents: list[int]) -> tuple[npt.NDArray[np.int_], npt.NDArray[np.int_]]:
        """Return the pairs' bodies: first one of the group's, then the other (perhaps the group's too)."""
        count, links = len(self.names), len(self._hulls.links)
        moves: npt.NDArray[np.bool_] = np.asarray(self._mine.any(axis=1))
        wanted: npt.NDArray[np.bool_] = np.triu(np.ones((count, count), dtype=bool), 1)
        wanted[:links, :links] &= ~self._hulls.harmless
        at = np.array(parents)
        wanted = np.asarray(wanted & (moves[:, None] | moves) & (at[:, None] != at))
        for k, each in enumerate(self._carried, start=links):
            for i in range(links):
                if self.names[i] in each.touch:
                    wanted[i, k] = False
        one, other = np.nonzero(wanted)
        swap = ~moves[one]
        return np.where(swap, other, one), np.where(swap, one, other)

    @property
    def pairs(self) -> int:
        """How many pairs of bodies are watched."""
        return len(self._first)

    def stand(self, obstacles: Sequence[Obstacle], carried: Sequence[Carried]) -> None:
        """Take what stands around and what is carried now."""
        before = [(each.name, each.shape, each.padding) for each in self._obstacles]
        now = [(each.name, each.shape, each.padding) for each in obstacles]
        if tuple(carried) != self._carried or before != now:
            self._carried, self._obstacles = tuple(carried), tuple(obstacles)
            self._build()
            return
        for k, (was, new) in enumerate(zip(self._obstacles, obstacles, strict=True)):
            if was.pose_in_base != new.pose_in_base:
                body = self.first_obstacle + k
                self._geometry.geometryObjects[body].placement = to_se3(new.pose_in_base)
                self.lower[self._second == body] = -np.inf
        self._obstacles = tuple(obstacles)

    def look(self, q: Array, within: Array) -> Nearby:
        """Return what is near.

        Args:
            q: positions of all joints of the robot (``RobotKinematics.configuration``).
            within: metres, one for each pair.
        """
        self.lower -= self._levers @ np.abs(q - self._at)
        self._at = q.copy()
        pin.computeJointJacobians(self._model, self._data, q)
        pin.updateGeometryPlacements(self._model, self._data, self._geometry, self._found)
        near = []
        for k in np.flatnonzero(self.lower < within).tolist():
            measured = self._measure(k)
            self.lower[k] = measured
            if measured < within[k]:
                near.append(k)
        return self._describe(np.array(near, dtype=np.int_))

    def hits(self, q: Array, floors: Array) -> int | None:
        """Return a pair that is nearer than its floor at ``q``, or None. Ask near where was last looked.

        Args:
            q: positions of all joints of the robot.
            floors: metres, one for each pair or one for all.
        """
        lower = self.lower - self._levers @ np.abs(q - self._at)
        doubtful = np.flatnonzero(lower < floors)
        if not len(doubtful):
            return None
        pin.updateGeometryPlacements(self._model, self._data, self._geometry, self._found, q)
        wide = np.broadcast_to(floors, lower.shape)
        for k in self._balls(doubtful, wide).tolist():
            if self._measure(k) < wide[k]:
                return int(k)
        return None

    def hand(self, frame: str) -> tuple[Array, Array]:
        """Return a frame in the base (4, 4), and its Jacobian (6, n) as ``Chain.jacobian`` tells it.

        Of the last look; ask before anything else is asked.
        """
        placed = pin.updateFramePlacement(self._model, self._data, self._hulls.robot.frame_index(frame))
        jacobian = np.array(self._data.J)[:, self._columns]
        jacobian[:3] += _cross(jacobian[3:].T, np.asarray(placed.translation)).T
        return np.array(placed.homogeneous), jacobian

    def pair(self, number: int) -> tuple[str, str]:
        """Return the names of a pair's bodies."""
        return self.names[int(self._first[number])], self.names[int(self._second[number])]

    def _balls(self, pairs: npt.NDArray[np.int_], floors: Array) -> npt.NDArray[np.int_]:
        """Return those of the pairs whose bodies' enclosing balls are nearer than the floors."""
        if len(pairs) < MANY:
            return pairs
        places = np.array([placed.translation for placed in self._found.oMg])
        first, second = self._first[pairs], self._second[pairs]
        away = places[first] - places[second]
        gaps = np.sqrt(np.einsum("ij,ij->i", away, away)) - self._radii[first] - self._radii[second]
        return np.asarray(pairs[gaps < floors[pairs]])

    def _measure(self, pair: int) -> float:
        return float(pin.computeDistance(self._geometry, self._found, pair).min_distance)

    def _describe(self, near: npt.NDArray[np.int_]) -> Nearby:
        first, second = self._first[near], self._second[near]
        results = self._found.distanceResults
        distance, normals = np.empty(len(near)), np.empty((len(near), 3))
        points, others = np.empty((len(near), 3)), np.empty((len(near), 3))
        for row, k in enumerate(near.tolist()):
            result, pair = results[k], self._geometry.collisionPairs[k]
            mine, its = result.getNearestPoint1(), result.getNearestPoint2()
            normal = -np.asarray(result.normal)
            if int(pair.first) != int(self._first[k]):
                mine, its, normal = its, mine, -normal
            distance[row], points[row], others[row], normals[row] = result.min_distance, mine, its, normal
        between = points - others
        apart = distance > TOUCHING
        normals[apart] = between[apart] / distance[apart, None]
        jacobian = np.asarray(self._data.J)[:, self._columns]
        rows = (normals @ jacobian[:3] + _cross(points, normals) @ jacobian[3:]) * self._mine[first]
        rows -= (normals @ jacobian[:3] + _cross(others, normals) @ jacobian[3:]) * self._mine[second]
        return Nearby(near, distance, rows, normals, first, second)


def _cross(a: Array, b: Array) -> Array:
    """Return a x b over the last axis (numpy's own is slow for small arrays)."""
    x, y, z = a[..., 0], a[..., 1], a[..., 2]
    u, v, w = b[..., 0], b[..., 1], b[..., 2]
    return np.stack((y * w - z * v, z * u - x * w, x * v - y * u), axis=-1)
