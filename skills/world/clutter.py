"""The clutter that is believed in: boxes that come with looks, and go with looks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import product
from typing import Final

from tandem.skills.geometry.poses import invert, transform
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.world import Box

_SLACK: Final = 0.02
"""Metres: a box that sticks out of another by less than this says nothing new."""
ITEM_MARGIN: Final = 0.03
"""Metres about an item in which the middle of a box of clutter is the item itself."""


def contains(box: Box, point: Vector3, slack: float = 0.0) -> bool:
    """Say whether a point of the map lies in the box, grown by ``slack`` metres on each side."""
    local = transform(invert(box.pose), point)
    return all(abs(x) <= edge / 2.0 + slack for x, edge in zip(local, box.size, strict=True))


def covers(outer: Box, inner: Box, slack: float = _SLACK) -> bool:
    """Say whether all corners of ``inner`` lie in ``outer``, grown by ``slack`` metres."""
    x, y, z = inner.size
    return all(
        contains(outer, transform(inner.pose, (sx * x / 2, sy * y / 2, sz * z / 2)), slack)
        for sx, sy, sz in product((-1, 1), repeat=3)
    )


def after_look(
    believed: Sequence[tuple[str, Box]], view: Iterable[Box], measured: Iterable[tuple[str, Box]]
) -> tuple[tuple[str, Box], ...]:
    """Return the named boxes believed in after a look.

    What was believed in the view is forgotten; what was measured is added, unless something that is still
    believed covers it, and takes the place of what it covers itself.
    """
    seen_through = tuple(view)
    kept = [
        (name, box)
        for name, box in believed
        if not any(contains(region, box.pose.position) for region in seen_through)
    ]
    for name, box in measured:
        if any(covers(other, box) for _, other in kept):
            continue
        kept = [(other_name, other) for other_name, other in kept if not covers(box, other)]
        kept.append((name, box))
    return tuple(kept)


def without_item(believed: Sequence[tuple[str, Box]], item: Box) -> tuple[tuple[str, Box], ...]:
    """Return what is left once an item is recognised: boxes in its place were the item, unrecognised."""
    return tuple((name, box) for name, box in believed if not contains(item, box.pose.position, ITEM_MARGIN))
