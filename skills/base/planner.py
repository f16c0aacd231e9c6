"""Plan a way: A* over the floor (Hart, Nilsson & Raphael 1968), then pull it straight, then check it.

The grid has every other node of the clearance field, so the field also knows the middle of each step. Keeping
away from things is worth a detour: a step costs more the closer it passes. Work is sliced by counts.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Generator, Iterator
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from tandem.skills.base.field import DistanceField
from tandem.skills.base.floor import FloatArray
from tandem.skills.base.obstacles import with_obstacles
from tandem.skills.base.path import Path
from tandem.skills.ports.pose import FloorPose

EXPANSIONS: Final = 100
"""Nodes expanded in a slice."""
PULLS: Final = 15
"""Straight lines tried in a slice."""
COMFORT: Final = 0.25
"""Metres beyond the clearance needed from which on nothing is gained by more."""
CROWDED: Final = 1.5
"""What a metre at the least clearance costs on top of a free metre."""
ESCAPE: Final = 0.6
"""Metres around a start that is too close to things, within which the path may be as close."""
LEAST: Final = 0.12
"""Metres of clearance that even an escape needs."""
SLACK: Final = 0.008
"""Metres by which the check is more lenient than the search: steps are checked at ends and middles."""
RUN_UP: Final = 0.4
"""Metres that the last straight piece should have."""
CHECK_STEP: Final = 0.02
"""Metres between two checked points of a path, less than the margin of a plan (``journey.MARGIN``)."""
STRIDE: Final = 2
"""Cells of the field from one node to the next, for a quarter of the nodes."""
END: Final = -1
"""Stands for the goal among the nodes."""
TINY: Final = 1e-9
"""Metres, or cost: what is less is rounding."""


@dataclass(frozen=True)
class Clearances:
    """How far the path must stay away from things: ``needed``, but less near a start that is closer."""

    field: DistanceField
    needed: float
    start: FloorPose

    def required(self, points: FloatArray) -> FloatArray:
        """Return the clearance required at each point, shape (n,)."""
        here = self.field.at_point(self.start.x, self.start.y)
        everywhere = np.full(len(points), self.needed)
        if here >= self.needed:
            return everywhere
        close = np.hypot(points[:, 0] - self.start.x, points[:, 1] - self.start.y) < ESCAPE
        return np.where(close, min(self.needed, max(LEAST, here - 0.01)), everywhere)

    def spare(self, points: FloatArray) -> float:
        """Return by how much the tightest of the points clears what is required (m); negative: it doesn't."""
        return float((self.field.at(points) - self.required(points)).min())

    def spare_between(self, a: tuple[float, float], b: tuple[float, float]) -> float:
        """Return the spare clearance of the straight line."""
        count = max(2, math.ceil(math.dist(a, b) / CHECK_STEP) + 1)
        return self.spare(np.linspace(a, b, count))


class Planner:
    """One search for a way; iterate over ``slices`` to its end, then read ``path`` or ``problem``.

    Args:
        mapped: clearance to what is mapped, and what is required.
        obstacles: points, shape (n, 2), of what is not mapped.
        goal: where to go.
    """

    def __init__(self, mapped: Clearances, obstacles: FloatArray, goal: FloorPose) -> None:
        self._obstacles, self._goal = obstacles, goal
        self.clearances = mapped
        """What the plan keeps to; once ``slices`` has begun, with the obstacles."""
        self.path: Path | None = None
        self.problem = ""
        self.expanded = 0

    def slices(self) -> Iterator[None]:
        """Search on."""
        field = yield from with_obstacles(self.clearances.field, self._obstacles)
        self.clearances = replace(self.clearances, field=field)
        start = (self.clearances.start.x, self.clearances.start.y)
        goal = (self._goal.x, self._goal.y)
        if self.clearances.spare(np.array([goal])) < -SLACK:
            self.problem = "the goal is too close to something"
            return
        if math.dist(start, goal) < TINY:
            self.path = Path(np.array([start, goal]))
            return
        if self.clearances.spare_between(start, goal) >= COMFORT:
            self.path = Path(np.array([start, goal]))
            return
        nodes: list[tuple[float, float]] = []
        yield from self._search(start, goal, nodes)
        if not nodes:
            self.problem = self.problem or "no way leads there"
            return
        yield from self._pull(nodes)

    def _search(
        self, start: tuple[float, float], goal: tuple[float, float], found: list[tuple[float, float]]
    ) -> Iterator[None]:
        grid = yield from _Grid.of(self.clearances)
        starts = grid.around(start, self.clearances)
        yield
        goals = grid.around(goal, self.clearances)
        yield
        if not starts or not goals:
            self.problem = "there is no room to move at the " + ("start" if not starts else "goal")
            return
        best: dict[int, float] = dict(starts)
        came: dict[int, int] = {}
        closed: set[int] = set()
        queue = [(length + grid.distance(node, goal), node) for node, length in starts.items()]
        heapq.heapify(queue)
        while queue:
            _, node = heapq.heappop(queue)
            if node == END:
                break
            if node in closed:
                continue
            closed.add(node)
            self.expanded += 1
            if self.expanded % EXPANSIONS == 0:
                yield
            for other, length in grid.steps(node, goals):
                reached = best[node] + length
                if reached < best.get(other, math.inf) - TINY:
                    best[other] = reached
                    came[other] = node
                    rest = 0.0 if other == END else grid.distance(other, goal)
                    heapq.heappush(queue, (reached + rest, other))
        if END in came:
            found.extend(_traced(came, grid, start, goal))

    def _pull(self, nodes: list[tuple[float, float]]) -> Iterator[None]:
        """Replace what lies between two nodes by a straight line wherever that is free and costs no more."""
        corners = np.array(nodes)
        middles = self.clearances.field.at((corners[1:] + corners[:-1]) / 2) - self.clearances.needed
        lengths = np.hypot(*np.diff(corners, axis=0).T)
        costs = np.concatenate(([0.0], np.cumsum(lengths * _price(middles)))).tolist()
        yield
        kept, at, tried = [nodes[0]], 0, 0
        while at < len(nodes) - 1:
            after = at + 1
            for other in range(len(nodes) - 1, at + 1, -1):
                tried += 1
                if tried % PULLS == 0:
                    yield
                if self._free_and_cheap(nodes[at], nodes[other], costs[other] - costs[at]):
                    after = other
                    break
            at = after
            kept.append(nodes[at])
        path = Path(np.array(_without_repeats(self._without_hooks(kept))))
        if self.clearances.spare(path.sampled(0.0, path.length, CHECK_STEP)[1]) < -SLACK:
            self.problem = "the path found fails its check"
            return
        self.path = path

    def _without_hooks(self, points: list[tuple[float, float]]) -> list[tuple[float, float]]:
        """Leave out a last corner close to the goal, where that is free, so as to arrive straight."""
        kept = list(points)
        while (
            len(kept) > 2  # noqa: PLR2004 - start, corner, goal
            and math.dist(kept[-2], kept[-1]) < RUN_UP
            and self.clearances.spare_between(kept[-3], kept[-1]) >= -SLACK / 2
        ):
            del kept[-2]
        return kept

    def _cost(self, a: tuple[float, float], b: tuple[float, float]) -> float:
        count = max(2, math.ceil(math.dist(a, b) / (2 * CHECK_STEP)) + 1)
        spare = self.clearances.field.at(np.linspace(a, b, count)) - self.clearances.needed
        return math.dist(a, b) * float(_price(spare).mean())

    def _free_and_cheap(self, a: tuple[float, float], b: tuple[float, float], cost: float) -> bool:
        if math.dist(a, b) > cost * 1.02 + TINY:
            return False
        return self.clearances.spare_between(a, b) >= -SLACK / 2 and self._cost(a, b) <= cost * 1.02 + TINY


