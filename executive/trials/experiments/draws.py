"""Draws a run: where things stand, where they are moved to, and when."""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from tandem.executive.trials.experiments.settings import (
    AROUND,
    FARTHEST,
    LEAST,
    POSITIONS,
    REGIONS,
    Kind,
    Region,
    Series,
)
from tandem.sim.scenario import Scenario, load_scenario
from tandem.skills.ports.message import Message

MOST_DRAWS: Final = 200
"""After which nothing is taken to fit."""
APART: Final = 0.14
"""Metres between the centres of two cubes: room for the fingers of both."""
DELAY: Final = {"field": (0.1, 0.9), "grasp": (0.03, 0.25)}
"""Robot seconds after a phase's begin at which a thing is moved in it."""


class NoPlaceError(ValueError):
    """There is no place for a thing; the message says which, and where it was looked for."""


class Spot(Message):
    """A place on the table: centre in the map (m), and heading (rad)."""

    x: float
    y: float
    yaw: float


class Step(Message):
    """An item's start, where somebody puts it, and how long after the phase's begin."""

    item: int
    start: Spot
    to: tuple[Spot, ...]
    """In the order in which they are tried: an arm may be in the way of the first."""
    delay: float


class Draw(Message):
    """One run."""

    position: int
    """1 to 3 in the uncoordinated experiment, else 1."""
    steps: tuple[Step, ...]


def scenario_of(kind: Kind, draw: Draw) -> Scenario:
    """Return the experiment's scenario with the items where they were drawn."""
    scenario = load_scenario("TwoArmsBox" if kind == "coordinated" else "TwoArms")
    for step in draw.steps:
        at = step.start
        item = scenario.item(step.item).model_copy(update={"x": at.x, "y": at.y, "yaw": at.yaw})
        scenario = scenario.with_item(item)
    return scenario


def draw_run(kind: Kind, series: Series, run: int, rng: np.random.Generator) -> Draw:
    """Draw run number ``run``; the uncoordinated one goes through its three positions in turn.

    Starts from which no place is far enough are drawn again.
    """
    for _ in range(MOST_DRAWS):
        try:
            return _draw(kind, series, run, rng)
        except NoPlaceError:
            continue
    raise NoPlaceError(f"{kind}: no start was found from which each thing can be moved by {LEAST} m")


def _draw(kind: Kind, series: Series, run: int, rng: np.random.Generator) -> Draw:
    position = run % len(POSITIONS) if kind == "uncoordinated" else 0
    starts: list[Spot] = []
    for number, region in enumerate(REGIONS[kind]):
        if kind == "uncoordinated":
            x, y = POSITIONS[position][number]
            starts.append(_near(x, y, region, rng))
        else:
            starts.append(_within(region, rng, starts))
    steps: list[Step] = []
    for number, (region, start) in enumerate(zip(REGIONS[kind], starts, strict=True)):
        others = [*starts[:number], *starts[number + 1 :], *(step.to[0] for step in steps)]
        to = tuple(_moved(region, start, rng, others) for _ in range(6))
        steps.append(Step(item=region.item, start=start, to=to, delay=float(rng.uniform(*DELAY[series]))))
    return Draw(position=position + 1, steps=tuple(steps))


def _near(x: float, y: float, region: Region, rng: np.random.Generator) -> Spot:
    dx, dy = (float(rng.uniform(-AROUND, AROUND)) for _ in range(2))
    return Spot(x=x + dx, y=y + dy, yaw=_yaw(region, rng))


def _within(region: Region, rng: np.random.Generator, others: list[Spot]) -> Spot:
    for _ in range(MOST_DRAWS):
        spot = Spot(x=float(rng.uniform(*region.x)), y=float(rng.uniform(*region.y)), yaw=_yaw(region, rng))
        if all(math.hypot(spot.x - each.x, spot.y - each.y) >= APART for each in others):
            return spot
    raise NoPlaceError(f"no room for item {region.item} beside {others}")


def _moved(region: Region, start: Spot, rng: np.random.Generator, others: list[Spot]) -> Spot:
    for _ in range(MOST_DRAWS):
        spot = _within(region, rng, others)
        if LEAST <= math.hypot(spot.x - start.x, spot.y - start.y) <= FARTHEST:
            return spot
    raise NoPlaceError(f"no place for item {region.item} at least {LEAST} m from {start}")


def _yaw(region: Region, rng: np.random.Generator) -> float:
    return math.remainder(math.pi + float(rng.uniform(-region.turn, region.turn)), 2.0 * math.pi)
