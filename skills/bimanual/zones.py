"""The workspace of two hands at one height: S_L, S_R, C and U (two-arm thesis, 4.1.1).

A cell belongs to a hand that gets a grasp there: joint positions within the limits, the robot free of
itself, the hand at the height, pointing down by one of some pitches and in one of some headings. Nothing
is known of a table.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, TypeVar

import numpy as np
import numpy.typing as npt

from tandem.skills.geometry.poses import from_rpy
from tandem.skills.kinematics.batch import BatchChain
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.described import home_positions, load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.ik import IkSettings, SeedTable, Solver
from tandem.skills.kinematics.model import Limits
from tandem.skills.kinematics.transforms import to_se3
from tandem.skills.ports.actions.bimanual import PAIR, ZoneRow
from tandem.skills.ports.message import HandName, Quaternion, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.steps import run_through

T = TypeVar("T")
Reached = npt.NDArray[np.bool_]

TABLE: Final = 0.71
"""Metres above the floor of a table's top."""
ABOVE: Final = 0.035
"""Metres above it at which a hand grasps."""
CELL: Final = 0.05
"""Metres: the edge of a square of the table."""
NEAREST: Final = 0.25
FARTHEST: Final = 0.95
ASIDE: Final = 0.90
"""Metres in the base: x from and to, and y to both sides."""
PITCHES: Final = (math.radians(30.0), math.radians(15.0), math.radians(60.0))
"""Radians by which a hand points down, in the order in which they are tried."""
TURNS: Final = (0.0, math.radians(35.0), math.radians(-35.0), math.radians(70.0), math.radians(-70.0))
"""Headings from where a hand works best, in the order in which they are tried."""
STARTS: Final = 3
"""Postures that the inverse kinematics begins from for each pose."""
BATCH: Final = 60
"""Poses that are solved at once."""
COST: Final = 2.0
"""Robot seconds that lockstep charges for all of it."""


@dataclass(frozen=True)
class ZonesAsk:
    """Of which robot, at which height (m above the floor), with the torso where (m)."""

    description: str
    """The robot's description as JSON: one text, so that it can be remembered what was found for it."""
    height: float = TABLE
    torso: float | None = None
    """The home posture's unless given."""


@dataclass(frozen=True)
class ZonesFound:
    """Rows as in ``Zones``; ``y0`` is that of the first cells' centres."""

    height: float
    torso: float
    cell: float
    y0: float
    rows: tuple[ZoneRow, ...]


@dataclass(frozen=True)
class _Grid:
    """The cells' centres in the base, all at one height (m)."""

    xs: Sequence[float]
    ys: Sequence[float]
    z: float

    def point(self, i: int, j: int) -> Vector3:
        return (self.xs[i], self.ys[j], self.z)


@lru_cache(maxsize=4)
def zones(ask: ZonesAsk) -> ZonesFound:
    """Return the zones; takes about two seconds, the second time for the same question none."""
    description = RobotDescription.model_validate_json(ask.description)
    hulls = load_hulls(description)
    positions = dict(home_positions(description))
    lift = next((group.joints[0] for group in description.groups if group.name == "torso"), None)
    if lift is not None and ask.torso is not None:
        positions[lift] = ask.torso
    for hand in description.end_effectors:
        wide = hand.gripper.max_width / len(hand.gripper.joints)
        positions |= dict.fromkeys(hand.gripper.joints, wide)
    xs = _line(NEAREST, FARTHEST)
    ys = _line(-ASIDE, ASIDE)
    grid = _Grid(xs, ys, ask.height + ABOVE)
    left, right = (_reached(hulls, description, side, positions=positions, grid=grid) for side in PAIR)
    letters = np.where(left & right, "C", np.where(left, "L", np.where(right, "R", "U")))
    rows = tuple(ZoneRow(x=x, cells="".join(row)) for x, row in zip(xs, letters.tolist(), strict=True))
    torso = 0.0 if lift is None else float(positions.get(lift, 0.0))
    return ZonesFound(ask.height, torso, CELL, ys[0], rows)


def _line(start: float, end: float) -> list[float]:
    return [round(start + CELL * k, 4) for k in range(round((end - start) / CELL) + 1)]


def _reached(
    hulls: RobotHulls,
    description: RobotDescription,
    side: HandName,
    *,
    positions: Mapping[str, float],
    grid: _Grid,
) -> Reached:
    """Return which cells (x, y) a hand gets a grasp at.

    All cells are tried in the first way. After that only the neighbours of what was found are tried in the
    other ways, and theirs, until nothing is added: what lies beyond those is farther off.
    """
    hand = description.end_effector(side)
    checker = CollisionChecker(hulls, description.group(hand.group).joints, positions)
    bounds = hulls.robot.limits(checker.joints)
    limits = Limits(bounds.lower + 0.01, bounds.upper - 0.01, bounds.velocity)
    batch = BatchChain(checker.chain, hand.frame)
    table = SeedTable(batch, limits, np.random.default_rng(0), checker.free)
    solver = Solver(batch, limits, table, IkSettings(position_tolerance=1e-3, angle_tolerance=5e-3))
    home = np.array([positions[joint] for joint in checker.joints])

    def tried(cells: Sequence[tuple[int, int]], way: Quaternion) -> Iterator[tuple[int, int]]:
        for k in range(0, len(cells), BATCH):
            part = cells[k : k + BATCH]
            poses = [to_se3(Pose(position=grid.point(i, j), orientation=way)) for i, j in part]
            answers = run_through(solver.solve(checker.chain, poses, home, STARTS))
            for cell, answer in zip(part, answers, strict=True):
                if any(checker.free(q) for q in answer.solutions):
                    yield cell

    ways = [from_rpy(0.0, pitch, hand.work_heading + turn) for turn in TURNS for pitch in PITCHES]
    found: Reached = np.zeros((len(grid.xs), len(grid.ys)), dtype=bool)
    for cell in tried([(int(i), int(j)) for i, j in np.argwhere(~found)], ways[0]):
        found[cell] = True
    hopeless = found.copy()
    while edge := _edge(found, hopeless):
        for way in ways[1:]:
            for cell in tried([cell for cell in edge if not found[cell]], way):
                found[cell] = True
        for cell in edge:
            hopeless[cell] = True
    return found


def _edge(found: Reached, known: Reached) -> list[tuple[int, int]]:
    """Return the cells beside those found (the diagonal counts) that are not known yet."""
    wide = np.pad(found, 1)
    rows, columns = found.shape
    beside = np.zeros_like(found)
    for i in (0, 1, 2):
        for j in (0, 1, 2):
            beside |= wide[i : i + rows, j : j + columns]
    return [(int(i), int(j)) for i, j in np.argwhere(beside & ~known)]
