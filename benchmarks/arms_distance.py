"""How long it takes to know how far the two arms are apart, and how long the reflex's whole look takes."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial

import numpy as np

from benchmarks.rows import Row, spread
from tandem.sim.robots.registry import robot_model
from tandem.skills.kinematics.clearance import ArmsClearance
from tandem.skills.kinematics.described import home_positions, load_hulls
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.message import RobotTime
from tandem.skills.reflex.crossing_watch import ArmsWatch
from tandem.skills.site import load

COUNT, QUICK = 3000, 100
AIM = 0.5
"""Milliseconds."""


def rows(*, quick: bool = False) -> list[Row]:
    """Measure at configurations drawn evenly within the joints' limits."""
    description = robot_model("tiago_dual").description
    hulls, positions = load_hulls(description), dict(home_positions(description))
    for hand in description.end_effectors:
        positions |= dict.fromkeys(hand.gripper.joints, 0.0)
    clearance = ArmsClearance(hulls, description, positions)
    limits = hulls.robot.limits(clearance.joints)
    drawn = np.random.default_rng(1).uniform(
        limits.lower, limits.upper, (QUICK if quick else COUNT, len(clearance.joints))
    )
    assert description.arms_crossing is not None
    watch = ArmsWatch(hulls, description, description.arms_crossing, load("lab"))
    names = tuple(positions)

    def look(q: np.ndarray[tuple[int], np.dtype[np.float64]]) -> None:
        at = positions | dict(zip(clearance.joints, map(float, q), strict=True))
        stamp, still = RobotTime(boot="bench", seconds=0.0), tuple(0.5 for _ in names)
        told = JointStates(
            stamp=stamp, names=names, positions=tuple(at.values()), velocities=still, efforts=still
        )
        watch.look(told, None)

    return [
        *spread("distance between the arms", [_timed(partial(clearance.at, q)) for q in drawn], aim=AIM),
        *spread("the reflex's look while both arms move", [_timed(partial(look, q)) for q in drawn]),
    ]


def _timed(what: Callable[[], object]) -> float:
    began = time.perf_counter()
    what()
    return time.perf_counter() - began
