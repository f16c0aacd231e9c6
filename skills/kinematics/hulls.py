"""The robot's own collision bodies, convex, and the pairs of them that are worth a check."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import coal
import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.model import Chain, RobotKinematics
from tandem.skills.kinematics.pair_tables import PairTables
from tandem.skills.kinematics.transforms import Array

if TYPE_CHECKING:
    from tandem.skills.kinematics.spheres import SphereModel

ALWAYS = 0.95
"""A pair in contact in this share of random configurations is so by construction."""
SKIN = 0.001
"""Metres by which a mesh's hull is larger than the mesh. Bullet gives convex meshes such a margin (its boxes
and cylinders have theirs within), so the simulation's links meet 2 mm before their meshes do. With it, what
is free here is free there, and the paint and cables of a real link have some room. At corners it is up to
0.7 mm more. Nothing else adds to it: balls, tables and distances are those of the larger hull."""
APART = 2
"""Joints between two links up to which hulls may overlap that don't touch: of wrists whose axes meet."""


class RobotHulls:
    """Convex bodies of all links, and which pairs can be in contact without harm.

    Left out are pairs of one link or of two that a joint connects, pairs in contact in a ``home``
    configuration, and pairs in contact nearly always (as MoveIt's setup assistant does).

    Args:
        robot: the kinematics; its URDF names the meshes.
        homes: full configurations, by joint name, known to be free.
        rng: draws the random configurations.
        samples: how many of them.
    """

    def __init__(
        self,
        robot: RobotKinematics,
        homes: Sequence[Mapping[str, float]],
        rng: np.random.Generator,
        samples: int = 150,
    ) -> None:
        self.robot = robot
        self.geometry = pin.buildGeomFromUrdfString(robot.model, robot.urdf, pin.GeometryType.COLLISION)
        for body in self.geometry.geometryObjects:
            _make_convex(body)
        self.links: tuple[str, ...] = tuple(
            robot.model.frames[body.parentFrame].name for body in self.geometry.geometryObjects
        )
        self.radii = np.array([_radius(body) for body in self.geometry.geometryObjects])
        """Metres from each body's origin to its farthest point, or a little more, (links,)."""
        self._reach: dict[tuple[str, ...], tuple[Reach, ...]] = {}
        count = len(self.links)
        self.harmless: npt.NDArray[np.bool_] = np.zeros((count, count), dtype=bool)
        """(links, links), upper triangle: pairs that are never checked."""
        self._leave_out(self._adjacent())
        self.geometry.setCollisionPairs(np.triu(~self.harmless, 1))
        self._leave_out(self._touching(homes, 1e-9))
        self._leave_out(self._touching([self._draw(homes, rng) for _ in range(samples)], ALWAYS))
        self.tables = PairTables(robot, self.geometry)
        """Which neighbours touch at which angles."""
        self._balls: dict[bytes, SphereModel] = {}
        self._of_body: dict[int, SphereModel] = {}

    def overlapping(self, positions: Mapping[str, float]) -> list[tuple[float, str, str]]:
        """Return which links are in each other, and how deep (m), deepest first.

        Args:
            positions: by joint name. Links are looked at that are more than ``APART`` joints apart.
        """
        model = self.robot.model
        data, placed = model.createData(), self.geometry.createData()
        pin.updateGeometryPlacements(model, data, self.geometry, placed, self.robot.configuration(positions))
        bodies = self.geometry.geometryObjects
        carrying = [set(model.supports[body.parentJoint]) for body in bodies]
        found = []
        for i, j in itertools.combinations(range(len(bodies)), 2):
            if len(carrying[i] ^ carrying[j]) > APART:
                told = coal.DistanceResult()
                wanted = coal.DistanceRequest()
                gap = coal.distance(
                    bodies[i].geometry, placed.oMg[i], bodies[j].geometry, placed.oMg[j], wanted, told
                )
                if gap < 0.0:
                    found.append((-float(gap), self.links[i], self.links[j]))
        return sorted(found, reverse=True)

    def corners(self, joints: Sequence[str], frame: str) -> Array:
        """Return the corners (n, 3) of boxes about the bodies that hang on these joints, all of them at zero.

        Args:
            joints: each carries bodies of its own.
            frame: the link in whose frame (m) the corners are told.
        """
        model = self.robot.model
        data, placed = model.createData(), self.geometry.createData()
        pin.framesForwardKinematics(model, data, pin.neutral(model))
        pin.updateGeometryPlacements(model, data, self.geometry, placed)
        origin = data.oMf[model.getFrameId(frame)].inverse()
        found = [np.zeros(3)]
        for body, at in zip(self.geometry.geometryObjects, placed.oMg, strict=True):
            if model.names[body.parentJoint] in joints:
                box, here = body.geometry.aabb_local, origin * at
                ends = zip(np.array(box.min_), np.array(box.max_), strict=True)
                found += [here.act(np.array(corner)) for corner in itertools.product(*ends)]
        return np.array(found)

    def balls(self, body: int) -> SphereModel:
        """Return the balls that stand for a body, in its own frame; found at the first time."""
        from tandem.skills.kinematics.spheres import model, outer  # noqa: PLC0415 - numba is an extra

        if body not in self._of_body:
            shape = self.geometry.geometryObjects[body].geometry
            sphere = isinstance(shape, coal.Sphere)
            key = repr(float(shape.radius)).encode() if sphere else outer(shape).corners.tobytes()
            if key not in self._balls:  # a robot's left and right are often the same
                self._balls[key] = model(shape)
            self._of_body[body] = self._balls[key]
        return self._of_body[body]

    def reach(self, chain: Chain) -> tuple[Reach, ...]:
        """Return how far the bodies that a chain moves can get from where its first joints are."""
        if chain.joints not in self._reach:
            self._reach[chain.joints] = self._measure(chain)
        known = self._reach[chain.joints]
        model = chain.model
        return tuple(
            Reach(
                np.array(model.jointPlacements[each.joint].translation), each.bodies, each.metres, each.joint
            )
            for each in known
        )

    def _measure(self, chain: Chain) -> tuple[Reach, ...]:
        model, whole = chain.model, self.robot.model
        names = list(model.names)
        found: dict[int, list[tuple[int, float]]] = {}
        for i, body in enumerate(self.geometry.geometryObjects):
            carrying = [int(j) for j in whole.supports[body.parentJoint] if j > 0]
            above = [k for k, j in enumerate(carrying) if whole.names[j] in chain.joints]
            if not above:
                continue
            way = [int(j) for j in model.supports[names.index(whole.names[carrying[above[-1]]])] if j > 0]
            # A finger hangs on the last moving link by a joint that is locked here, in whatever place.
            hanging = carrying[above[-1] + 1 :]
            length = sum(_stride(model, j, placed=j != way[0]) for j in way)
            length += sum(_stride(whole, j, placed=True) for j in hanging)
            length += float(np.linalg.norm(body.placement.translation)) + float(self.radii[i])
            found.setdefault(way[0], []).append((i, length))
        return tuple(
            Reach(np.zeros(3), np.array([i for i, _ in each]), np.array([r for _, r in each]), joint)
            for joint, each in sorted(found.items())
        )

    def _leave_out(self, pairs: Sequence[tuple[int, int]]) -> None:
        for i, j in pairs:
            self.harmless[i, j] = True

    def _adjacent(self) -> list[tuple[int, int]]:
        bodies, parents = self.geometry.geometryObjects, self.robot.model.parents
        joints = [body.parentJoint for body in bodies]
        return [
            (i, j)
            for i in range(len(joints))
            for j in range(i + 1, len(joints))
            if joints[i] == joints[j] or parents[joints[i]] == joints[j] or parents[joints[j]] == joints[i]
        ]

    def _draw(self, homes: Sequence[Mapping[str, float]], rng: np.random.Generator) -> dict[str, float]:
        drawn = dict(homes[0]) if homes else {}
        for joints in self.robot.groups.values():
            limits = self.robot.limits(joints)
            drawn |= dict(zip(joints, map(float, rng.uniform(limits.lower, limits.upper)), strict=True))
        return drawn

    def _touching(self, configurations: Sequence[Mapping[str, float]], share: float) -> list[tuple[int, int]]:
        if not configurations:
            return []
        data, geometry_data = self.robot.model.createData(), self.geometry.createData()
        counts = np.zeros(len(self.geometry.collisionPairs))
        for positions in configurations:
            q = self.robot.configuration(positions)
            pin.computeCollisions(self.robot.model, data, self.geometry, geometry_data, q, False)
            counts += [result.isCollision() for result in geometry_data.collisionResults]
        often = np.flatnonzero(counts / len(configurations) >= share)
        pairs = self.geometry.collisionPairs
        return [(int(pairs[int(k)].first), int(pairs[int(k)].second)) for k in often]


