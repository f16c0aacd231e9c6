"""Turn the head: over the bus in memory, for a base that is still elsewhere."""

from __future__ import annotations

import math

import pytest

from tandem.skills.geometry.poses import compose, invert, to_pose, transform
from tandem.skills.perception.turn_head import TurnHead
from tandem.skills.ports.actions.perception import TurnHeadGoal, TurnHeadResult
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import Command, Outcome
from tests.skills.perception.pictures import picture
from tests.skills.perception.stage import DESCRIPTION, Stage

HERE = FloorPose(x=-2.0, y=1.0, yaw=2.0)
THERE = FloorPose(x=-0.5, y=0.5, yaw=0.1)
GOAL = TurnHeadGoal(at=(0.6, 0.3, 0.7), base=THERE)


def stage(**options: bool | str) -> Stage:
    return Stage(lambda _, now: picture((), None, samples=1, seconds=now.seconds), HERE, **options)  # type: ignore[arg-type]


def turn(stage: Stage, cancel_at: int | None = None) -> Outcome[TurnHeadResult]:
    skill = TurnHead(stage.bus, stage.clocks, DESCRIPTION)
    assert skill.check(GOAL) is None
    run = skill.run(GOAL, "t/turn/1")
    next(run)
    for step in range(600):
        stage.step()
        try:
            run.send(Command.CANCEL if step == cancel_at else Command.GO_ON)
        except StopIteration as ended:
            outcome: Outcome[TurnHeadResult] = ended.value
            return outcome
    raise AssertionError("it did not end")


def test_the_point_is_in_the_middle_once_the_base_is_there() -> None:
    it = stage(localised=False)
    outcome = turn(it)
    assert outcome.result is not None
    assert it.head == pytest.approx(outcome.result.positions, abs=1e-3)
    camera_there = compose(to_pose(THERE), compose(invert(to_pose(HERE)), it.camera_in_map()))
    x, y, z = transform(invert(camera_there), GOAL.at)
    assert math.hypot(x, y) < 0.01 * z
    assert it.painted == []


def test_a_cancel_ends_with_the_head_at_rest() -> None:
    it = stage()
    assert turn(it, cancel_at=20).canceled
    it.step()
    assert it.speed == pytest.approx((0.0, 0.0))


def test_a_refusal_is_told_with_the_place() -> None:
    failure = turn(stage(refuse="no such group")).failure
    assert failure is not None
    assert (failure.kind, failure.where) == (FailureKind.NOT_READY, "perception/turn_head")
