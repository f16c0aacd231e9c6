"""Spheres for a convex body: some that cover it, and some that lie within.

Covering: the body is cut into convex pieces, and each piece is enclosed in a ball, as sphere trees are made
from the top down (Hubbard, "Approximating Polyhedra with Spheres for Time-Critical Collision Detection", ACM
TOG 15(3), 1996). The piece whose ball reaches farthest out of the body is cut next, across the axis that
leaves least of that. A ball's radius is the distance of the piece's farthest corner: it is never too small.

Within: a ball about a point of a polytope may be as large as the nearest face is far. Points are the pieces'
centres, climbed away from the nearest faces, and those that add most are kept.
"""

from __future__ import annotations

from dataclasses import dataclass

import coal
import numpy as np
import numpy.typing as npt

from tandem.skills.kinematics.kernel import best_ball
from tandem.skills.kinematics.transforms import Array

Edges = npt.NDArray[np.int_]
ENOUGH = 0.005
"""Metres that a covering ball may reach out of the body; cuts end there. The field's cells cost as much."""
MOST = 24
"""Balls of a body. They reach out by 12 mm on average (Panda, TIAGo++); 8 of them by 20 mm, 40 by 9 mm."""
FEW = 4
"""Balls of a body where it is compared with another body of the robot."""
INNER = 6
"""Balls within a body."""
GAIN = 0.2
"""Share of the largest inner ball that another one must add."""
ROUNDS = 40
"""Steps towards a piece's best ball; twice as many gain less than a millimetre."""
SIDES = 16
"""Of the prism that stands for a cylinder."""
ROUNDING = 1e-6
"""Metres by which balls are larger, or smaller, than reckoned."""
CLIMBS = 20
"""Steps of a ball's centre away from the nearest faces; each that does not gain is halved."""


@dataclass(frozen=True)
class Spheres:
    """Balls in one frame: centres (k, 3) and radii (k,), metres."""

    centres: Array
    radii: Array


@dataclass(frozen=True)
class Polytope:
    """A convex body: corners (n, 3), edges (e, 2), and faces n.x <= d as normals (f, 3) and offsets (f,)."""

    corners: Array
    edges: Edges
    normals: Array
    offsets: Array
    axes: Array
    """Its own axes (3, 3), the longest first: pieces are cut across them."""

    def depth(self, points: Array) -> Array:
        """Return how far inside the points (m, 3) are (m,); below zero: outside, by at least so much."""
        return np.asarray(np.min(self.offsets - points @ self.normals.T, axis=1))


@dataclass(frozen=True)
class _Piece:
    """A part of a body, and its ball."""

    corners: Array
    edges: Edges
    centre: Array
    radius: float
    beyond: float
    """Metres that the ball reaches out of the body, or a little more."""


@dataclass(frozen=True)
class SphereModel:
    """What stands for a convex body: balls that hold all of it, a few such, one such, and balls within it."""

    covering: Spheres
    few: Spheres
    one: Spheres
    within: Spheres


def model(shape: coal.CollisionGeometry, most: int = MOST, enough: float = ENOUGH) -> SphereModel:
    """Return the balls of a convex body, in its own frame.

    Args:
        shape: a box, cylinder, sphere or convex mesh.
        most: how many balls cover it at the most.
        enough: metres that they may reach out.
    """
    if isinstance(shape, coal.Sphere):
        ball = Spheres(np.zeros((1, 3)), np.array([float(shape.radius)]))
        return SphereModel(ball, ball, ball, ball)
    body = outer(shape)
    pieces = [_piece(body, body.corners, body.edges)]
    one, few = _balls(pieces), _balls(pieces)
    while len(pieces) < most and _cut(body, pieces, enough):
        few = _balls(pieces) if len(pieces) <= FEW else few
    centres = np.array([each.centre for each in pieces])
    inner = _polytope(_prism(shape, 1.0)) if isinstance(shape, coal.Cylinder) else body
    return SphereModel(_balls(pieces), few, one, _within(inner, centres))


def _balls(pieces: list[_Piece]) -> Spheres:
    radii = np.array([each.radius for each in pieces]) + ROUNDING
    return Spheres(np.array([each.centre for each in pieces]), radii)


def _within(body: Polytope, begin: Array) -> Spheres:
    """Return balls that lie wholly within a polytope, the largest first."""
    points = _climb(body, begin)
    depths = body.depth(points)
    kept: list[int] = []
    gain = depths.copy()
    while len(kept) < INNER and float(gain.max()) > 2.0 * ROUNDING:
        kept.append(int(np.argmax(gain)))
        apart = np.linalg.norm(points - points[kept[-1]], axis=1)
        gain = np.minimum(gain, depths + apart - depths[kept[-1]])
        gain[gain < GAIN * depths[kept[0]]] = 0.0
    return Spheres(points[kept], depths[kept] - ROUNDING)


def outer(shape: coal.CollisionGeometry) -> Polytope:
    """Return a polytope that holds the shape: itself, if it is one."""
    if isinstance(shape, coal.Box):
        half = np.asarray(shape.halfSide, dtype=float)
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
        return _polytope(signs * half)
    if isinstance(shape, coal.Cylinder):
        return _polytope(_prism(shape, 1.0 / np.cos(np.pi / SIDES)))
    return _polytope(np.array(shape.points(), dtype=float))


