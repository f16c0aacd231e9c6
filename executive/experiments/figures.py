"""The hands' paths as SVG, written by hand: from above and in space (document 002, fig. 5.3 to 5.13)."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Final

from executive.experiments.run import ExperimentRun
from skills.ports.message import Vector3

SIZE: Final = (640, 480)
SCALE: Final = 420.0
"""Pixels a metre."""
COLOURS: Final = {"left": "#2b6cb0", "right": "#c0392b"}
TOP: Final = 0.71
TABLE: Final = ((0.44, -0.62, TOP), (1.34, -0.62, TOP), (1.34, 0.62, TOP), (0.44, 0.62, TOP))
"""The corners of the table's top in the map (m)."""
Flat = Callable[[Vector3], tuple[float, float]]


def from_above(point: Vector3) -> tuple[float, float]:
    """Return the pixel of a point seen from above: x up, y to the left, as the robot sees it."""
    x, y, _ = point
    return SIZE[0] / 2 - SCALE * y, SIZE[1] - 40 - SCALE * (x - 0.05) * 0.95


def in_space(point: Vector3) -> tuple[float, float]:
    """Return the pixel of a point seen from behind the robot, from its right and from above."""
    x, y, z = point
    turn, lean = math.radians(25.0), math.radians(30.0)
    across = -y * math.cos(turn) + x * math.sin(turn)
    ahead = x * math.cos(turn) + y * math.sin(turn)
    up = z * math.cos(lean) + ahead * math.sin(lean)
    return SIZE[0] / 2 - 60 + 0.9 * SCALE * across, SIZE[1] + 210 - 0.9 * SCALE * up


def figure(title: str, runs: Iterable[ExperimentRun], flat: Flat) -> str:
    """Return an SVG document with the paths of both hands in all runs, and where the things were moved to."""
    width, height = SIZE
    parts = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"'
            f' viewBox="0 0 {width} {height}" font-family="Helvetica, Arial, sans-serif" font-size="12">'
        ),
        f"<title>{title}</title>",
        '<rect width="100%" height="100%" fill="white"/>',
        f'<polygon points="{_points(TABLE, flat)}" fill="#efe3d3" stroke="#b08d5e"/>',
        f'<text x="12" y="20">{title}</text>',
    ]
    for run in runs:
        for side, arm in (("left", run.left), ("right", run.right)):
            parts.append(
                f'<polyline points="{_points(arm.path, flat)}" fill="none" stroke="{COLOURS[side]}"'
                ' stroke-width="1.3" stroke-opacity="0.6"/>'
            )
        for moved in run.moved:
            u, v = flat((moved.to.x, moved.to.y, TOP))
            parts.append(f'<circle cx="{u:.1f}" cy="{v:.1f}" r="3" fill="#333"/>')
    return "\n".join((*parts, "</svg>\n"))


def _points(points: Sequence[Vector3], flat: Flat) -> str:
    return " ".join(f"{u:.1f},{v:.1f}" for u, v in map(flat, points))
