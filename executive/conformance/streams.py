"""Moving clauses about what is streamed: set-points of groups, velocities of the base."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.executive.conformance.harmless import standing
from tandem.executive.conformance.motions import back, farthest, go, small_motion
from tandem.executive.conformance.trajectories import groups_of
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import BaseVelocity, SetPoint

if TYPE_CHECKING:
    from collections.abc import Generator

    from tandem.executive.conformance.bench import Bench
    from tandem.executive.conformance.motions import Motion

HOLDS_AFTER: Final = 0.1
"""Robot seconds of silence after which a group holds."""
STREAMED: Final = 0.8
"""Robot seconds of a stream, from rest."""
LAG: Final = 0.3
"""Robot seconds in which motors follow."""
CREEP: Final = 0.008
"""rad or m that a group may move by in the half second after it holds."""
LEAST: Final = 0.3
"""Share of a stream's way that a group must have gone."""
AHEAD: Final = 0.1
"""m/s at which the base drives: what a person beside it can step away from."""
TURNING: Final = 0.2
"""rad/s."""
AVERAGED: Final = 0.5
"""Robot seconds over which a velocity is averaged: wheels that turn on the spot rub."""
OFF: Final = (0.03, 0.06)
"""m/s and rad/s by which a velocity may be off: a third of what is asked for."""
STANDS: Final = (0.01, 0.02)
"""m/s and rad/s below which a base stands."""


def _holds(bench: Bench) -> Steps:
    for group in groups_of(bench):
        motion = small_motion(bench, group)
        yield from _stream(bench, motion)
        braking = max(limit.velocity / limit.acceleration for limit in group.limits)
        yield from bench.pause(HOLDS_AFTER + min(braking, LAG) + LAG)
        stood = standing(bench, group)
        joint, gone = farthest(group.limits, motion.start, stood)
        if gone < LEAST * max(abs(a - b) for a, b in zip(motion.start, motion.end, strict=True)):
            raise Broken(f"{group.name} to follow set-points", f"{joint} moved by {gone:.4f}")
        yield from bench.pause(0.5)
        joint, moved = farthest(group.limits, stood, standing(bench, group))
        if moved > CREEP:
            raise Broken(
                f"{group.name} to hold after {HOLDS_AFTER:g} s without set-points",
                f"{joint} moved by {moved:.4f}",
            )
        yield from go(bench, back(bench, motion))


def _stream(bench: Bench, motion: Motion) -> Steps:
    topic, lease = keys.group_setpoint(motion.group.name), (yield from bench.leased())
    began, tick = bench.recording.passed, -1
    speeds = tuple((b - a) / STREAMED for a, b in zip(motion.start, motion.end, strict=True))
    while (passed := bench.recording.passed - began) < STREAMED:
        clock = bench.recording.clock
        if clock is not None and clock.tick != tick:
            tick = clock.tick
            at = tuple(a + speed * passed for a, speed in zip(motion.start, speeds, strict=True))
            point = SetPoint(stamp=clock.stamp, positions=at, velocities=speeds, lease=lease)
            topic.publish(bench.bus, point)
        yield from bench.until(lambda: bench.recording.passed - began > passed, 1.0)


def drive(bench: Bench, linear: float, angular: float, seconds: float) -> Steps:
    """Stream a velocity for so many robot seconds."""
    lease = yield from bench.leased()
    command = BaseVelocity(linear=linear, angular=angular, lease=lease)
    end = bench.recording.passed + seconds
    while (passed := bench.recording.passed) < end:
        keys.BASE_VELOCITY.publish(bench.bus, command)
        yield from bench.until(lambda: bench.recording.passed > passed, 1.0)


def speed(bench: Bench, start: int) -> tuple[float, float]:
    """Return odometry's average from its ``start``-th message on: m/s ahead and rad/s to the left."""
    told = bench.recording.messages(keys.ODOMETRY, start)
    if not told:
        raise Broken(f"odometry on {keys.ODOMETRY.key}", "none")
    return sum(each.linear for each in told) / len(told), sum(each.angular for each in told) / len(told)


def stands(bench: Bench) -> Generator[None, None, tuple[float, float] | None]:
    """Watch the base for a moment; return its velocity if it does not stand."""
    start = bench.recording.count(keys.ODOMETRY.key)
    yield from bench.pause(LAG)
    found = speed(bench, start)
    return found if any(abs(told) > still for told, still in zip(found, STANDS, strict=True)) else None


def _wishes(bench: Bench) -> tuple[tuple[float, float], ...]:
    if bench.robot.drive is None:
        raise Skip("the robot has no drive")
    driven = bench.robot.driven
    ahead, turning = min(AHEAD, driven.forward / 2.0, driven.backward / 2.0), min(TURNING, driven.turn / 2.0)
    return ((ahead, 0.0), (-ahead, 0.0), (0.0, turning), (0.0, -turning))


def _stop_time(bench: Bench, wish: tuple[float, float]) -> float:
    driven = bench.robot.driven
    return LAG + abs(wish[0]) / driven.acceleration + abs(wish[1]) / driven.turn_acceleration


def _obeyed(bench: Bench) -> Steps:
    for wish in _wishes(bench):
        yield from drive(bench, *wish, _stop_time(bench, wish))
        start = bench.recording.count(keys.ODOMETRY.key)
        yield from drive(bench, *wish, AVERAGED)
        found = speed(bench, start)
        yield from drive(bench, 0.0, 0.0, _stop_time(bench, wish))
        if any(abs(told - asked) > off for told, asked, off in zip(found, wish, OFF, strict=True)):
            raise Broken(_words(wish), _words(found))


def _dead_man(bench: Bench) -> Generator[None, None, None]:
    for wish in _wishes(bench):
        yield from drive(bench, *wish, _stop_time(bench, wish))
        yield from bench.pause(bench.robot.driven.dead_man + _stop_time(bench, wish))
        found = yield from stands(bench)
        if found is not None:
            yield from drive(bench, 0.0, 0.0, 1.0)
            raise Broken(
                f"a base that stands {bench.robot.driven.dead_man:g} s after the last velocity", _words(found)
            )


def _words(velocity: tuple[float, float]) -> str:
    return f"{velocity[0]:.3f} m/s and {velocity[1]:.3f} rad/s"


CLAUSES: Final = (
    Clause(
        "setpoints_hold",
        "A group follows streamed set-points, and holds 0.1 s after the last.",
        "interface.md#setpoint",
        _holds,
        moving=True,
    ),
    Clause(
        "velocity_obeyed",
        "The base drives and turns as commanded, within its limits.",
        "interface.md#basevelocity",
        _obeyed,
        moving=True,
    ),
    Clause(
        "velocity_dead_man",
        "Without a new velocity the base stands after the dead-man time.",
        "interface.md#basevelocity",
        _dead_man,
        moving=True,
    ),
)