def _prism(shape: coal.Cylinder, wider: float) -> Array:
    angles = 2.0 * np.pi * np.arange(SIDES) / SIDES
    ring = float(shape.radius) * wider * np.stack((np.cos(angles), np.sin(angles)), axis=1)
    half = float(shape.halfLength)
    return np.concatenate([np.column_stack((ring, np.full(SIDES, z))) for z in (-half, half)])


def _polytope(points: Array) -> Polytope:
    """Return the convex hull of points."""
    gathered = coal.StdVec_Vec3s()
    for each in points:
        gathered.append(each)
    hull = coal.Convex.convexHull(gathered, True, "Qt")
    corners = np.array(hull.points(), dtype=float)
    triangles = np.array([[hull.polygons(k)[i] for i in range(3)] for k in range(hull.num_polygons)])
    first, second, third = (corners[triangles[:, k]] for k in range(3))
    normals = np.cross(second - first, third - first)
    sizes = np.linalg.norm(normals, axis=1)
    good = sizes > 1e-12  # noqa: PLR2004 - slivers have no direction; their neighbours' faces are the same
    normals = normals[good] / sizes[good, None]
    middle = corners.mean(axis=0)
    normals *= np.where(np.einsum("ij,ij->i", normals, first[good] - middle) < 0.0, -1.0, 1.0)[:, None]
    # A face's offset is its farthest corner's: rounding must not put a corner outside.
    offsets = (corners @ normals.T).max(axis=0)
    edges = np.sort(
        np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [0, 2]]]), axis=1
    )
    axes = np.linalg.svd(corners - middle, full_matrices=False)[2]
    return Polytope(corners, np.unique(edges, axis=0), normals, offsets, axes)


def _cut(body: Polytope, pieces: list[_Piece], enough: float) -> bool:
    """Cut the piece whose ball reaches out most; say False if that is little enough or can't be done."""
    worst = max(range(len(pieces)), key=lambda k: pieces[k].beyond)
    if pieces[worst].beyond <= enough:
        return False
    found = [halves for axis in body.axes if len(halves := _halves(body, pieces[worst], axis)) > 1]
    if found:
        pieces[worst : worst + 1] = min(found, key=lambda halves: sum(each.beyond for each in halves))
    return bool(found)


def _halves(body: Polytope, piece: _Piece, axis: Array) -> list[_Piece]:
    """Return the two parts of a piece on both sides of the plane across its middle."""
    along = piece.corners @ axis
    low, high = float(along.min()), float(along.max())
    if high - low < 1e-4:  # noqa: PLR2004 - a tenth of a millimetre
        return []
    heights = along - 0.5 * (low + high)
    heights[np.abs(heights) < ROUNDING / 10.0] = ROUNDING / 10.0  # no corner lies in the plane
    a, b = piece.edges[:, 0], piece.edges[:, 1]
    crossing = heights[a] * heights[b] < 0.0
    a, b = a[crossing], b[crossing]
    share = (heights[a] / (heights[a] - heights[b]))[:, None]
    cut = piece.corners[a] * (1.0 - share) + piece.corners[b] * share
    parts = []
    for side in (heights > 0.0, heights < 0.0):
        kept = np.flatnonzero(side)
        numbers = np.full(len(heights), -1)
        numbers[kept] = np.arange(len(kept))
        inner = piece.edges[side[piece.edges].all(axis=1)]
        on = len(kept) + np.arange(len(cut))
        rim = _around(cut, axis)
        edges = np.concatenate(
            (
                numbers[inner],
                np.column_stack((numbers[np.where(side[a], a, b)], on)),
                np.column_stack((on[rim], on[np.roll(rim, -1)])),
            )
        )
        parts.append(_piece(body, np.concatenate((piece.corners[kept], cut)), edges))
    return parts


def _around(points: Array, axis: Array) -> npt.NDArray[np.int_]:
    """Return the order of the points of a convex polygon, around it."""
    aside = np.eye(3)[int(np.argmin(np.abs(axis)))]
    first = np.cross(axis, aside)
    second = np.cross(axis, first)
    from_middle = points - points.mean(axis=0)
    return np.argsort(np.arctan2(from_middle @ second, from_middle @ first))


def _piece(body: Polytope, corners: Array, edges: Edges) -> _Piece:
    """Return a piece with the ball about it that reaches out least.

    Both the farthest corner's distance and the nearest face's (below zero within) are convex functions of the
    centre, and so is their sum: steps against its slope, shorter and shorter, come near the least.
    """
    centre, radius, beyond = best_ball(corners, body.normals, body.offsets, ROUNDS)
    return _Piece(corners, edges, centre, radius, beyond)


def _climb(body: Polytope, points: Array) -> Array:
    """Move points away from the nearest faces, while that takes them deeper."""
    points = points.copy()
    steps = np.full(len(points), 0.25) * np.maximum(body.depth(points), 0.01)
    for _ in range(CLIMBS):
        nearest = np.argmin(body.offsets - points @ body.normals.T, axis=1)
        moved = points - steps[:, None] * body.normals[nearest]
        better = body.depth(moved) > body.depth(points)
        points[better] = moved[better]
        steps[~better] *= 0.5
    return points
