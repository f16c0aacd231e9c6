"""Two figures of the order-picking paper as SVG, from above: the search (Fig. 2), the new try (Fig. 4)."""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Iterator, Sequence
from typing import Final

from tandem.executive.trials.picking.phases import is_turn, point_at
from tandem.executive.trials.picking.settings import Phase, PickingRun, Point, Stretch
from tandem.skills.ports.site import Site, SiteBox

PLAN: Final = 440
"""Pixels of the room's longer edge."""
EDGE: Final = 30
"""Pixels about it."""
SIDE: Final = 250
"""Pixels beside it, for words."""
ROW: Final = 19
"""Pixels from line to line of them."""
SIGHT: Final = 0.34
"""Metres to which a look is drawn, ahead of the robot's middle."""
FIELD: Final = math.radians(69.0)
"""What one look spans: the field of the LoCoBot's camera (``sim/robots/locobot.py``)."""
LEVEL: Final = 0.6
"""Metres: what reaches higher and nowhere lower is not drawn: a shelf's top would hide its board."""
SEARCHING, APPROACHING, FAILING, BACK = "#2b6cb0", "#2e7d32", "#c0392b", "#777"
HOME_DRIVES: Final = "get: home: drive"
"""The leaf of the recovery that goes home before it searches again (``trees/subtrees/get_item.py``)."""
Pixel = tuple[float, float]
Row = tuple[str, str]
"""A colour, and what is drawn in it."""


def search_figure(run: PickingRun, site: Site) -> str | None:
    """Return Fig. 2: where the robot looked and turned until it saw the item; None: it saw it at once."""
    looks = [each for each in run.stretches if each.phase is Phase.SEARCH and each.node.startswith("look")]
    if not any(is_turn(each) for each in run.stretches):
        return None
    found = next((each.end for each in looks if each.ended_well), run.lasted)
    at = _pixels(site)
    seen = [each for each in looks if each.begin <= found]
    body = [
        *_room(site, run, at),
        _line(_between(run.path, 0.0, found), at, SEARCHING),
        *(part for look in seen for part in _look(point_at(run.path, look.begin), at, good=look.ended_well)),
        _dot(at(run.path[0].x, run.path[0].y), SEARCHING, "start"),
    ]
    turns = sum(is_turn(each) and each.begin <= found for each in run.stretches)
    spots = sum(each.node == "drive to spot" and each.begin <= found for each in run.stretches)
    rows: list[Row] = [
        ("", f"item {run.item}, seen after {found:.1f} s"),
        (SEARCHING, f"{len(seen)} looks, {turns} turns of 30 degrees"),
        (SEARCHING, f"{spots} drives to a spot"),
        (APPROACHING, "the look that showed the item"),
    ]
    return _document(f"Fig. 2: search, run {run.run}", body, rows, site)


def repositioning_figure(run: PickingRun, site: Site) -> str | None:
    """Return Fig. 4: where the arm failed, home, and where it did not; None: nobody went home for that."""
    homes = [each for each in run.stretches if each.node == HOME_DRIVES]
    if not homes:
        return None
    first, last = homes[0], homes[-1]
    again = next((each for each in run.stretches if each.begin > last.end and _closed(each)), None)
    until = run.lasted if again is None else again.end
    failed = _failed(run, first.begin)
    at = _pixels(site)
    body = [
        *_room(site, run, at),
        _line(_between(run.path, 0.0, first.begin), at, FAILING),
        _line(_between(run.path, first.begin, last.end), at, BACK, dashed=True),
        _line(_between(run.path, last.end, until), at, APPROACHING),
        _dot(at(run.path[0].x, run.path[0].y), FAILING, "start"),
        _dot(_on(point_at(run.path, last.end), at), BACK, "home"),
        *(_cross(_on(point_at(run.path, each.end), at)) for each in failed),
    ]
    rows: list[Row] = [
        ("", f"item {run.item}"),
        (FAILING, f"to where the arm failed, {len(failed)} times"),
        (BACK, f"home, {first.begin:.1f} to {last.end:.1f} s"),
    ]
    if again is None:
        rows.append((APPROACHING, "the second search"))
    else:
        body.append(_dot(_on(point_at(run.path, again.end), at), APPROACHING, "picked"))
        rows.append((APPROACHING, f"search again, picked at {again.end:.1f} s"))
    return _document(f"Fig. 4: new try, run {run.run}", body, rows, site)


def _closed(each: Stretch) -> bool:
    return each.node == "close" and each.ended_well


def _failed(run: PickingRun, until: float) -> list[Stretch]:
    return [
        each
        for each in run.stretches
        if each.end <= until and not each.ended_well and each.phase is Phase.PICK
    ]


def _pixels(site: Site) -> Callable[[float, float], Pixel]:
    left, low, right, high = site.bounds
    scale = PLAN / max(right - left, high - low)
    return lambda x, y: (EDGE + (x - left) * scale, EDGE + (high - y) * scale)


def _on(point: Point, at: Callable[[float, float], Pixel]) -> Pixel:
    return at(point.x, point.y)


def _between(path: Sequence[Point], begin: float, end: float) -> list[Point]:
    """Return the part of a path, without points at which it stood."""
    kept: list[Point] = []
    for point in path:
        if begin <= point.at <= end and (
            not kept or math.dist((point.x, point.y), (kept[-1].x, kept[-1].y)) > 0.01  # noqa: PLR2004 - 1 cm is 1 pixel
        ):
            kept.append(point)
    return kept


