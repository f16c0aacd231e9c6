"""The hands' paths as SVG, written by hand: from above and in space.

Two-arm thesis, fig. 5.3 to 5.8, 5.12 and 5.13.
"""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Iterable, Sequence
from typing import Final

from tandem.executive.trials.experiments.run import ExperimentRun
from tandem.skills.ports.message import Vector3

SIZE: Final = (720, 560)
"""Pixels: width and height of a figure."""
MARGIN: Final = (56, 64, 24, 44)
"""Pixels left, above (title and legend), right and below (the axis)."""
TICK: Final = 0.2
"""Metres between two marks of an axis."""
COLOURS: Final = {"left": "#2b6cb0", "right": "#c0392b"}
GREY: Final = "#666"
TOP: Final = 0.71
"""Metres: the height of the table's top in the map."""
TABLE: Final = ((0.44, -0.62, TOP), (1.34, -0.62, TOP), (1.34, 0.62, TOP), (0.44, 0.62, TOP))
"""The corners of the table's top in the map (m)."""
REACH: Final = 0.95
"""Metres ahead to which the table is drawn: no hand gets farther."""
Flat = Callable[[Vector3], tuple[float, float]]
"""Brings a point of the map to the paper: metres to the right and up."""


def from_above(point: Vector3) -> tuple[float, float]:
    """Return a point seen from above: x up, y to the left, as the robot sees it."""
    x, y, _ = point
    return -y, x


def in_space(point: Vector3) -> tuple[float, float]:
    """Return a point seen from behind the robot, from its right and from above."""
    x, y, z = point
    turn, lean = math.radians(25.0), math.radians(30.0)
    across = -y * math.cos(turn) + x * math.sin(turn)
    ahead = x * math.cos(turn) - -y * math.sin(turn)
    return across, z * math.cos(lean) + ahead * math.sin(lean)


def figure(title: str, runs: Iterable[ExperimentRun], flat: Flat) -> str:
    """Return an SVG document with the paths of both hands in all runs, and where the things were moved to."""
    shown = tuple(runs)
    paths = [(side, arm.path) for run in shown for side, arm in (("left", run.left), ("right", run.right))]
    places = [(moved.to.x, moved.to.y, TOP) for run in shown for moved in run.moved]
    table = tuple((min(x, REACH), y, z) for x, y, z in TABLE)
    paper = _Paper(flat, [*table, *places, *(point for _, path in paths for point in path)])
    width, height = SIZE
    parts = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
            f' viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" font-size="12">'
        ),
        f"<title>{html.escape(title)}</title>",
        '<rect width="100%" height="100%" fill="white"/>',
        f'<polygon points="{paper.points(table)}" fill="#efe3d3" stroke="#b08d5e"/>',
        *_axes(paper),
        *(
            f'<polyline points="{paper.points(path)}" fill="none" stroke="{COLOURS[side]}"'
            ' stroke-width="1.3" stroke-opacity="0.6" stroke-linejoin="round"/>'
            for side, path in paths
        ),
        *(
            f'<circle cx="{u:.1f}" cy="{v:.1f}" r="3" fill="#333"/>'
            for u, v in (paper.pixel(place) for place in places)
        ),
        f'<text x="{MARGIN[0]}" y="24" font-size="14">{html.escape(title)}</text>',
        *_legend(),
    ]
    return "\n".join((*parts, "</svg>\n"))


class _Paper:
    """Fits what is drawn into the figure, one scale for both directions."""

    def __init__(self, flat: Flat, points: Sequence[Vector3]) -> None:
        self._flat, self.flat_from_above = flat, flat is from_above
        across, up = zip(*map(flat, points), strict=True)
        left, above, right, below = MARGIN
        room = SIZE[0] - left - right, SIZE[1] - above - below
        self.low, self.high = (min(across), min(up)), (max(across), max(up))
        self._scale = min(space / (b - a) for space, a, b in zip(room, self.low, self.high, strict=True))
        self._corner = (
            left + (room[0] - self._scale * (self.high[0] - self.low[0])) / 2.0,
            SIZE[1] - below - (room[1] - self._scale * (self.high[1] - self.low[1])) / 2.0,
        )

    def pixel(self, point: Vector3) -> tuple[float, float]:
        """Return where a point of the map is drawn."""
        across, up = self._flat(point)
        return (
            self._corner[0] + self._scale * (across - self.low[0]),
            self._corner[1] - self._scale * (up - self.low[1]),
        )

    def points(self, points: Sequence[Vector3]) -> str:
        """Return an SVG list of points."""
        return " ".join(f"{u:.1f},{v:.1f}" for u, v in map(self.pixel, points))


