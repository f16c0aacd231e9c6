"""Whether what a request asks for is so, by the simulation's truth and not by what a robot believes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from pydantic import JsonValue

from tandem.sim.truth import Truth, lies_on
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import Site

NEAR: Final = 0.15
"""Metres from a place that count as there."""


@dataclass(frozen=True)
class Judged:
    """What is so, in words and for a report."""

    good: bool
    words: str
    notes: Mapping[str, JsonValue] = field(default_factory=dict)


def judged(request: Mapping[str, JsonValue], truth: Truth, site: Site, robot: str) -> Judged:
    """Return whether an item lies where it was to be brought, or a robot stands where it was to go.

    Args:
        request: what was asked for.
        truth: how things are at its end.
        site: where depots are.
        robot: the name of the robot that was asked; empty for the only one.
    """
    said, depot = request.get("item"), request.get("to")
    item = site.meant(said) if isinstance(said, str | int) else None
    if said is not None and item is None:
        return Judged(False, f"the site has no item {said}")
    if item is not None and isinstance(depot, str):
        there = lies_on(truth, site, item.item, depot)
        words = f"item {item.words} {'is' if there else 'is not'} in {depot}"
        return Judged(there, words, {"item": item.item, "in_depot": there})
    place = _last_place(request)
    if place is None:
        return Judged(True, "nothing that the simulation can judge was asked for")
    base = truth.robot(robot).base_in_map if robot else truth.base_in_map
    off = _off(base, place)
    who = robot or "the robot"
    return Judged(off <= NEAR, f"{who} is {off:.3f} m from where it was to go", {"off_goal": round(off, 3)})


def _last_place(request: Mapping[str, JsonValue]) -> tuple[float, float] | None:
    corners = request.get("corners")
    last = corners[-1] if isinstance(corners, list) and corners else request
    x, y = (last.get("x"), last.get("y")) if isinstance(last, Mapping) else (None, None)
    return (float(x), float(y)) if isinstance(x, int | float) and isinstance(y, int | float) else None


def _off(base: Pose, place: tuple[float, float]) -> float:
    return math.hypot(base.position[0] - place[0], base.position[1] - place[1])