@dataclass(frozen=True)
class _Grid:
    """The floor's nodes as flat indices of the field, with what may be stood on and at what price."""

    field: DistanceField
    free: list[bool]
    price: list[float]
    columns: int
    step: float
    moves: tuple[tuple[int, float], ...]

    @classmethod
    def of(cls, clear: Clearances) -> Generator[None, None, _Grid]:
        field = clear.field
        rows, columns = field.values.shape
        x, y = field.x0 + field.step * np.arange(columns), field.y0 + field.step * np.arange(rows)
        points = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
        values = field.values.reshape(-1)
        free = (values >= clear.required(points)).reshape(rows, columns)
        free[: STRIDE + 1], free[-STRIDE - 1 :] = False, False
        free[:, : STRIDE + 1], free[:, -STRIDE - 1 :] = False, False
        free_list: list[bool] = free.reshape(-1).tolist()
        yield
        step = STRIDE * field.step
        moves = tuple(
            (row * columns + column, math.hypot(row, column) * step)
            for row in (-1, 0, 1)
            for column in (-1, 0, 1)
            if row or column
        )
        price: list[float] = _price(values - clear.needed).tolist()
        yield
        return cls(field, free_list, price, columns, step, moves)

    def point(self, node: int) -> tuple[float, float]:
        row, column = divmod(node, self.columns)
        return (self.field.x0 + self.field.step * column, self.field.y0 + self.field.step * row)

    def distance(self, node: int, goal: tuple[float, float]) -> float:
        return math.dist(self.point(node), goal)

    def steps(self, node: int, goals: dict[int, float]) -> list[tuple[int, float]]:
        """Return the neighbours that can be stepped on, with the price of the step."""
        found = [(END, goals[node])] if node in goals else []
        for move, length in self.moves:
            other = node + STRIDE * move
            if self.free[other] and self.free[node + move]:
                found.append((other, length * self.price[node + move]))
        return found

    def around(self, point: tuple[float, float], clear: Clearances) -> dict[int, float]:
        """Return the free nodes near a point that a straight line reaches, with their distances."""
        column = round((point[0] - self.field.x0) / self.step) * STRIDE
        row = round((point[1] - self.field.y0) / self.step) * STRIDE
        found = {}
        for down in (-1, 0, 1):
            for right in (-1, 0, 1):
                node = (row + STRIDE * down) * self.columns + column + STRIDE * right
                if not (0 <= node < len(self.free) and self.free[node]):
                    continue
                if clear.spare_between(point, self.point(node)) >= -SLACK:
                    found[node] = math.dist(point, self.point(node))
        return found


def _traced(
    came: dict[int, int], grid: _Grid, start: tuple[float, float], goal: tuple[float, float]
) -> list[tuple[float, float]]:
    """Return the points from start to goal."""
    back, node = [goal], END
    while node in came:
        node = came[node]
        back.append(grid.point(node))
    return [start, *reversed(back)]


def _price(spare: FloatArray) -> FloatArray:
    """Return what a metre costs at these clearances beyond what is needed."""
    return np.asarray(1.0 + CROWDED * np.clip(1.0 - spare / COMFORT, 0.0, 1.0) ** 2)


def _without_repeats(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    kept = [points[0]]
    for point in points[1:-1]:
        if math.dist(kept[-1], point) > 0.01 and math.dist(point, points[-1]) > 0.01:  # noqa: PLR2004 - 1 cm
            kept.append(point)
    return [*kept, points[-1]]
