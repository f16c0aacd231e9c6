"""The field at work: from where the arm is and where the item is to the next set-point."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from tandem.skills.arm.field.desired_twist import (
    Chooser,
    DesiredTwist,
    desired_twist,
    nearest_of_hand,
    with_other_goal,
)
from tandem.skills.arm.field.ends import End
from tandem.skills.arm.field.live import Live
from tandem.skills.arm.field.potential import Gains
from tandem.skills.arm.field.progress import Progress
from tandem.skills.arm.field.reference import State
from tandem.skills.arm.field.setpoint_guard import DAMPED, FIELD, Guard
from tandem.skills.arm.field.setpoints import Make, Motion
from tandem.skills.arm.field.target import Target
from tandem.skills.arm.field.velocities import Dampers, VelocitySolver
from tandem.skills.arm.problem import Arm
from tandem.skills.kinematics.proximity import Nearby
from tandem.skills.kinematics.transforms import Array, rotation_vector, to_se3

LAND_WITHIN: Final = 0.15
"""Metres (and LAND_TURN radians) from the goal within which the joints go straight to it, as fast as they can
and to rest without overshoot: this is why the field is not slow at its end."""
LAND_TURN: Final = 0.7
"""About 40 degrees. With more, joints that go straight lead the hand off its straight way; with less the
field turns the hand itself, at no more than TURN_RATE."""
LAND_LOOKS: Final = (0.25, 0.5, 0.75, 1.0)
"""Shares of the straight way of the joints at which it must be free for that."""
TURN_RATE: Final = 2.0
"""rad/s of the hand at the most."""
CRUISE_SHARE: Final = 0.85
"""Of the joints' speeds, that the way is made with; the rest is for what comes up on it."""
SOONEST: Final = 0.12
"""Seconds: the shortest time in which what is left is done."""
FRESH: Final = (0.01, 0.05)
"""Metres and radians by which the item may have moved since the goal's joints were found, for landing."""
THERE: Final = 1e-4
"""Radians from the goal's joints at which a reference that stands has arrived."""


@dataclass(frozen=True)
class Step:
    """What a period brought.

    The metres that are left to the goal, whether the set-points have arrived, whether an escape point draws,
    and whether nothing has been gained for long.
    """

    distance: float
    arrived: bool
    escaping: bool
    stuck: bool


class FieldController:
    """Goes down the field.

    Args:
        arm: the group.
        live: what is around.
        guard: what is free.
        motion: the set-points.
        speed: share of the limits.
    """

    def __init__(self, arm: Arm, live: Live, guard: Guard, motion: Motion, speed: float) -> None:
        hand = arm.hand
        assert hand is not None  # the skill is for groups with a hand
        self._frame, self._live, self._guard, self._motion = hand.frame, live, guard, motion
        self._gains = Gains(cruise=Gains().cruise * speed, braking=Gains().braking * speed)
        self._speed = speed
        self._fastest = CRUISE_SHARE * speed * arm.motion_limits.velocity
        self._solver = VelocitySolver(arm.limits, arm.motion_limits.scaled(speed))
        links = arm.hulls.links
        last = max(k for k, name in enumerate(links) if name in hand.touch_links)
        self._hand_names = frozenset({*hand.touch_links, links[last]})
        self._chooser, self._progress = Chooser(), Progress()
        self._built, self._hand = -1, np.zeros(0, dtype=bool)

    @property
    def escapes(self) -> int:
        """How often an escape point was used."""
        return self._chooser.escapes

    def reset(self) -> None:
        """Forget what was pursued: the goal has moved far, or the arm has been elsewhere."""
        self._chooser.reset()
        self._progress.reset()

    def step(self, periods: int, target: Target, end: End) -> Step:
        """Go on by so many periods."""
        state = self._motion.state
        near = self._guard.look(self._live.full(state.q))
        hand, jacobian = self._live.proximity.hand(self._frame)
        goal = to_se3(target.before(end.grasp, end.turn)).homogeneous
        distance = float(np.linalg.norm(goal[:3, 3] - hand[:3, 3]))
        angle = float(np.linalg.norm(rotation_vector(hand[:3, :3], goal[:3, :3])))
        left = end.q - state.q
        soonest = max(angle / (TURN_RATE * self._speed), float(np.max(np.abs(left) / self._fastest)), SOONEST)
        asked = self._desired(hand, goal, near, soonest)
        if self._may_land(state, distance, angle, target, end):
            make: Make = lambda at: self._motion.stepper.to_place(at, end.q)  # noqa: E731 - one of two ways
        else:
            velocity = self._solver.solve(
                state.q, state.v, jacobian, asked.twist, left / asked.seconds, self._dampers(near)
            )
            make = lambda at: self._motion.stepper.to_velocity(at, velocity)  # noqa: E731
        self._motion.advance(periods, make, FIELD, recorded=True)
        state = self._motion.state
        arrived = state.still and bool(np.abs(state.q - end.q).max() < THERE) and _fresh(target, end)
        stuck = self._progress.stuck(asked.remaining, angle, asked.pole.label) and not arrived
        return Step(distance, arrived, asked.pole.escape, stuck)

    def _desired(self, hand: Array, goal: Array, near: Nearby, soonest: float) -> DesiredTwist:
        p = hand[:3, 3]
        pole = self._chooser.pole(p, goal[:3, 3], self._live.around)
        rho, normals = nearest_of_hand(near, self._of_hand(), self._live.proximity.first_obstacle)
        rho, normals = with_other_goal(rho, normals, p, self._live.other_goal())
        return desired_twist(hand, goal, pole, rho, normals, self._gains, soonest)

    def _of_hand(self) -> npt.NDArray[np.bool_]:
        near = self._live.proximity
        if self._built != near.built:
            self._built = near.built
            self._hand = np.array([name in self._hand_names for name in near.names], dtype=bool)
        return self._hand

    def _dampers(self, near: Nearby) -> Dampers:
        return Dampers(near.gradient, near.distance, self._guard.floors(DAMPED)[near.pair])

    def _may_land(self, state: State, distance: float, angle: float, target: Target, end: End) -> bool:
        if distance > LAND_WITHIN or angle > LAND_TURN or not _fresh(target, end):
            return False
        ways = [state.q + share * (end.q - state.q) for share in LAND_LOOKS]
        return self._guard.free(self._live.cases(state.q), ways, FIELD)


def _fresh(target: Target, end: End) -> bool:
    metres, radians = target.moved(end.target)
    return metres <= FRESH[0] and radians <= FRESH[1]
