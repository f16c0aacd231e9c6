"""A joint group's controller: from goals and set-points to references the motors follow, period by period."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.sim.spline import Spline
from tandem.skills.ports.hardware import Answer, MotionState, SetPoint, TrajectoryGoal
from tandem.skills.ports.robot_description import JointGroup

Array = NDArray[np.float64]

SETPOINT_TIMEOUT: Final = 0.1
"""Seconds after which a stream that has dried up means hold."""

SETPOINT_GAIN: Final = 10.0
"""1/s: how fast the reference closes in on a streamed set-point."""

SPEED_SLACK: Final = 1.05
"""A path may exceed a joint's speed limit by this before it is refused (rounding of time-optimal plans)."""

HELD_FAST: Final = 0.005
"""rad or m that a joint is off its reference when its motion ends, from which on something holds it fast:
more than ten times what the servos are off with an item in the hand."""

REST_SPEED: Final = 0.02
"""rad/s or m/s below which a joint counts as at rest."""


@dataclass(frozen=True)
class Report:
    """Where the group's last goal stands: what goes into its status message."""

    goal_id: str = ""
    state: MotionState = MotionState.SUCCEEDED
    joint: str = ""
    error: float = 0.0
    at_rest: bool = True
    held: float = 0.0


@dataclass
class _Run:
    """A goal under way: ``phase`` is the time along its path, ``rate`` how fast it passes (1 unbraked)."""

    goal: TrajectoryGoal
    path: Spline
    phase: float = 0.0
    rate: float = 1.0
    held: float = 0.0
    ending: MotionState | None = None
    overtime: float = 0.0


