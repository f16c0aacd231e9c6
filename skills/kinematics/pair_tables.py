"""Whether two bodies touch that at most two joints part: measured once for all angles, and then looked up.

Neighbours of neighbours on an arm are always near each other, and coal spends half of its time on them. But
where one is, seen from the other, hangs on two joints at most. The plane of their angles is divided into
squares, and a square again where a measurement in its middle does not tell for all of it: a joint moves no
point farther than its lever arm lets it; bodies that are farther apart, or deeper in each other, stay so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from tandem.skills.kinematics.lever_arms import lever_arms, supports
from tandem.skills.kinematics.model import RobotKinematics
from tandem.skills.kinematics.transforms import Array

FREE, DOUBT, CONTACT = 0, 1, 2
"""In this order: what is worst of several counts."""
SIDE = 128
"""Squares along each axis: some 3 degrees each, of which a lever of 0.25 m makes 6 mm."""
FIRST = 8
"""Squares along each axis to begin with."""
BOTH = 2
"""Joints of a table, at the most: its answers are a square."""
SAFE = 1e-4
"""Metres by which a measurement may be wrong: coal's iterations end sooner than balls' arithmetic does."""


@dataclass(frozen=True)
class PairTable:
    """Answers for the angles of one or two joints, by name, between ``low`` and ``low + SIDE * step``."""

    joints: tuple[str, ...]
    low: Array
    step: Array
    answers: npt.NDArray[np.int8]


class PairTables:
    """The tables of one robot's bodies; made when first asked for.

    Args:
        robot: the kinematics.
        geometry: its bodies.
    """

    def __init__(self, robot: RobotKinematics, geometry: pin.GeometryModel) -> None:
        self._robot, self._geometry = robot, geometry
        self._support: npt.NDArray[np.bool_] = np.zeros((0, 0), dtype=bool)
        self._levers: Array = np.zeros((0, 0))
        self._known: dict[tuple[int, int], PairTable] = {}

    def table(self, first: int, second: int, joints: Sequence[str]) -> PairTable | None:
        """Return the table of two bodies, or None if more joints part them, or others than ``joints``."""
        if not len(self._support):
            parents = [int(body.parentJoint) for body in self._geometry.geometryObjects]
            self._support = supports(self._robot.model, parents)
            self._levers = lever_arms(self._robot.model, self._geometry.geometryObjects, self._support)
        between = np.flatnonzero(self._support[first] != self._support[second])
        names = tuple(self._robot.joints[k] for k in between)
        if not 1 <= len(names) <= BOTH or not set(names) <= set(joints):
            return None
        if (first, second) not in self._known:
            levers = self._levers[first, between] + self._levers[second, between]
            self._known[first, second] = self._make(first, second, between, levers)
        return self._known[first, second]

    def _make(self, first: int, second: int, between: npt.NDArray[np.int_], levers: Array) -> PairTable:
        model, data = self._robot.model, self._robot.model.createData()
        alone = pin.GeometryModel(self._geometry)
        alone.removeAllCollisionPairs()
        alone.addCollisionPair(pin.CollisionPair(first, second))
        found = alone.createData()
        low = np.array(model.lowerPositionLimit)[between]
        step = (np.array(model.upperPositionLimit)[between] - low) / SIDE
        answers = np.full((SIDE,) * len(between), DOUBT, dtype=np.int8)
        q = pin.neutral(model)
        width = SIDE // FIRST
        squares = [np.array(each) * width for each in np.ndindex(*(FIRST,) * len(between))]
        while squares:
            deeper = []
            for corner in squares:
                q[between] = low + (corner + width / 2.0) * step
                pin.updateGeometryPlacements(model, data, alone, found, q)
                distance = float(pin.computeDistance(alone, found, 0).min_distance)
                moved = float(levers @ step) * width / 2.0 + SAFE
                if abs(distance) > moved:
                    where = tuple(slice(int(k), int(k) + width) for k in corner)
                    answers[where] = FREE if distance > 0.0 else CONTACT
                elif width > 1:
                    halves = np.ndindex(*(2,) * len(between))
                    deeper += [corner + np.array(each) * (width // 2) for each in halves]
            squares, width = deeper, width // 2
        return PairTable(tuple(self._robot.joints[k] for k in between), low, step, answers)


class Angles:
    """What the tables of several pairs say together about configurations of a group.

    Args:
        joints: the group's, in the order of every array (n,) here.
        tables: the pairs'.
        strict: whether a contact of each pair counts; else it is only in doubt.
    """

    def __init__(
        self, joints: Sequence[str], tables: Sequence[PairTable], strict: Sequence[bool] | None = None
    ) -> None:
        merged: dict[tuple[str, ...], tuple[PairTable, npt.NDArray[np.int8]]] = {}
        for k, table in enumerate(tables):
            answers = table.answers if strict is None or strict[k] else np.minimum(table.answers, DOUBT)
            known = merged.get(table.joints)
            merged[table.joints] = (table, answers if known is None else np.maximum(known[1], answers))
        order = list(joints)
        self._tables = [
            ([order.index(name) for name in table.joints], table.low, 1.0 / table.step, answers)
            for table, answers in merged.values()
        ]

    def many(self, q: Array) -> npt.NDArray[np.int8]:
        """Return that of configurations (m, n): (m,)."""
        found = np.zeros(len(q), dtype=np.int8)
        for columns, low, each, answers in self._tables:
            at = np.floor((q[:, columns] - low) * each).astype(int)
            inside = ((at >= 0) & (at < SIDE)).all(axis=1)
            cells = np.clip(at, 0, SIDE - 1)
            np.maximum(found, np.where(inside, answers[tuple(cells.T)], DOUBT), out=found)
        return found

    def arrays(self) -> tuple[npt.NDArray[np.int64], Array, npt.NDArray[np.int8]]:
        """Return columns (t, 2), low and squares a radian (t, 4), and answers (t, SIDE, SIDE)."""
        columns = np.zeros((len(self._tables), 2), dtype=np.int64)
        ranges = np.zeros((len(self._tables), 4))
        found = np.zeros((len(self._tables), SIDE, SIDE), dtype=np.int8)
        for k, (each, low, many, answers) in enumerate(self._tables):
            last = len(each) - 1
            columns[k] = each[0], each[last]
            ranges[k] = low[0], many[0], low[last], many[last]
            found[k] = answers if last else np.broadcast_to(answers[:, None], (SIDE, SIDE))
        return columns, ranges, found
