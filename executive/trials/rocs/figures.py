"""A run as SVG: the paths from above, coloured by route, and x and y over time (RoCS paper, Fig. 5 and 7)."""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import Final

from tandem.executive.trials.rocs.run import Point, RocsRun

WIDTH, HEIGHT, EDGE = 980, 520, 44
"""Pixels; ``EDGE`` about each of the three plots."""
ROOM: Final = 2.5
"""Metres from the middle to a wall."""
PLAN: Final = HEIGHT - 2 * EDGE
COLOURS: Final = {False: "#c0392b", True: "#2b6cb0"}
"""Red on the deliberative route, blue on the reactive one: as in the paper."""
OTHER: Final = "#222"
Pixel = tuple[float, float]


def figure(run: RocsRun, title: str) -> str:
    """Return an SVG document of one run."""
    parts = [
        (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}"'
            f' viewBox="0 0 {WIDTH} {HEIGHT}" font-family="Helvetica, Arial, sans-serif" font-size="12">'
        ),
        f"<title>{html.escape(title)}</title>",
        '<rect width="100%" height="100%" fill="white"/>',
        f'<text x="{EDGE}" y="24" font-size="14">{html.escape(title)}</text>',
        *_legend(),
        f'<rect x="{EDGE}" y="{EDGE}" width="{PLAN}" height="{PLAN}" fill="none" stroke="#888"/>',
        *(_box(*box) for box in run.boxes),
        '<circle cx="{:.1f}" cy="{:.1f}" r="5" fill="none" stroke="#2e7d32"/>'.format(*_plan(0.0, 0.0)),
        *(part for name, path in run.paths.items() for part in _path(name, path, _on_plan)),
    ]
    for row, (axis, of) in enumerate((("x", lambda p: p.x), ("y", lambda p: p.y))):
        parts += _over_time(run, axis, of, row)
    return "\n".join((*parts, "</svg>\n"))


def _plan(x: float, y: float) -> Pixel:
    return EDGE + (x + ROOM) / (2 * ROOM) * PLAN, EDGE + (ROOM - y) / (2 * ROOM) * PLAN


def _on_plan(point: Point) -> Pixel:
    return _plan(point.x, point.y)


def _box(x: float, y: float, yaw: float, along: float, across: float) -> str:
    c, s = math.cos(yaw), math.sin(yaw)
    corners = [
        _plan(x + c * u - s * v, y + s * u + c * v)
        for u, v in (
            (along / 2, across / 2),
            (-along / 2, across / 2),
            (-along / 2, -across / 2),
            (along / 2, -across / 2),
        )
    ]
    points = " ".join(f"{u:.1f},{v:.1f}" for u, v in corners)
    return f'<polygon points="{points}" fill="#d9c6a5" stroke="#8a7348"/>'


def _path(name: str, path: Sequence[Point], at: Callable[[Point], Pixel]) -> Iterator[str]:
    scripted = name == "r1"
    begins = [k for k in range(1, len(path)) if path[k].reactive != path[k - 1].reactive]
    for begin, end in pairwise((0, *begins, len(path))):
        colour = OTHER if scripted else COLOURS[path[begin].reactive]
        points = " ".join(f"{u:.1f},{v:.1f}" for u, v in map(at, path[max(begin - 1, 0) : end]))
        width = 0.8 if scripted else 1.6
        yield f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width}"/>'
    for begin in begins:
        u, v = at(path[begin])
        colour = COLOURS[path[begin].reactive]
        yield f'<rect x="{u - 3:.1f}" y="{v - 3:.1f}" width="6" height="6" fill="{colour}"/>'
    if path:
        u, v = at(path[0])
        yield f'<text x="{u + 6:.1f}" y="{v - 6:.1f}" fill="#444">{name}</text>'


def _over_time(run: RocsRun, axis: str, of: Callable[[Point], float], row: int) -> Iterator[str]:
    left, width = 2 * EDGE + PLAN + 10, WIDTH - 3 * EDGE - PLAN - 10
    height = (HEIGHT - 3 * EDGE) / 2
    top = EDGE + row * (height + EDGE)
    longest = max((path[-1].at for path in run.paths.values() if path), default=1.0)
    first = min((path[0].at for path in run.paths.values() if path), default=0.0)
    span = max(longest - first, 1e-6)

    def at(point: Point) -> Pixel:
        return (
            left + (point.at - first) / span * width,
            top + (ROOM - of(point)) / (2 * ROOM) * height,
        )

    yield f'<rect x="{left}" y="{top:.1f}" width="{width}" height="{height:.1f}" fill="none" stroke="#888"/>'
    yield f'<text x="{left - 8}" y="{top + height / 2:.1f}" text-anchor="end">{axis} (m)</text>'
    yield f'<text x="{left + width}" y="{top + height + 16:.1f}" text-anchor="end">{span:.0f} s</text>'
    for name, path in run.paths.items():
        yield from _path(name, path, at)


def _legend() -> Iterator[str]:
    words = (("deliberative", COLOURS[False]), ("reactive", COLOURS[True]), ("r1, scripted", OTHER))
    for number, (word, colour) in enumerate(words):
        u = EDGE + 130 * number
        yield f'<rect x="{u}" y="{HEIGHT - 24}" width="14" height="4" fill="{colour}"/>'
        yield f'<text x="{u + 20}" y="{HEIGHT - 18}">{word}</text>'
