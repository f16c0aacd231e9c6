"""Motions of a group by a few degrees: what the moving clauses send, and how they wait for its end."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken
from tandem.executive.conformance.harmless import standing
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import (
    CancelMotion,
    GroupStatus,
    MotionState,
    TrajectoryGoal,
    TrajectoryPoint,
)
from tandem.skills.ports.urdf_check import parsed

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.hardware import Answer
    from tandem.skills.ports.robot_description import JointGroup, JointLimit

TURN: Final = 0.05
"""rad that a joint is moved: 3 degrees, enough to be told from noise, and seldom into anything."""
SHIFT: Final = 0.015
"""m that a prismatic joint is moved."""
LEAST_TIME: Final = 1.0
"""Robot seconds of a motion; longer for joints that are slow."""
TELLING: Final = 0.5
"""Robot seconds for telling what has happened."""
REST: Final = 0.03
"""rad/s or m/s below which a joint counts as at rest, with the noise of its encoder."""


@dataclass(frozen=True)
class Motion:
    """Where a group goes, from where, and how long it takes."""

    group: JointGroup
    start: tuple[float, ...]
    end: tuple[float, ...]
    takes: float


def small_motion(bench: Bench, group: JointGroup) -> Motion:
    """Return a motion of all joints by a few degrees, each towards the middle of its range."""
    start, sliding = standing(bench, group), _sliding(bench)
    ends, seconds = [], LEAST_TIME
    for limit, at in zip(group.limits, start, strict=True):
        way = min(SHIFT if limit.joint in sliding else TURN, 0.2 * (limit.upper - limit.lower))
        ends.append(at + (way if at < (limit.lower + limit.upper) / 2.0 else -way))
        # A spline from rest to rest is 1.5 times as fast in its middle as on average.
        seconds = max(seconds, 3.0 * way / limit.velocity, (12.0 * way / limit.acceleration) ** 0.5)
    return Motion(group, start, tuple(ends), seconds)


def back(bench: Bench, motion: Motion) -> Motion:
    """Return the way back to the start, from where the group stands."""
    return Motion(motion.group, standing(bench, motion.group), motion.start, motion.takes)


def _sliding(bench: Bench) -> frozenset[str]:
    joints = parsed(bench.robot.urdf).findall("joint")
    return frozenset(joint.get("name", "") for joint in joints if joint.get("type") == "prismatic")


def goal_of(
    bench: Bench, points: Sequence[tuple[float, Sequence[float]]], **more: float
) -> Generator[None, None, TrajectoryGoal]:
    """Return a goal that rests at each point (seconds, positions), under this process's lease."""
    lease = yield from bench.leased()
    made = tuple(
        TrajectoryPoint(time=time, positions=tuple(at), velocities=(0.0,) * len(at)) for time, at in points
    )
    return TrajectoryGoal(id=bench.new_id(), points=made, lease=lease, **more)  # type: ignore[arg-type]


def start(
    bench: Bench, motion: Motion, seconds: float | None = None
) -> Generator[None, None, TrajectoryGoal]:
    """Send the motion; Broken unless it is accepted."""
    until = motion.takes if seconds is None else seconds
    goal = yield from goal_of(bench, ((0.0, motion.start), (until, motion.end)))
    answer = yield from bench.ask(keys.group_goal(motion.group.name), goal)
    if not answer.accepted:
        raise Broken(
            f"a motion of {motion.group.name} by a few degrees accepted", f"refused: {answer.reason}"
        )
    return goal


def ended(
    bench: Bench, motion: Motion, goal: TrajectoryGoal, within: float
) -> Generator[None, None, GroupStatus]:
    """Return the last status of a goal; Broken if it does not end, at rest, within robot seconds."""
    topic = keys.group_status(motion.group.name)

    def told() -> GroupStatus | None:
        status = bench.recording.latest(topic)
        over = status is not None and status.goal_id == goal.id and status.state is not MotionState.ACTIVE
        return status if over and status is not None and status.at_rest else None

    yield from bench.until(lambda: told() is not None, within)
    status = told()
    if status is None:
        last = bench.recording.latest(topic)
        words = (
            "no status" if last is None else f"{last.state}, goal {last.goal_id!r}, at_rest {last.at_rest}"
        )
        raise Broken(f"the end of a goal of {motion.group.name}, at rest, within {within:.1f} s", words)
    return status


def go(bench: Bench, motion: Motion) -> Generator[None, None, None]:
    """Carry the motion out; Broken unless it succeeds where it should."""
    goal = yield from start(bench, motion)
    status = yield from ended(bench, motion, goal, motion.takes + goal.goal_time + TELLING)
    if status.state is not MotionState.SUCCEEDED:
        raise Broken(
            f"a motion of {motion.group.name} SUCCEEDED",
            f"{status.state}: {status.joint} off by {status.error:.3f}",
        )
    yield from bench.pause(0.1)
    joint, off = farthest(motion.group.limits, motion.end, standing(bench, motion.group))
    if off > goal.goal_tolerance:
        raise Broken(f"{joint} within {goal.goal_tolerance:g} of its goal", f"{off:.4f} off")


def farthest(limits: Sequence[JointLimit], a: Sequence[float], b: Sequence[float]) -> tuple[str, float]:
    """Return the joint that is farthest apart in both, and by how much (rad or m)."""
    gaps = [(abs(x - y), limit.joint) for limit, x, y in zip(limits, a, b, strict=True)]
    off, joint = max(gaps)
    return joint, off


def cancel(bench: Bench, group: JointGroup, goal_id: str) -> Generator[None, None, Answer]:
    """Cancel a group's goal."""
    return (yield from bench.ask(keys.group_cancel(group.name), CancelMotion(id=goal_id)))


def fastest(bench: Bench, group: JointGroup) -> float:
    """Return the present speed of a group's fastest joint (rad/s or m/s)."""
    state = bench.recording.latest(keys.JOINT_STATES)
    speeds = {} if state is None else dict(zip(state.names, state.velocities, strict=True))
    return max(abs(speeds.get(joint, 0.0)) for joint in group.joints)
