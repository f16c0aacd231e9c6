"""Where the set-points are, how fast and how fast that changes: moved on period by period, within all limits.

Ruckig's on-line generator (Berscheid and Kroeger, "Jerk-limited real-time trajectory generation with
arbitrary target states", RSS 2021) makes each step time-optimal towards a velocity or towards joint
positions. Both begin in the same state, so that one can turn into the other at any period without a jerk
beyond the limit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import ruckig

from tandem.skills.arm.trajectory import MotionLimits, Trajectory
from tandem.skills.kinematics.transforms import Array

AT_REST: Final = 1e-4
"""rad/s and rad/s2 below which a reference stands."""
BRAKE_LOOKS: Final = (0.5, 1.0)
"""Shares of the braking time at which its path is looked at."""
ALONE: Final = (ruckig.Synchronization.No,)
TOGETHER: Final = (ruckig.Synchronization.Phase, ruckig.Synchronization.Time, *ALONE)
"""How the joints keep step: along a straight way where that is possible, else so that all arrive at once."""

HEADROOM: Final = 0.95
"""Share of a joint's speed at which set-points go at the most. With all of it a UR5's elbow (3.15 rad/s,
5 rad/s2) overshot by 0.15 rad while it braked."""


@dataclass(frozen=True)
class State:
    """Positions, velocities and accelerations, each (n,): rad, rad/s, rad/s2."""

    q: Array
    v: Array
    a: Array

    @property
    def still(self) -> bool:
        """Whether it stands."""
        return bool(np.abs(self.v).max() < AT_REST and np.abs(self.a).max() < AT_REST)


def standing(q: Array) -> State:
    """Return the state of standing at q."""
    return State(q.copy(), np.zeros(len(q)), np.zeros(len(q)))


class Stepper:
    """Makes the next state of one group.

    Args:
        limits: of its joints.
        period: seconds of a step.
    """

    def __init__(self, limits: MotionLimits, period: float) -> None:
        count = len(limits.velocity)
        self._period, self._limits = period, limits
        self._otg = ruckig.Ruckig(count, period)
        self._by_speed, self._by_place = ruckig.InputParameter(count), ruckig.InputParameter(count)
        self._to_rest = ruckig.InputParameter(count)
        for each in (self._by_speed, self._by_place, self._to_rest):
            each.max_velocity = limits.velocity.tolist()
            each.max_acceleration = limits.acceleration.tolist()
            each.max_jerk = limits.jerk.tolist()
            each.target_velocity = each.target_acceleration = [0.0] * count
        for each in (self._by_speed, self._to_rest):
            each.control_interface = ruckig.ControlInterface.Velocity
        self._out = ruckig.OutputParameter(count)
        self._rest, self._rest_at = ruckig.Trajectory(count), 0.0
        self._braked: State | None = None
        """What was last returned on a way to rest."""

    def to_velocity(self, state: State, velocity: Array) -> State:
        """Return the state one period later on the way to a velocity (n,)."""
        self._by_speed.target_velocity = np.clip(
            velocity, -self._limits.velocity, self._limits.velocity
        ).tolist()
        return self._step(self._by_speed, state, TOGETHER)

    def to_place(self, state: State, q: Array) -> State:
        """Return the state one period later on the way to rest at q (n,)."""
        self._by_place.target_position = q.tolist()
        return self._step(self._by_place, state, TOGETHER)

    def brake(self, state: State) -> State:
        """Return the state one period later on the way to rest, the joints in step.

        Joints that each stopped as soon as they can would leave the way that they are on, and with it what it
        was led around: one that makes room for another would stop before that. A way to rest that was begun
        is gone to its end: one that was found anew on it would be another one.
        """
        if state is not self._braked:
            self._rest, self._rest_at = self._way_to_rest(state), 0.0
        self._rest_at += self._period
        q, v, a = self._rest.at_time(min(self._rest_at, self._rest.duration))
        ended = self._rest_at >= self._rest.duration
        self._braked = standing(np.array(q)) if ended else State(np.array(q), np.array(v), np.array(a))
        return self._braked

    def braking(self, state: State) -> tuple[Array, ...]:
        """Return positions on the way to rest from a state, the last is where it stands."""
        begun = state is self._braked
        rest, at = (self._rest, self._rest_at) if begun else (self._way_to_rest(state), 0.0)
        left = max(0.0, rest.duration - at)
        return tuple(np.array(rest.at_time(at + share * left)[0]) for share in BRAKE_LOOKS)

    def _way_to_rest(self, state: State) -> ruckig.Trajectory:
        found = ruckig.Trajectory(len(state.q))
        self._put(self._to_rest, state)
        for way in TOGETHER:
            self._to_rest.synchronization = way
            try:
                self._otg.calculate(self._to_rest, found)
            except ruckig.RuckigError:  # rare: rounding in its search for a common duration
                continue
            break
        return found

    def _step(
        self, begin: ruckig.InputParameter, state: State, ways: Sequence[ruckig.Synchronization]
    ) -> State:
        self._put(begin, state)
        for way in ways:
            begin.synchronization = way
            try:
                self._otg.reset()
                self._otg.update(begin, self._out)
            except ruckig.RuckigError:  # rare: rounding in its search for a common duration
                continue
            break
        else:
            return self.brake(state)
        return State(
            np.array(self._out.new_position),
            np.array(self._out.new_velocity),
            np.array(self._out.new_acceleration),
        )

    @staticmethod
    def _put(begin: ruckig.InputParameter, state: State) -> None:
        begin.current_position = state.q.tolist()
        begin.current_velocity = state.v.tolist()
        begin.current_acceleration = state.a.tolist()


def along(trajectory: Trajectory, at: float, period: float) -> State:
    """Return the state at ``at`` seconds of a planned motion."""
    times = np.array([at - period, at - 0.5 * period, at, at + 0.5 * period, at + period])
    q = trajectory.sample(times)
    if at >= trajectory.duration:
        return standing(q[2])
    v = (q[3] - q[1]) / period
    a = (q[4] - 2.0 * q[2] + q[0]) / period**2
    return State(q[2], v, a)


def with_headroom(trajectory: Trajectory, limits: MotionLimits) -> Trajectory:
    """Return a motion, slowed down if it needs all of a joint's speed, as set-points can be followed.

    A motor that is behind its set-points catches up by being faster than they are. One whose set-points are
    as fast as it can be stays behind, and then has to brake harder than it can.
    """
    most = float((np.abs(trajectory.velocities) / limits.velocity).max())
    stretch = max(1.0, most / HEADROOM)
    return Trajectory(stretch * trajectory.times, trajectory.positions, trajectory.velocities / stretch)
