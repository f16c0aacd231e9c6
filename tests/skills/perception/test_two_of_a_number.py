"""Two tags of one number before the camera, and an item that is moved while it is looked at.

A user would have seen: the robot reaches for the empty place halfway between, surer of it than of either.
Right is two things, or the last place. No test in tests/outside shows it: a scenario may have each tag once,
so the room with two of them is painted here.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

from tandem.skills import site
from tandem.skills.geometry.poses import compose, distance, invert
from tandem.skills.perception.look import Look
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.actions.perception import LookGoal, LookResult
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.skill import Command, Outcome
from tandem.skills.ports.world import WORLD
from tandem.skills.wire.workers import InlineCompute
from tandem.skills.world.keeper import Keeper
from tests.skills.perception.pictures import Face, picture
from tests.skills.perception.stage import DESCRIPTION, Stage
from tests.skills.world.facts import tag

LAB = site.load("lab")
ROBOT = FloorPose(x=-0.55, y=0.5, yaw=0.0)
ONE, OTHER = tag(0.55, 0.40), tag(0.55, 0.60)


def look(where: Callable[[RobotTime], tuple[Pose, ...]]) -> tuple[LookResult, Keeper]:
    """Look in three pictures at what stands there then; give what is told, and a keeper that heard it."""
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        faces = tuple(Face(29, compose(invert(camera_in_map), pose), 0.048) for pose in where(now))
        return picture(faces, rng, samples=4, seconds=now.seconds)

    stage = Stage(painter, ROBOT)
    keeper = Keeper(stage.bus, stage.clocks, LAB, PAIR)
    skill = Look(stage.bus, stage.clocks, DESCRIPTION, LAB, InlineCompute(stage.clocks))
    run = skill.run(LookGoal(item=29, tilts=(-0.35,), pictures=3), "t/look/1")
    stage.step()
    next(run)
    for _ in range(1500):
        stage.step()
        keeper.step()
        try:
            run.send(Command.GO_ON)
        except StopIteration as stop:
            keeper.step()
            outcome: Outcome[LookResult] = stop.value
            break
    else:
        raise AssertionError("the look did not end")
    assert outcome.result is not None
    return outcome.result, keeper


def taken_at() -> list[float]:
    """Return the robot seconds of all pictures that a look paints; the last one is its last."""
    times: list[float] = []

    def note(now: RobotTime) -> tuple[Pose, ...]:
        times.append(now.seconds)
        return (ONE,)

    look(note)
    return times


def test_two_are_told_and_believed_as_two() -> None:
    result, keeper = look(lambda _: (ONE, OTHER))
    told = sorted(result.sightings, key=lambda each: each.tag_in_map.position[1])
    assert len(told) == 2
    assert distance(told[0].tag_in_map, ONE) < 0.005
    assert distance(told[1].tag_in_map, OTHER) < 0.005
    believed = keeper.beliefs.those(29)
    assert sorted(fact.tag_in_map.position[1] for fact in believed) == pytest.approx([0.40, 0.60], abs=0.005)


def test_the_world_tells_both() -> None:
    _, keeper = look(lambda _: (ONE, OTHER))
    now = keeper.clocks.robot()
    assert now is not None
    state = WORLD.model.model_validate_json(keeper.beliefs.state(now).model_dump_json())
    assert len(state.those(29)) == 2
    assert len(state.doubles) == 1


def test_one_that_is_moved_meanwhile_is_where_it_was_last() -> None:
    """By hand, between the second and the third picture; the first ones are of a head that still moves."""
    *_, second, third = list(taken_at())

    result, keeper = look(lambda now: (ONE,) if now.seconds < third - 0.01 else (OTHER,))
    assert result.sightings[0].stamp.seconds >= third - 0.01 > second
    (told,) = result.sightings
    assert distance(told.tag_in_map, OTHER) < 0.005
    (believed,) = keeper.beliefs.those(29)
    assert math.isclose(believed.tag_in_map.position[1], 0.60, abs_tol=0.005)
