"""How k, gamma and mu of Algorithm 2 are found: against the true distance of sampled pairs of postures.

Each arm gets so many collision-free postures with its hand over a table; each is paired with each of the
other arm. A pair is dangerous when the true clearance is below the bound. For each gamma and mu, k is the
least for which no dangerous pair is missed; taken is what raises the fewest false alarms.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final, TypeVar

import numpy as np
import numpy.typing as npt

from tandem.skills.geometry.poses import from_rpy
from tandem.skills.kinematics.batch import BatchChain
from tandem.skills.kinematics.clearance import ArmsClearance
from tandem.skills.kinematics.collision import CollisionChecker
from tandem.skills.kinematics.described import home_positions
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.ik import SeedTable, Solver
from tandem.skills.kinematics.model import Limits
from tandem.skills.kinematics.transforms import Array, to_se3
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import ArmsCrossing, RobotDescription
from tandem.skills.ports.steps import run_through

T = TypeVar("T")

NEAR: Final = (0.35, -0.5, 0.75)
FAR: Final = (0.85, 0.5, 1.15)
"""Metres in the base: the corners of the space over a table from which tools are drawn."""
TURN: Final = 1.2
"""Radians by which a hand is turned from where it works best, either way."""
STEEPEST: Final = 1.3
"""Radians by which a hand points down at the most."""
STARTS: Final = 6
"""Postures that the inverse kinematics begins from for each pose."""
GAMMAS: Final = tuple(round(0.01 * k, 3) for k in range(21))
MUS: Final = tuple(round(0.02 * k, 3) for k in range(16))
"""Values of gamma and mu that ``tune`` tries, each with each."""


@dataclass(frozen=True)
class Pairs:
    """Sampled pairs (m,): the hands' distance along y, |d yaw|, |s pitch|, and the true clearance."""

    distance: Array
    turned: Array
    lowered: Array
    clearance: Array


@dataclass(frozen=True)
class Tuned:
    """What was found, and how often it is wrong: shares of the dangerous and of the harmless pairs."""

    k: float
    gamma: float
    mu: float
    missed: float
    false_alarms: float


def sample(hulls: RobotHulls, description: RobotDescription, rng: np.random.Generator, count: int) -> Pairs:
    """Draw ``count`` configurations of each arm, the grippers open, and pair each with each."""
    positions = dict(home_positions(description))
    for hand in description.end_effectors:
        wide = hand.gripper.max_width / len(hand.gripper.joints)
        positions |= dict.fromkeys(hand.gripper.joints, wide)
    left, right = (
        _over_the_table(hulls, description, side, positions=positions, rng=rng, count=count) for side in PAIR
    )
    clearance = ArmsClearance(hulls, description, positions)
    true = [clearance.at(np.concatenate((a, b))).distance for a in left[0] for b in right[0]]
    a, b = np.repeat(left[1], count, axis=0), np.tile(right[1], (count, 1))
    turned = np.abs(a[:, 2] - b[:, 2])
    return Pairs(
        distance=a[:, 0] - b[:, 0],
        turned=np.minimum(turned, 2.0 * np.pi - turned),
        lowered=np.abs(a[:, 1] + b[:, 1]),
        clearance=np.array(true),
    )


def tune(pairs: Pairs, bound: float) -> Tuned:
    """Return the k, gamma and mu that miss no dangerous pair and raise the fewest false alarms.

    Raises:
        ValueError: when no sampled pair is dangerous.
    """
    dangerous = pairs.clearance < bound
    if not dangerous.any():
        raise ValueError(f"no sampled pair comes nearer than {bound} m: sample more")
    found = []
    for gamma in GAMMAS:
        for mu in MUS:
            more = np.maximum(0.0, gamma * pairs.turned - mu * pairs.lowered)
            least = float(np.max((pairs.distance - more)[dangerous]))
            k = float(np.ceil(1000.0 * (least + 1e-9)) / 1000.0)
            found.append(judge(pairs, bound, k, gamma, mu))
    return min(found, key=lambda each: (each.false_alarms, each.k, each.gamma, each.mu))


def judge(pairs: Pairs, bound: float, k: float, gamma: float, mu: float) -> Tuned:
    """Return how often parameters are wrong about pairs."""
    threshold = k + np.maximum(0.0, gamma * pairs.turned - mu * pairs.lowered)
    alarm, dangerous = pairs.distance < threshold, pairs.clearance < bound
    return Tuned(k, gamma, mu, _share(~alarm, dangerous), _share(alarm, ~dangerous))


def judge_described(pairs: Pairs, how: ArmsCrossing) -> Tuned:
    """Return how often a robot's own parameters are wrong about pairs."""
    return judge(pairs, how.clearance, how.k, how.gamma, how.mu)


def _share(what: npt.NDArray[np.bool_], of: npt.NDArray[np.bool_]) -> float:
    return int((what & of).sum()) / max(1, int(of.sum()))


def _over_the_table(
    hulls: RobotHulls,
    description: RobotDescription,
    side: str,
    *,
    positions: Mapping[str, float],
    rng: np.random.Generator,
    count: int,
) -> tuple[Array, Array]:
    """Return configurations (count, n), and y (m), pitch and yaw (rad) of their tools (count, 3)."""
    hand = description.end_effector(side)
    checker = CollisionChecker(hulls, description.group(hand.group).joints, positions)
    joints = hulls.robot.limits(checker.joints)
    limits = Limits(joints.lower + 0.01, joints.upper - 0.01, joints.velocity)
    batch = BatchChain(checker.chain, hand.frame)
    solver = Solver(batch, limits, SeedTable(batch, limits, rng, checker.free))
    home = np.array([positions[joint] for joint in checker.joints])
    found: list[Array] = []
    tools: list[tuple[float, float, float]] = []
    while len(found) < count:
        yaw, pitch = hand.work_heading + rng.uniform(-TURN, TURN), rng.uniform(0.0, STEEPEST)
        place = rng.uniform(NEAR, FAR)
        x, y, z = map(float, place)
        target = to_se3(Pose(position=(x, y, z), orientation=from_rpy(0.0, pitch, yaw)))
        (answer,) = run_through(solver.solve(checker.chain, [target], home, STARTS))
        free = [q for q in answer.solutions if checker.free(q)]
        if free:
            found.append(free[0])
            tools.append((y, pitch, yaw))
    return np.array(found), np.array(tools)
