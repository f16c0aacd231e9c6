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


def draw(case: Case, rng: np.random.Generator) -> Scenario:
    """Return what a run begins with. R2 is the Pioneer, R3 the SUMMIT-XL, R1 the Pioneer with a script."""
    if case == 3:  # noqa: PLR2004 - EXP3
        return _scenario(case, _pair(rng), ())
    sides = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
    sx, sy = sides[int(rng.integers(4))]
    start = (sx * float(rng.uniform(*CORNER)), sy * float(rng.uniform(*CORNER)))
    wide = case == 2  # noqa: PLR2004 - the SUMMIT-XL is nearly twice as wide as the Pioneer
    if wide:
        start = (0.88 * start[0], 0.88 * start[1])
    along = bool(rng.integers(2))
    gap = float(rng.uniform(*BESIDE)) + (0.25 if wide else 0.0)
    beside = (start[0] - sx * gap, start[1]) if along else (start[0], start[1] - sy * gap)
    placed = [start, beside, (0.0, 0.0)]
    other = _drawn(placed[:2], lambda: _around(rng))
    placed.append(other)
    first = _drawn(placed, lambda: (float(rng.uniform(-ROOM, ROOM)), float(rng.uniform(-ROOM, ROOM))))
    robots = (
        _robot("r3" if wide else "r2", "summit_xl" if wide else "p3dx", start, _any_yaw(rng)),
        _robot("r1", "p3dx", first, _any_yaw(rng), drives="wander"),
    )
    return _scenario(case, robots, (_box("near_box", beside, rng), _box("far_box", other, rng)))


def _pair(rng: np.random.Generator) -> tuple[RobotStart, ...]:
    """Return the Pioneer near the middle, the SUMMIT-XL behind it and looking at it, and R1 elsewhere."""
    lead = (float(rng.uniform(-0.4, 0.4)), float(rng.uniform(-0.4, 0.4)))
    angle = float(rng.uniform(-math.pi, math.pi))
    behind = (lead[0] - DISTANCE * math.cos(angle), lead[1] - DISTANCE * math.sin(angle))
    other = _drawn([lead, behind], lambda: (float(rng.uniform(-ROOM, ROOM)), float(rng.uniform(-ROOM, ROOM))))
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


def _around(rng: np.random.Generator) -> tuple[float, float]:
    angle, away = float(rng.uniform(-math.pi, math.pi)), float(rng.uniform(*AWAY))
    return away * math.cos(angle), away * math.sin(angle)


def _drawn(placed: list[Place], one: Callable[[], Place]) -> Place:
    for _ in range(MOST_DRAWS):
        at = one()
        if all(math.dist(at, each) >= APART for each in placed):
            return at
    raise ValueError(f"no place {APART} m from {placed}")
