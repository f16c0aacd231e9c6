"""When the joints are where: jerk-limited timing of a path that was checked.

A segment is timed by ruckig along its length, all joints in step. At a waypoint the next segment may start
before the last one has ended, as far as the joints' limits allow; the joints then cut the corner, within
the parallelogram of the two segments, and the caller checks the result. A curve is timed by ruckig along
its length, with limits that hold everywhere on it.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Final

import numpy as np
import ruckig

from tandem.skills.arm.curve import Curve
from tandem.skills.arm.trajectory import MotionLimits, Trajectory
from tandem.skills.kinematics.transforms import Array

PERIOD: Final = 0.02
"""Seconds between the points that are sent."""
NOTHING: Final = 1e-9
"""Of a path's length, of a move or of a rate: what is no more is none, so that nothing is divided by 0. It is
far above the rounding of numbers about 1, and far below any motion that is asked for."""
OVERLAPS: Final = (1.0, 0.85, 0.7, 0.55, 0.4, 0.3, 0.2, 0.1)
"""Shares of the longest overlap that are tried, longest first."""
SLACK: Final = 1.0 + 1e-6
"""Factor on a limit: a motion right at it passes, also where rounding puts it a little above."""
FINE: Final = 0.01
"""Seconds between the places of a curve at which the joints' limits are looked at: a tenth of what a joint of
TIAGo takes to its greatest acceleration."""
FINEST: Final = 20
"""Places at the least."""
BEND_SHARES: Final = (0.02, 0.1, 0.2, 0.35, 0.5)
"""Shares of the accelerations that are left for the bends of a curve; the fastest is taken."""


@dataclass(frozen=True)
class _Rate:
    """Limits of the place along a path: 1/s, 1/s2, 1/s3."""

    velocity: float
    acceleration: float
    jerk: float


@dataclass(frozen=True)
class _Profile:
    """A rest-to-rest motion from 0 to ``length``, ``pace`` times as quick as it was found."""

    found: ruckig.Trajectory
    length: float
    pace: float = 1.0

    @property
    def duration(self) -> float:
        """Seconds."""
        return float(self.found.duration) / self.pace

    def at(self, times: Array) -> tuple[Array, Array, Array]:
        """Return place, speed and acceleration, each (m,); at rest outside of the duration."""
        last = float(self.found.duration)
        rows = [self.found.at_time(min(max(float(t) * self.pace, 0.0), last)) for t in times]
        table = np.array([[row[0][0], row[1][0], row[2][0]] for row in rows])
        table *= (1.0, self.pace, self.pace**2)
        done = times >= self.duration
        table[done] = (self.length, 0.0, 0.0)
        table[times <= 0.0] = 0.0
        return table[:, 0], table[:, 1], table[:, 2]


def time_path(path: Array, limits: MotionLimits, blend: float = 1.0) -> Trajectory:
    """Return the motion through the waypoints (m, n), from rest to rest.

    Args:
        path: waypoints; one alone means a motion of no time.
        limits: of the joints.
        blend: share (0 to 1) of the longest overlap at waypoints; at 0 it stops in each, and never leaves
            the straight lines.
    """
    moves = [(a, b - a) for a, b in itertools.pairwise(path) if _moves(b - a)]
    if not moves:
        return Trajectory(np.zeros(1), path[:1].copy(), np.zeros((1, path.shape[1])))
    profiles = [_profile(_straight(move, limits), 1.0) for _, move in moves]
    starts = [0.0]
    for k in range(1, len(moves)):
        before, after = profiles[k - 1], profiles[k]
        overlap = _overlap(before, moves[k - 1][1], after, moves[k][1], limits, blend) if blend > 0.0 else 0.0
        starts.append(starts[-1] + before.duration - overlap)
    times = _grid(starts[-1] + profiles[-1].duration)
    positions = np.repeat(path[:1], len(times), axis=0)
    velocities = np.zeros_like(positions)
    for start, profile, (_, move) in zip(starts, profiles, moves, strict=True):
        place, speed, _ = profile.at(times - start)
        positions += place[:, None] * move
        velocities += speed[:, None] * move
    positions[-1], velocities[-1] = path[-1], 0.0
    return Trajectory(times, positions, velocities)


def time_curve(curve: Curve, limits: MotionLimits) -> Trajectory:
    """Return the motion along the curve, from rest to rest."""
    length = float(curve.s[-1])
    if length < NOTHING:
        return Trajectory(np.zeros(1), curve.points[:1].copy(), np.zeros((1, curve.points.shape[1])))
    options = [_profile(_along(curve, limits, share), length) for share in BEND_SHARES]
    best = min((_paced(each, curve, limits) for each in options), key=lambda profile: profile.duration)
    times = _grid(best.duration)
    place, speed, _ = best.at(times)
    positions, velocities = curve.at(place), curve.slope_at(place) * speed[:, None]
    positions[0], positions[-1] = curve.points[0], curve.points[-1]
    return Trajectory(times, positions, velocities)


def bang_bang(a: Array, b: Array, limits: MotionLimits) -> float:
    """Return the seconds that the slowest joint needs from a to b (n,) with no limit of its jerk."""
    move = np.abs(b - a)
    ramp = limits.velocity**2 / limits.acceleration
    cruise = move / limits.velocity + limits.velocity / limits.acceleration
    return float(np.max(np.where(move < ramp, 2.0 * np.sqrt(move / limits.acceleration), cruise)))


def _paced(profile: _Profile, curve: Curve, limits: MotionLimits) -> _Profile:
    """Return the motion as quick as the joints' limits allow; it was found with those of its worst place.

    With all of it p times as quick, speeds grow with p, accelerations with p2, jerks with p3.
    """
    times = np.linspace(0.0, profile.duration, max(FINEST, int(profile.duration / FINE)))
    place, speed, push = profile.at(times)
    slope, bend = curve.slope_at(place), curve.bend_at(place)
    velocity = slope * speed[:, None]
    acceleration = bend * (speed**2)[:, None] + slope * push[:, None]
    jerk = np.diff(acceleration, axis=0) / (times[1] - times[0])
    used = (
        float(np.max(np.abs(velocity) / limits.velocity)),
        float(np.max(np.abs(acceleration) / limits.acceleration)) ** (1 / 2),
        float(np.max(np.abs(jerk) / limits.jerk)) ** (1 / 3),
    )
    return _Profile(profile.found, profile.length, profile.pace / max(*used, NOTHING))


def _moves(move: Array) -> bool:
    return float(np.max(np.abs(move))) > NOTHING


def _grid(duration: float) -> Array:
    return np.linspace(0.0, duration, max(2, int(np.ceil(duration / PERIOD)) + 1))


def _straight(move: Array, limits: MotionLimits) -> _Rate:
    size = np.maximum(np.abs(move), NOTHING)
    return _Rate(
        float(np.min(limits.velocity / size)),
        float(np.min(limits.acceleration / size)),
        float(np.min(limits.jerk / size)),
    )


def _along(curve: Curve, limits: MotionLimits, bend_share: float) -> _Rate:
    slope = np.maximum(np.max(np.abs(curve.slope), axis=0), NOTHING)
    bend = np.maximum(np.max(np.abs(curve.bend), axis=0), NOTHING)
    by_bend = float(np.min(np.sqrt(bend_share * limits.acceleration / bend)))
    return _Rate(
        min(float(np.min(limits.velocity / slope)), by_bend),
        float(np.min((1.0 - bend_share) * limits.acceleration / slope)),
        # The bends bring a jerk of their own: half of it is left for them.
        0.5 * float(np.min(limits.jerk / slope)),
    )


def _profile(rate: _Rate, length: float) -> _Profile:
    request = ruckig.InputParameter(1)
    request.current_position, request.target_position = [0.0], [length]
    request.max_velocity, request.max_acceleration = [rate.velocity], [rate.acceleration]
    request.max_jerk = [rate.jerk]
    found = ruckig.Trajectory(1)
    if ruckig.Ruckig(1).calculate(request, found) not in {ruckig.Result.Working, ruckig.Result.Finished}:
        raise ValueError(f"no timing for a length of {length} with limits {rate}")
    return _Profile(found, length)


def _overlap(  # noqa: PLR0917 - two segments and their limits
    before: _Profile, move: Array, after: _Profile, next_move: Array, limits: MotionLimits, blend: float
) -> float:
    """Return the longest tried overlap (s) of two segments with which no joint exceeds its limits."""
    longest = 0.5 * blend * min(before.duration, after.duration)
    for share in OVERLAPS:
        overlap = share * longest
        times = np.linspace(0.0, overlap, max(8, int(overlap / 0.01)))
        _, v1, a1 = before.at(before.duration - overlap + times)
        _, v2, a2 = after.at(times)
        speed = v1[:, None] * move + v2[:, None] * next_move
        push = a1[:, None] * move + a2[:, None] * next_move
        jerk = np.diff(push, axis=0) / (times[1] - times[0])
        within = (
            np.all(np.abs(speed) <= SLACK * limits.velocity)
            and np.all(np.abs(push) <= SLACK * limits.acceleration)
            and np.all(np.abs(jerk) <= SLACK * limits.jerk)
        )
        if within:
            return overlap
    return 0.0
