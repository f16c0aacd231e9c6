"""A joint that did not follow its motion: nothing else moves before it has followed a small step alone.

A motor that stalls, trips or is held fast keeps only its own joint where it is. The others carry the hand
off the path meanwhile, until the joint has strayed too far, and then brake from full speed. An arm that is
sent on at once does the same again from there, with each way out that is tried: in a shelf that ends at a
board. With a step of the one joint, nothing moves as long as it does not follow.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.arm.motion import Arrival
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.problem import Arm, Moment, Plan
from tandem.skills.arm.trajectory import MotionLimits, Trajectory
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.arm import MoveGoal

STEP: Final = 0.01
"""Radians (or metres) of the step: 7 mm at a hand 0.7 m away, and six times what the encoder of a Dynamixel
resolves (1.5 mrad)."""
FOLLOWS: Final = STEP / 2.0
"""How near its end the joint must come: nearer to it than to where it stood."""
STEP_TIME: Final = 0.3
"""Robot seconds of the step, if the joint's limits allow it: 0.05 rad/s at the most."""
GIVEN: Final = 0.2
"""Robot seconds more in which it must be there."""
STEP_ENDS: Final = Arrival(tolerance=FOLLOWS, within=GIVEN)
STUCK_AFTER: Final = 5.0
"""Robot seconds of steps that it does not follow, after which the move fails. A servo that trips and starts
again is back by then. A task's recoveries ask anew: a joint that stays stuck costs each of them this long."""


@dataclass(eq=False)
class Doubt:
    """Which joint of a group stayed behind last. All skills that move the group share it."""

    joint: str = ""
    """Its name; empty: all follow, as far as is known."""
    ahead: float = 0.0
    """Which way its motion lay when it stayed behind (its sign alone counts); 0: not known."""

    def note(self, joint: str, ahead: float = 0.0) -> None:
        """Doubt a joint from now on."""
        self.joint, self.ahead = joint, ahead

    def settle(self) -> None:
        """It follows."""
        self.joint, self.ahead = "", 0.0


def small_step(
    planner: MovePlanner, arm: Arm, goal: MoveGoal, moment: Moment, doubt: Doubt
) -> Generator[int, None, Plan | None]:
    """Return the step by which the joint in doubt shows that it follows; None: there is no room for one.

    Yields units of work. A hand that stands in the padding of something gets out of it by a step that touches
    nothing in truth.
    """
    for padded in (True, False):
        for step in small_steps(arm, arm.start(moment), doubt):
            touches = yield from planner.recheck(step, goal, moment, padded=padded)
            if touches is None:
                return Plan(step, 0, None, proves=doubt.joint)
    return None


def small_steps(arm: Arm, start: Array, doubt: Doubt) -> tuple[Trajectory, ...]:
    """Return the steps of the joint in doubt that its limits allow, that back to where it came from first.

    Args:
        arm: the group.
        start: where it stands (n,).
        doubt: the joint.
    """
    column = arm.group.joints.index(doubt.joint)
    limit, limits = arm.group.limits[column], arm.motion_limits
    steps: list[Trajectory] = []
    for sign in (-1.0, 1.0) if doubt.ahead >= 0.0 else (1.0, -1.0):
        end = start.copy()
        end[column] += sign * STEP
        if limit.lower <= end[column] <= limit.upper:
            steps.append(_step(start, end, _seconds(limits, column)))
    return tuple(steps)


def _seconds(limits: MotionLimits, column: int) -> float:
    """Return the time of a step within the joint's limits: its cubic has 1.5 and 6 times the mean of them."""
    speed, acceleration = float(limits.velocity[column]), float(limits.acceleration[column])
    return max(STEP_TIME, 1.5 * STEP / speed, float(np.sqrt(6.0 * STEP / acceleration)))


def _step(start: Array, end: Array, seconds: float) -> Trajectory:
    return Trajectory(np.array([0.0, seconds]), np.array([start, end]), np.zeros((2, len(start))))
