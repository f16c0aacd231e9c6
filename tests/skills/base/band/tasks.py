"""Tasks for a band: two metres along x, among people and things."""

from __future__ import annotations

from collections.abc import Generator
from typing import TypeVar

import numpy as np

from tandem.sim.robots.locobot import DRIVE
from tandem.skills.base.band.limits import Begin, Surroundings, Task
from tandem.skills.base.field import DistanceField
from tandem.skills.base.people.forecast import forecast
from tandem.skills.base.people.person_track import Track
from tandem.skills.base.planner import Clearances
from tandem.skills.ports.pose import FloorPose
from tests.skills.base.people.test_keeping_away import OPEN

R = TypeVar("R")
WAY = np.linspace([0.0, 0.0], [2.0, 0.0], 21)
NEEDED = 0.25
APART = 0.52


def task(
    *people: Track, field: DistanceField = OPEN, linear: float = 0.5, stops: bool = False, y: float = 0.0
) -> Task:
    """Go from the origin (or beside it) to x = 2 m."""
    begin = Begin(FloorPose(x=0.0, y=y, yaw=0.0), linear, 0.0)
    clearances = Clearances(field, NEEDED, begin.pose)
    around = Surroundings(clearances, forecast(people, OPEN), 0.0, APART)
    return Task(begin, (2.0, 0.0, 0.0), stops, DRIVE, around)


def post(x: float, y: float) -> DistanceField:
    """Return the floor with a thin post on it."""
    at = np.linspace(-3.0, 3.0, 121)
    return DistanceField(-3.0, -3.0, 0.05, np.hypot(at[None, :] - x, at[:, None] - y))


def done(run: Generator[None, None, R]) -> R:
    """Do all slices."""
    while True:
        try:
            next(run)
        except StopIteration as stop:
            result: R = stop.value
            return result