@dataclass(frozen=True)
class Reach:
    """Bodies (numbers) that stay within so many metres (k,) of ``origin``, that of their first joint."""

    origin: Array
    bodies: npt.NDArray[np.int_]
    metres: Array
    joint: int


def _stride(model: pin.Model, joint: int, *, placed: bool) -> float:
    """Return the longest way from the joint before to this one (if ``placed``) and along it, if it shifts."""
    way = float(np.linalg.norm(model.jointPlacements[joint].translation)) if placed else 0.0
    if model.joints[joint].shortname().startswith("JointModelP"):
        k = model.joints[joint].idx_q
        way += float(max(abs(model.lowerPositionLimit[k]), abs(model.upperPositionLimit[k])))
    return way


def _radius(body: pin.GeometryObject) -> float:
    box = body.geometry.aabb_local
    far = np.maximum(np.abs(np.array(box.min_)), np.abs(np.array(box.max_)))
    return float(np.linalg.norm(far))


def _make_convex(body: pin.GeometryObject) -> None:
    mesh = body.geometry
    if isinstance(mesh, coal.BVHModelBase):
        mesh.buildConvexHull(True, "Qt")
        body.geometry = _grown(np.array(mesh.convex.points()), SKIN)
    body.geometry.computeLocalAABB()


def _grown(points: Array, by: float) -> coal.Convex:
    """Return the hull of points (n, 3) with all that is within ``by`` metres of it: its sum with a cube."""
    gathered = coal.StdVec_Vec3s()
    for corner in itertools.product((-by, by), repeat=3):
        for each in points + np.array(corner):
            gathered.append(each)
    return coal.Convex.convexHull(gathered, True, "Qt")
