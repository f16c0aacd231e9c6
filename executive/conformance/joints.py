"""Clauses about joint states, and about all messages as documents."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Final

from pydantic import ValidationError

from tandem.executive.conformance.clause import Broken, Clause, Steps
from tandem.executive.conformance.clocks import JITTER, LOST
from tandem.executive.conformance.recording import topics
from tandem.skills.ports import keys
from tandem.skills.ports.checks import misfit, too_large
from tandem.skills.ports.problems import in_words, problems_of

if TYPE_CHECKING:
    from tandem.executive.conformance.bench import Bench
    from tandem.skills.ports.hardware import JointStates

MOVING: Final = 0.05
"""rad/s or m/s of a joint that moves for certain: noise and creeping are below."""
BEYOND: Final = 0.01
"""rad or m that a joint may stand beyond its limit: encoders are noisy, and end stops give way."""


def _readable(bench: Bench) -> Steps:
    robot = bench.robot
    for topic in topics(robot):
        for told in bench.recording.told(topic.key):
            try:
                message = topic.decode(told.payload)
            except ValidationError as error:
                wrong = in_words(problems_of(error, most=1))
                raise Broken(f"a valid {topic.model.__name__} on {topic.key}", wrong) from error
            if too_large(message):
                raise Broken(f"numbers that a robot may have on {topic.key}", "one that is too large")
            if topic.key != keys.JOINT_STATES.key and (wrong := misfit(message, topic.key, robot)):
                raise Broken(f"a message on {topic.key} that fits the description", wrong)
    yield


def _states(bench: Bench) -> list[JointStates]:
    states = bench.recording.messages(keys.JOINT_STATES)
    if not states:
        raise Broken(f"joint states on {keys.JOINT_STATES.key}", "none")
    return states


def _complete(bench: Bench) -> Steps:
    for state in _states(bench):
        if wrong := misfit(state, keys.JOINT_STATES.key, bench.robot):
            raise Broken("each joint of groups and grippers once, and no other", wrong)
    yield


def _within_limits(bench: Bench) -> Steps:
    limits = {limit.joint: limit for group in bench.robot.groups for limit in group.limits}
    for state in _states(bench):
        for joint, position in zip(state.names, state.positions, strict=True):
            limit = limits.get(joint)
            if limit is not None and not limit.lower - BEYOND <= position <= limit.upper + BEYOND:
                raise Broken(f"{joint} from {limit.lower:g} to {limit.upper:g}", f"{position:.4f}")
    yield


def _at_the_period(bench: Bench) -> Steps:
    robot, states = bench.robot, _states(bench)
    moving, all_steps = [], []
    for before, after in pairwise(states):
        step = after.stamp.since(before.stamp)
        if step is None:
            continue
        if step <= 0.0:
            raise Broken("stamps of joint states that rise", "one that does not")
        all_steps.append(step)
        if _moves(before) and _moves(after):
            moving.append(step)
    resting = robot.resting_period or robot.period
    _judge_steps(all_steps, (robot.period, max(robot.period, resting)), "")
    if moving:
        _judge_steps(moving, (robot.period, robot.period), " while joints move")
    yield


def _moves(state: JointStates) -> bool:
    return any(abs(speed) > MOVING for speed in state.velocities)


def _judge_steps(steps: list[float], periods: tuple[float, float], when: str) -> None:
    mean, (least, most) = sum(steps) / max(1, len(steps)), periods
    if not steps or not (1.0 - JITTER) * least <= mean <= (1.0 + JITTER) / (1.0 - LOST) * most:
        raise Broken(f"joint states every {most:g} s{when}", f"{len(steps)} steps, {mean:.4f} s in the mean")


CLAUSES: Final = (
    Clause(
        "messages_readable",
        "Each message is a valid document that fits its key and the description.",
        "endpoints.md",
        _readable,
    ),
    Clause(
        "joint_states_complete",
        "Joint states hold all joints of groups and grippers, each once, and no others.",
        "interface.md#jointstates",
        _complete,
    ),
    Clause(
        "joint_positions_within_limits",
        "Joints stand within their limits.",
        "interface.md#jointlimit",
        _within_limits,
    ),
    Clause(
        "joint_states_period",
        "Joint states come once a period (resting: a resting period at least), with stamps that rise.",
        "interface.md#robotdescription",
        _at_the_period,
    ),
)
