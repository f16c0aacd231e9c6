"""Draws a run: where the robots begin, and where the boxes stand that no plan knows."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

import numpy as np

from tandem.executive.trials.rocs.settings import Case
from tandem.sim.scenario import Scenario, load_scenario
from tandem.sim.starts import RobotStart
from tandem.sim.things import Obstacle
from tandem.skills.ports.pose import FloorPose

Place = tuple[float, float]
"""x and y in the map (m)."""
CORNER: Final = (1.75, 2.0)
"""Metres of the start from the middle of the room, along x and y: beside two walls, and able to turn."""
BESIDE: Final = (0.75, 0.95)
"""Metres between the start and the middle of the box beside it."""
AWAY: Final = (1.0, 1.5)
"""Metres of the other box from the goal."""
APART: Final = 1.0
"""Metres between the middles of a robot and anything else at the start."""
ROOM: Final = 1.9
"""Metres from the middle, along x and y, within which R1 begins."""
DISTANCE: Final = 1.3
"""Metres between the two centres at the start of EXP3, and as the SUMMIT-XL is to keep them."""
MOST_DRAWS: Final = 1000
"""After which nothing is taken to fit."""


def draw(case: Case, rng: np.random.Generator) -> Scenario:
    """Return what a run begins with. R2 is the Pioneer, R3 the SUMMIT-XL, R1 the Pioneer with a script."""
    if case == 1:
        return _scenario(case, *_beside_a_box(rng, "r2", "p3dx", inwards=1.0, more=0.0))
    if case == 2:  # noqa: PLR2004 - EXP2: the SUMMIT-XL is nearly twice as wide as the Pioneer
        return _scenario(case, *_beside_a_box(rng, "r3", "summit_xl", inwards=0.88, more=0.25))
    return _scenario(case, _pair(rng), ())


def _beside_a_box(
    rng: np.random.Generator, name: str, robot: str, *, inwards: float, more: float
) -> tuple[tuple[RobotStart, ...], tuple[Obstacle, ...]]:
    """Return a robot in a corner, R1 elsewhere, a box beside the robot and one near the goal.

    Args:
        rng: of all that is drawn.
        name: of the robot.
        robot: its kind.
        inwards: share of ``CORNER`` at which it starts.
        more: metres to be added to ``BESIDE``.
    """
    sides = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
    sx, sy = sides[int(rng.integers(4))]
    start = (inwards * sx * float(rng.uniform(*CORNER)), inwards * sy * float(rng.uniform(*CORNER)))
    along = bool(rng.integers(2))
    gap = float(rng.uniform(*BESIDE)) + more
    beside = (start[0] - sx * gap, start[1]) if along else (start[0], start[1] - sy * gap)
    other = _drawn([start, beside], lambda: _around(rng))
    first = _drawn([start, beside, (0.0, 0.0), other], lambda: _anywhere(rng))
    robots = (
        _robot(name, robot, start, _any_yaw(rng)),
        _robot("r1", "p3dx", first, _any_yaw(rng), drives="wander"),
    )
    return robots, (_box("near_box", beside, rng), _box("far_box", other, rng))


def _pair(rng: np.random.Generator) -> tuple[RobotStart, ...]:
    """Return the Pioneer near the middle, the SUMMIT-XL behind it and looking at it, and R1 elsewhere."""
    lead = (float(rng.uniform(-0.4, 0.4)), float(rng.uniform(-0.4, 0.4)))
    angle = float(rng.uniform(-math.pi, math.pi))
    behind = (lead[0] - DISTANCE * math.cos(angle), lead[1] - DISTANCE * math.sin(angle))
    other = _drawn([lead, behind], lambda: _anywhere(rng))
    return (
        _robot("r2", "p3dx", lead, angle),
        _robot("r3", "summit_xl", behind, angle),
        _robot("r1", "p3dx", other, _any_yaw(rng), drives="wander"),
    )


def _scenario(case: Case, robots: tuple[RobotStart, ...], boxes: tuple[Obstacle, ...]) -> Scenario:
    base = load_scenario("RocsP3dx").model_dump() | {
        "name": f"rocs {case}",
        "robots": robots,
        "obstacles": boxes,
    }
    return Scenario.model_validate({k: v for k, v in base.items() if k not in {"robot", "start"}})


def _robot(name: str, robot: str, at: Place, yaw: float, *, drives: str = "executive") -> RobotStart:
    return RobotStart.model_validate(
        {"name": name, "robot": robot, "start": FloorPose(x=at[0], y=at[1], yaw=yaw), "drives": drives}
    )


def _any_yaw(rng: np.random.Generator) -> float:
    return float(rng.uniform(-math.pi, math.pi))


def _box(name: str, at: tuple[float, float], rng: np.random.Generator) -> Obstacle:
    size = (float(rng.uniform(0.3, 0.5)), float(rng.uniform(0.3, 0.5)), 0.4)
    return Obstacle.model_validate(
        {
            "name": name,
            "shape": {"kind": "box", "size": size},
            "x": at[0],
            "y": at[1],
            "yaw": float(rng.uniform(-0.5, 0.5)),
            "mass": 0.0,
        }
    )


def _anywhere(rng: np.random.Generator) -> Place:
    return float(rng.uniform(-ROOM, ROOM)), float(rng.uniform(-ROOM, ROOM))


def _around(rng: np.random.Generator) -> tuple[float, float]:
    angle, away = float(rng.uniform(-math.pi, math.pi)), float(rng.uniform(*AWAY))
    return away * math.cos(angle), away * math.sin(angle)


def _drawn(placed: list[Place], one: Callable[[], Place]) -> Place:
    for _ in range(MOST_DRAWS):
        at = one()
        if all(math.dist(at, each) >= APART for each in placed):
            return at
    raise ValueError(f"no place {APART} m from {placed}")