class GroupController:
    """Follows one goal or one stream of set-points at a time; otherwise holds.

    Call ``advance`` once a period: it judges what was measured and moves the reference on. A goal is followed
    along its cubic Hermite path. To stop, the time along the path is slowed down within the joints'
    accelerations, so the joints brake without leaving the path. When a joint has strayed from it, all are
    held where they are at once, as fast as the motors can. Streams and a hold without a path brake each joint
    by itself.

    Args:
        group: names and limits.
        positions: where the joints are now (rad or m).
    """

    def __init__(self, group: JointGroup, positions: Sequence[float]) -> None:
        self.group = group
        self.position: Array = np.array(positions, dtype=np.float64)
        self.velocity: Array = np.zeros(len(positions))
        self.last_position: Array = self.position.copy()
        self.velocity_to_reference: Array = np.zeros(len(positions))
        self._lower = np.array([limit.lower for limit in group.limits])
        self._upper = np.array([limit.upper for limit in group.limits])
        self._speed = np.array([limit.velocity for limit in group.limits])
        self._acceleration = np.array([limit.acceleration for limit in group.limits])
        self._run: _Run | None = None
        self._setpoint: tuple[Array, Array] | None = None
        self._setpoint_age = 0.0
        self._settled = True
        self._unkept = False
        self.report = Report()

    @property
    def keeper(self) -> str:
        """Who watches over the goal that runs; empty when nobody does."""
        return "" if self._run is None else self._run.goal.keeper

    @property
    def rests(self) -> bool:
        """Whether there is nothing to do but hold, and the joints were at rest when last measured."""
        return self._run is None and self._setpoint is None and self._settled and self.report.at_rest

    def keep(self, *, awake: bool, gone: bool) -> None:
        """Hear of the keeper: while it is not awake the group stands on its path; gone, the goal ends."""
        self._unkept = not awake
        if gone:
            self.stop()

    def accept(self, goal: TrajectoryGoal) -> Answer:
        """Start the goal, or say why not. A goal that runs already is accepted again and goes on."""
        if goal.id == self.report.goal_id:
            return Answer(accepted=True, reason="known already")
        reason = self._refusal(goal)
        if reason:
            return Answer(accepted=False, reason=reason)
        self._setpoint = None
        self._settled = self._unkept = False
        points = goal.points
        times = [point.time for point in points]
        positions = [point.positions for point in points]
        velocities = [point.velocities for point in points]
        if times[0] > 0.0:
            times.insert(0, 0.0)
            positions.insert(0, tuple(self.position.tolist()))
            velocities.insert(0, tuple(self.velocity.tolist()))
        self._run = _Run(goal, Spline(times, positions, velocities))
        self.report = Report(goal.id, MotionState.ACTIVE, at_rest=False)
        return Answer(accepted=True)

    def _refusal(self, goal: TrajectoryGoal) -> str:
        count = len(self.group.limits)
        if any(len(p.positions) != count or len(p.velocities) != count for p in goal.points):
            return f"points of {self.group.name} have {count} positions and {count} velocities"
        if goal.points[0].time < 0.0:
            return "the first point's time is below zero"
        if not self.report.at_rest:
            return f"{self.group.name} is moving: cancel it and wait until it is at rest"
        for point in goal.points:
            for limit, value, speed in zip(self.group.limits, point.positions, point.velocities, strict=True):
                if not limit.lower - 1e-3 <= value <= limit.upper + 1e-3:
                    return f"{limit.joint}: {value:.4f} is outside {limit.lower:.4f} to {limit.upper:.4f}"
                if abs(speed) > limit.velocity * SPEED_SLACK:
                    return f"{limit.joint}: speed {speed:.3f} is above {limit.velocity:.3f}"
        return self._stray_start(goal) or self._too_fast(goal)

    def _stray_start(self, goal: TrajectoryGoal) -> str:
        if goal.points[0].time > 0.0:
            return ""
        gap = np.abs(np.array(goal.points[0].positions) - self.position)
        worst = int(np.argmax(gap))
        if gap[worst] <= goal.path_tolerance:
            return ""
        return f"{self.group.joints[worst]} stands {gap[worst]:.4f} away from the first point"

    def _too_fast(self, goal: TrajectoryGoal) -> str:
        start = (0.0, tuple(self.position.tolist()))
        legs = [(p.time, p.positions) for p in goal.points]
        if legs[0][0] > 0.0:
            legs.insert(0, start)
        for (t0, a), (t1, b) in pairwise(legs):
            for limit, x, y in zip(self.group.limits, a, b, strict=True):
                if abs(y - x) > (t1 - t0) * limit.velocity * SPEED_SLACK + 1e-6:
                    return f"{limit.joint}: from {x:.4f} to {y:.4f} in {t1 - t0:.3f} s is too fast"
        return ""

    def cancel(self, goal_id: str) -> Answer:
        """Brake along the path and hold; an empty id means whatever runs, a stream too."""
        if self._run is None:
            self._setpoint = None
            return Answer(accepted=True, reason="nothing was running")
        if goal_id not in ("", self._run.goal.id):
            return Answer(accepted=False, reason=f"{self._run.goal.id!r} is running, not {goal_id!r}")
        self._run.ending = self._run.ending or MotionState.CANCELED
        return Answer(accepted=True)

    def stop(self) -> None:
        """Brake whatever runs; the goal ends ABORTED."""
        self._setpoint = None
        if self._run is not None:
            self._run.ending = MotionState.ABORTED

    def stream(self, setpoint: SetPoint) -> bool:
        """Follow a set-point from now on; False when it is not one for this group or a goal runs."""
        count = len(self.group.limits)
        if self._run is not None or len(setpoint.positions) != count or len(setpoint.velocities) != count:
            return False
        positions, velocities = np.array(setpoint.positions), np.array(setpoint.velocities)
        self._setpoint = (
            np.clip(positions, self._lower, self._upper),
            np.clip(velocities, -self._speed, self._speed),
        )
        self._setpoint_age = 0.0
        self._settled = False
        return True

    def advance(self, period: float, measured: Array, measured_velocity: Array) -> None:
        """Judge the last period and set ``position`` and ``velocity`` for the end of the next one.

        ``last_position`` is the reference of now, and ``velocity_to_reference`` leads to the next.
        """
        if self._run is None and self._setpoint is None and self._resting(measured_velocity):
            return
        if self._run is not None:
            self._judge(self._run, period, measured, measured_velocity)
        self.last_position = self.position
        if self._run is not None:
            self._follow(self._run, period)
        elif self._setpoint is not None:
            self._chase(self._setpoint, period)
        else:
            self._brake(np.zeros_like(self.velocity), period)
        self.velocity_to_reference = (self.position - self.last_position) / period
        if self._run is None:
            self._settled = not self.velocity.any() and not self.velocity_to_reference.any()
            still = self._settled and float(np.abs(measured_velocity).max()) < REST_SPEED
            report = self.report
            if still is not report.at_rest:
                self.report = replace(report, at_rest=still)
                if still and report.state is MotionState.ABORTED:  # braked into what it ran against
                    self._let_up(np.abs(measured - self.position), measured)

    def _resting(self, measured_velocity: Array) -> bool:
        """Say whether there is nothing to do but hold, and nothing new to report."""
        return self._settled and self.report.at_rest and float(np.abs(measured_velocity).max()) < REST_SPEED

    def _judge(self, run: _Run, period: float, measured: Array, measured_velocity: Array) -> None:
        error = np.abs(measured - self.position)
        worst = int(np.argmax(error))
        if error[worst] > run.goal.path_tolerance:
            # As ROS 2's joint_trajectory_controller does: off its path, a hand is where nobody has looked.
            self._end(MotionState.ABORTED, worst, float(error[worst]))
            self.position = measured.copy()
            self.velocity = np.zeros_like(self.velocity)
            return
        if run.ending is not None and run.rate <= 0.0:
            self._end(run.ending, worst if run.ending is MotionState.ABORTED else -1, 0.0)
            self._let_up(error, measured)
            return
        if run.phase < run.path.duration or run.ending is not None:
            return
        if error[worst] <= run.goal.goal_tolerance and bool(np.all(np.abs(measured_velocity) < REST_SPEED)):
            self._end(MotionState.SUCCEEDED, -1, float(error[worst]))
            return
        run.overtime += period
        if run.overtime > run.goal.goal_time + 1e-9:
            self._end(MotionState.ABORTED, worst, float(error[worst]))
            self._let_up(error, measured)

    def _let_up(self, error: Array, measured: Array) -> None:
        """Hold where the joints are, and do not push on against what holds one fast."""
        if float(error.max()) > HELD_FAST:
            self.position = measured.copy()
            self.velocity = np.zeros_like(self.position)

    def _end(self, state: MotionState, worst: int, error: float) -> None:
        assert self._run is not None
        joint = self.group.joints[worst] if state is MotionState.ABORTED and error > 0.0 else ""
        held = self._run.held
        self.report = Report(self._run.goal.id, state, joint, error, at_rest=False, held=held)
        self._run = None
        if state is not MotionState.ABORTED:
            self.velocity = np.zeros_like(self.velocity)

    def _follow(self, run: _Run, period: float) -> None:
        stands = run.ending is not None or self._unkept
        if stands or run.rate < 1.0:
            pace = np.abs(run.path.velocity(run.phase))
            fastest = float(np.min(self._acceleration / np.maximum(pace, 1e-6))) * period
            run.rate = max(0.0, run.rate - fastest) if stands else min(1.0, run.rate + fastest)
            run.held += (1.0 - run.rate) * period
            if run.rate >= 1.0:
                self.report = replace(self.report, held=run.held)
        run.phase = min(run.phase + run.rate * period, run.path.duration)
        self.position = run.path.position(run.phase)
        done = run.phase >= run.path.duration
        self.velocity = np.zeros_like(self.position) if done else run.path.velocity(run.phase) * run.rate
        if done and run.ending is not None:
            run.rate = 0.0

    def _chase(self, setpoint: tuple[Array, Array], period: float) -> None:
        self._setpoint_age += period
        if self._setpoint_age > SETPOINT_TIMEOUT:
            self._setpoint = None
            self._brake(np.zeros_like(self.velocity), period)
            return
        target, feed = setpoint
        gap = target + feed * self._setpoint_age - self.position
        bound = np.sqrt(2.0 * self._acceleration * np.abs(gap))
        wish = feed + np.clip(SETPOINT_GAIN * gap, -bound, bound)
        self._brake(np.clip(wish, -self._speed, self._speed), period)

    def _brake(self, wish: Array, period: float) -> None:
        """Move each joint's speed towards ``wish`` within its acceleration, and the position along."""
        change = self._acceleration * period
        before = self.velocity
        self.velocity = before + np.clip(wish - before, -change, change)
        self.position = np.clip(
            self.position + 0.5 * (before + self.velocity) * period, self._lower, self._upper
        )
