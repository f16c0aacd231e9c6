"""Routes, kept from plan to plan: along the way, later, left and right of somebody. The best is driven.

The routes are Rösmann, Hoffmann and Bertram's distinctive topologies (2017), seeded by side instead of by
homology classes: there are one to three people about, and one of them is the nearest.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.band.judge import may_be_driven, price
from tandem.skills.base.band.limits import Task
from tandem.skills.base.band.optimise import optimise
from tandem.skills.base.band.routes import along, beside, carried
from tandem.skills.base.band.timed import Bands, joined
from tandem.skills.base.floor import FloatArray

STEPS: Final = 6
"""Of Gauss-Newton for each plan; bands that are carried on need fewer than new ones."""
FIRST_STEPS: Final = 14
"""Of a plan into which no band is carried on."""
LOYAL: Final = 0.9
"""Times the present route's price another one has to be cheaper: it is not changed for nothing."""
SAME: Final = 0.08
"""Metres, and seconds, within which two routes are one."""


@dataclass(frozen=True)
class Route:
    """One band with its name, as of when it was made (robot s)."""

    name: str
    band: Bands
    made: float
    price: float


class Elastic:
    """Plans, and remembers the routes."""

    def __init__(self) -> None:
        self._kept: dict[str, Route] = {}
        self._last: str | None = None

    @property
    def routes(self) -> tuple[Route, ...]:
        """What may be driven, as of the last plan, the cheapest first."""
        return tuple(sorted(self._kept.values(), key=lambda each: each.price))

    def plan(self, task: Task, points: FloatArray, now: float) -> Generator[None, None, Route | None]:
        """Return the route to take, None where there is none; yields between slices.

        Args:
            task: what to do.
            points: the way, shape (m, 2), from the base to the task's end.
            now: robot seconds.
        """
        if not _finite(task, points):
            return None
        seeds = self._seeds(task, points, now)
        yield
        steps = STEPS if self._kept else FIRST_STEPS
        bands, _ = yield from optimise(joined(list(seeds.values())), task, steps)
        drivable, prices = may_be_driven(bands, task), price(bands, task)
        self._kept = {}
        for number, name in enumerate(seeds):
            route = Route(name, bands.chosen(number), now, float(prices[number]))
            if drivable[number] and not any(_same(route, other) for other in self._kept.values()):
                self._kept[name] = route
        best = self._best()
        self._last = None if best is None else best.name
        return best

    def forget(self) -> None:
        """Begin anew with the next plan."""
        self._kept, self._last = {}, None

    def _seeds(self, task: Task, points: FloatArray, now: float) -> dict[str, Bands]:
        first = along(points, task)
        somebody = len(task.around.people.sigmas) > 0
        fresh = {"along": first}
        if somebody:
            fresh["later"] = along(points, task, slower=2.2)
            fresh["left"], fresh["right"] = (beside(points, first, task, side) for side in (1, -1))
        for name, route in self._kept.items():
            old = route.band.poses[0, -1, :2]
            on = carried(route.band, now - route.made, task.begin, _beyond(points, old), task.drive.forward)
            if on is not None:
                fresh[name] = on
        return fresh

    def _best(self) -> Route | None:
        routes = self.routes
        present = None if self._last is None else self._kept.get(self._last)
        if not routes or present is None:
            return routes[0] if routes else None
        return routes[0] if routes[0].price < LOYAL * present.price else present


def _finite(task: Task, points: FloatArray) -> bool:
    begin, people = task.begin, task.around.people
    numbers = (begin.pose.x, begin.pose.y, begin.pose.yaw, begin.linear, begin.angular, *task.end)
    return bool(np.isfinite(numbers).all() and np.isfinite(points).all() and np.isfinite(people.places).all())


def _beyond(points: FloatArray, end: FloatArray) -> FloatArray:
    """Return the points of a way that lie beyond the end of an old band, which is on it."""
    nearest = int(np.argmin(np.hypot(*(points - end).T)))
    return points[nearest + 1 :]


def _same(one: Route, other: Route) -> bool:
    apart = np.abs(one.band.poses[0, :, :2] - other.band.poses[0, :, :2]).max()
    return bool(apart < SAME and abs(float(one.band.lasts[0] - other.band.lasts[0])) < 2 * SAME)