def _axes(paper: _Paper) -> list[str]:
    """Return the axes: x and y along two edges of the table, and, in space, z at a corner; all in metres."""
    near, side = TABLE[0][0], TABLE[0][1]
    marks = _marks(near, REACH)
    if paper.flat_from_above:
        low, high = paper.low, paper.high
        parts = _scale(paper, [(x, -low[0], TOP) for x in _marks(low[1], high[1])], 0, (-8, 4), "end")
        parts += _scale(paper, [(low[1], y, TOP) for y in _marks(-high[0], -low[0])], 1, (0, 18), "middle")
        return [
            *parts,
            _words(paper.pixel((high[1], -low[0], TOP)), (-8, -8), "x (m)", "end"),
            _words(paper.pixel((low[1], 0.0, TOP)), (0, 34), "y (m), the robot's left is left", "middle"),
        ]
    parts = _scale(paper, [(x, side, TOP) for x in marks], 0, (8, 8), "start")
    parts += _scale(paper, [(near, y, TOP) for y in _marks(side, -side)], 1, (-4, 16), "end")
    parts += _scale(paper, [(REACH, -side, z) for z in (TOP, TOP + TICK, TOP + 2 * TICK)], 2, (-8, 4), "end")
    return [
        *parts,
        _words(paper.pixel((REACH, side, TOP)), (-2, -8), "x (m)", "end"),
        _words(paper.pixel((near, -side, TOP)), (-34, 4), "y (m)", "end"),
        _words(paper.pixel((REACH, -side, TOP + 2 * TICK)), (0, -12), "z (m)", "middle"),
    ]


def _marks(low: float, high: float) -> list[float]:
    return [
        round(k * TICK, 3) for k in range(math.ceil(low / TICK - 1e-6), math.floor(high / TICK + 1e-6) + 1)
    ]


def _scale(
    paper: _Paper, points: Sequence[Vector3], axis: int, away: tuple[int, int], anchor: str
) -> list[str]:
    """Return one axis: a line through the points, and at each its number along the axis."""
    line = f'<path d="M{" L".join(paper.points([point]) for point in points)}" stroke="{GREY}" fill="none"/>'
    dots = [paper.pixel(point) for point in points]
    return [
        line,
        *(f'<circle cx="{u:.1f}" cy="{v:.1f}" r="1.5" fill="{GREY}"/>' for u, v in dots),
        *(
            _words(dot, away, f"{point[axis]:.2f}".rstrip("0").rstrip("."), anchor)
            for dot, point in zip(dots, points, strict=True)
        ),
    ]


def _words(at: tuple[float, float], away: tuple[int, int], words: str, anchor: str) -> str:
    u, v = at[0] + away[0], at[1] + away[1]
    return f'<text x="{u:.1f}" y="{v:.1f}" text-anchor="{anchor}" fill="{GREY}">{html.escape(words)}</text>'


def _legend() -> list[str]:
    parts = []
    for number, (side, colour) in enumerate(COLOURS.items()):
        u = MARGIN[0] + 110 * number
        parts.append(f'<line x1="{u}" y1="42" x2="{u + 24}" y2="42" stroke="{colour}" stroke-width="2"/>')
        parts.append(_words((u + 30, 46), (0, 0), f"{side} hand", "start"))
    u = MARGIN[0] + 110 * len(COLOURS)
    parts.append(f'<circle cx="{u + 12}" cy="42" r="3" fill="#333"/>')
    return [*parts, _words((u + 22, 46), (0, 0), "moved to here", "start")]