def _room(site: Site, run: PickingRun, at: Callable[[float, float], Pixel]) -> Iterator[str]:
    left, low, right, high = site.bounds
    (u, v), (u_end, v_end) = at(left, high), at(right, low)
    for piece in site.furniture:
        for box in piece.boxes:
            if box.centre[2] - box.size[2] / 2 < LEVEL:
                yield _box(box, at)
    yield (
        f'<rect x="{u:.0f}" y="{v:.0f}" width="{u_end - u:.0f}" height="{v_end - v:.0f}"'
        ' fill="none" stroke="#888"/>'
    )
    for spot in site.spots:
        u, v = at(spot.pose.x, spot.pose.y)
        yield f'<circle cx="{u:.1f}" cy="{v:.1f}" r="4" fill="none" stroke="#999"/>'
        yield f'<text x="{u + 6:.1f}" y="{v + 12:.1f}" fill="#999">{html.escape(spot.name)}</text>'
    u, v = at(run.place.x, run.place.y)
    yield f'<rect x="{u - 4:.1f}" y="{v - 4:.1f}" width="8" height="8" fill="#e0a800" stroke="#7a5c00"/>'
    yield f'<text x="{u - 22:.1f}" y="{v + 4:.1f}">{run.item}</text>'


def _box(box: SiteBox, at: Callable[[float, float], Pixel]) -> str:
    c, s = math.cos(box.yaw), math.sin(box.yaw)
    half, other = box.size[0] / 2, box.size[1] / 2
    corners = (
        at(box.centre[0] + c * a - s * b, box.centre[1] + s * a + c * b)
        for a, b in ((half, other), (-half, other), (-half, -other), (half, -other))
    )
    points = " ".join(f"{u:.1f},{v:.1f}" for u, v in corners)
    return f'<polygon points="{points}" fill="#e6ddcc" stroke="#a08a63" stroke-width="0.8"/>'


def _line(
    points: Sequence[Point], at: Callable[[float, float], Pixel], colour: str, *, dashed: bool = False
) -> str:
    drawn = " ".join(f"{u:.1f},{v:.1f}" for u, v in (_on(point, at) for point in points))
    dashes = ' stroke-dasharray="5 4"' if dashed else ""
    return f'<polyline points="{drawn}" fill="none" stroke="{colour}" stroke-width="1.8"{dashes}/>'


def _look(point: Point, at: Callable[[float, float], Pixel], *, good: bool) -> Iterator[str]:
    """Draw what the camera spans from where the robot stands."""
    ends = [
        at(point.x + SIGHT * math.cos(point.yaw + turn), point.y + SIGHT * math.sin(point.yaw + turn))
        for turn in (-FIELD / 2, -FIELD / 4, 0.0, FIELD / 4, FIELD / 2)
    ]
    corners = " ".join(f"{u:.1f},{v:.1f}" for u, v in (_on(point, at), *ends))
    colour, depth = (APPROACHING, 0.55) if good else (SEARCHING, 0.10)
    yield (
        f'<polygon points="{corners}" fill="{colour}" fill-opacity="{depth}" stroke="{colour}"'
        ' stroke-width="0.6"/>'
    )


def _dot(place: Pixel, colour: str, word: str) -> str:
    u, v = place
    return (
        f'<circle cx="{u:.1f}" cy="{v:.1f}" r="5" fill="{colour}"/>'
        f'<text x="{u + 8:.1f}" y="{v - 6:.1f}" fill="{colour}">{word}</text>'
    )


def _cross(place: Pixel) -> str:
    u, v = place
    return (
        f'<path d="M{u - 7:.1f} {v - 7:.1f}L{u + 7:.1f} {v + 7:.1f}M{u - 7:.1f} {v + 7:.1f}'
        f'L{u + 7:.1f} {v - 7:.1f}" stroke="{FAILING}" stroke-width="2.4"/>'
    )


def _document(title: str, body: Sequence[str], rows: Sequence[Row], site: Site) -> str:
    left, low, right, high = site.bounds
    longer = max(right - left, high - low)
    wide = PLAN * (right - left) / longer + 2 * EDGE
    tall = PLAN * (high - low) / longer + 2 * EDGE
    words = [f'<text x="{wide:.0f}" y="{EDGE + 12}" font-size="13">{html.escape(title)}</text>']
    for number, (colour, text) in enumerate(rows, start=1):
        v = EDGE + 14 + number * ROW
        if colour:
            words.append(f'<rect x="{wide:.0f}" y="{v - 6}" width="14" height="4" fill="{colour}"/>')
        words.append(f'<text x="{wide + 20:.0f}" y="{v}">{html.escape(text)}</text>')
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide + SIDE:.0f}" height="{tall:.0f}"'
        f' viewBox="0 0 {wide + SIDE:.0f} {tall:.0f}" font-family="Helvetica, Arial, sans-serif"'
        ' font-size="12">'
    )
    ground = '<rect width="100%" height="100%" fill="white"/>'
    return "\n".join((head, f"<title>{html.escape(title)}</title>", ground, *body, *words, "</svg>\n"))
