"""Moving clauses about trajectory goals."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.executive.conformance.clause import Broken, Clause, Skip, Steps
from tandem.executive.conformance.harmless import standing
from tandem.executive.conformance.motions import (
    TELLING,
    back,
    cancel,
    ended,
    farthest,
    go,
    goal_of,
    small_motion,
    start,
)
from tandem.skills.ports import keys
from tandem.skills.ports.hardware import MotionState

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.robot_description import JointGroup

STRETCHED: Final = 4.0
"""How many times slower a motion is that is to be interrupted."""
CREEP: Final = 0.01
"""rad or m that a group may settle by after it has told that it rests."""
AWAY: Final = 0.06
"""rad or m between a bad start and where the joint stands."""
BEYOND: Final = 0.1
"""rad or m by which a bad goal lies beyond a limit."""


def groups_of(bench: Bench) -> tuple[JointGroup, ...]:
    """Return the robot's groups; Skip when it has none."""
    if not bench.robot.groups:
        raise Skip("the robot has no joint groups")
    return bench.robot.groups


def _reaches(bench: Bench) -> Steps:
    for group in groups_of(bench):
        motion = small_motion(bench, group)
        yield from go(bench, motion)
        yield from go(bench, back(bench, motion))


def _cancelled(bench: Bench) -> Steps:
    for group in groups_of(bench):
        motion = small_motion(bench, group)
        long = motion.takes * STRETCHED
        goal = yield from start(bench, motion, long)
        yield from bench.pause(long / 3.0)
        yield from cancel(bench, group, goal.id)
        status = yield from ended(bench, motion, goal, 2.0 * TELLING)
        if status.state is not MotionState.CANCELED:
            raise Broken(f"a cancelled goal of {group.name} CANCELED", f"{status.state}")
        stood = standing(bench, group)
        yield from bench.pause(TELLING)
        joint, moved = farthest(group.limits, stood, standing(bench, group))
        if moved > CREEP:
            raise Broken(f"{group.name} at rest after a cancel", f"{joint} moved by {moved:.4f}")
        yield from go(bench, back(bench, motion))


def _bad_start(bench: Bench) -> Steps:
    for group in groups_of(bench):
        at = standing(bench, group)
        off = tuple(
            position + (AWAY if position < (limit.lower + limit.upper) / 2.0 else -AWAY)
            for position, limit in zip(at, group.limits, strict=True)
        )
        # The tolerance is small, and the end is the start: if it is obeyed, little happens.
        goal = yield from goal_of(bench, ((0.0, off), (2.0, off)), path_tolerance=AWAY / 3.0)
        answer = yield from bench.ask(keys.group_goal(group.name), goal)
        if answer.accepted:
            yield from cancel(bench, group, goal.id)
            raise Broken(f"a goal of {group.name} that starts {AWAY:g} away refused", "accepted")


def _beyond_limits(bench: Bench) -> Steps:
    for group in groups_of(bench):
        at = standing(bench, group)
        limit = group.limits[0]
        end = (limit.upper + BEYOND, *at[1:])
        # So slow that it has hardly begun when it is cancelled.
        seconds = max(20.0, 4.0 * abs(end[0] - at[0]) / limit.velocity)
        goal = yield from goal_of(bench, ((0.0, at), (seconds, end)))
        answer = yield from bench.ask(keys.group_goal(group.name), goal)
        if answer.accepted:
            yield from cancel(bench, group, goal.id)
            raise Broken(f"a goal with {limit.joint} beyond {limit.upper:g} refused", "accepted")


_WHERE: Final = "interface.md#trajectorygoal"
CLAUSES: Final = (
    Clause(
        "trajectory_reaches",
        "A trajectory goal of each group ends SUCCEEDED, at rest, within its tolerance.",
        _WHERE,
        _reaches,
        moving=True,
    ),
    Clause(
        "cancel_rests",
        "A cancelled goal ends CANCELED, and the group rests and holds.",
        "interface.md#cancelmotion",
        _cancelled,
        moving=True,
    ),
    Clause(
        "bad_start_refused",
        "A goal that does not start where the group stands is refused.",
        _WHERE,
        _bad_start,
        moving=True,
    ),
    Clause(
        "beyond_limits_refused",
        "A goal beyond a joint's limits is refused.",
        _WHERE,
        _beyond_limits,
        moving=True,
    ),
)
