"""Finding the robot anywhere on the floor."""

import math

import numpy as np
import pytest

from tandem.skills.base.map import build_map
from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.actions.base import LocaliseGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import SiteBox
from tandem.skills.ports.skill import Command
from tandem.skills.site import load
from tests.fakes.base_rig import make_rig
from tests.fakes.planar_robot import describe

LAB = load("lab")
MAP = build_map(LAB, describe())


def somewhere(seed: int) -> FloorPose:
    rng = np.random.default_rng(seed)
    while True:
        x, y = rng.uniform(-3.0, 3.0, 2)
        if MAP.plan.at_point(x, y) > 0.3:
            return FloorPose(x=x, y=y, yaw=rng.uniform(-math.pi, math.pi))


@pytest.mark.parametrize("seed", range(20))
def test_it_is_found_wherever_it_stands_among_things_that_no_map_knows(seed: int) -> None:
    start = somewhere(seed)
    rig = make_rig(LAB, start, seed=seed, localised=False)
    rng = np.random.default_rng(seed + 100)
    for _ in range(3):
        x, y = rng.uniform(-2.5, 2.5, 2)
        if math.hypot(x - start.x, y - start.y) > 0.6:
            rig.robot.boxes.append(SiteBox(size=(0.35, 0.3, 0.5), centre=(x, y, 0.25), yaw=rng.uniform(0, 3)))
    outcome = rig.run(rig.base.localise.run(LocaliseGoal(), "g"))
    assert outcome.result is not None, outcome.failure
    found = outcome.result.base_in_map
    assert floor_distance(found, start) < 0.02
    assert abs(wrap(found.yaw - start.yaw)) < math.radians(0.5)
    assert rig.base.localiser.localised


def test_in_a_corner_like_another_it_turns_to_see_more() -> None:
    start = FloorPose(x=-2.535, y=2.524, yaw=2.16)
    rig = make_rig(LAB, start, localised=False)
    outcome = rig.run(rig.base.localise.run(LocaliseGoal(), "g"))
    assert outcome.result is not None, outcome.failure
    assert floor_distance(outcome.result.base_in_map, rig.robot.truth) < 0.02
    assert abs(wrap(rig.robot.truth.yaw - start.yaw)) > 1.5


def test_it_does_not_turn_with_an_arm_stretched_out() -> None:
    rig = make_rig(LAB, FloorPose(x=-2.535, y=2.524, yaw=2.16), localised=False)
    rig.extent = 0.9
    outcome = rig.run(rig.base.localise.run(LocaliseGoal(), "g"))
    assert outcome.failure is not None
    assert "alike" in outcome.failure.message
    assert rig.robot.truth.yaw == 2.16


def test_a_hint_is_enough_and_quicker() -> None:
    start = somewhere(5)
    rig = make_rig(LAB, start, localised=False)
    hint = FloorPose(x=start.x + 0.3, y=start.y - 0.3, yaw=start.yaw + 0.3)
    outcome = rig.run(rig.base.localise.run(LocaliseGoal(hint=hint), "g"))
    assert outcome.result is not None
    assert floor_distance(outcome.result.base_in_map, start) < 0.02


def test_a_hint_off_the_floor_is_refused() -> None:
    rig = make_rig(LAB, somewhere(1), localised=False)
    refusal = rig.base.localise.check(LocaliseGoal(hint=FloorPose(x=9.0, y=0.0, yaw=0.0)))
    assert refusal is not None
    assert refusal.kind is FailureKind.INVALID_GOAL


def test_without_scans_it_says_so() -> None:
    rig = make_rig(LAB, somewhere(1), localised=False)
    rig.robot.laser_on = False
    outcome = rig.run(rig.base.localise.run(LocaliseGoal(), "g"))
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.LASER_SILENT


def test_in_another_room_it_does_not_claim_a_place() -> None:
    rig = make_rig(LAB, FloorPose(x=0.0, y=-1.5, yaw=0.0), localised=False)
    rig.robot.boxes[:] = [SiteBox(size=(0.1, 9.0, 1.0), centre=(-1.2 + k, 0.0, 0.5), yaw=0.5) for k in (0, 2)]
    outcome = rig.run(rig.base.localise.run(LocaliseGoal(), "g"))
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.NOT_LOCALISED
    assert not rig.base.localiser.localised


def test_cancelled_in_the_search_it_ends_at_once() -> None:
    rig = make_rig(LAB, somewhere(1), localised=False)
    outcome = rig.run(
        rig.base.localise.run(LocaliseGoal(), "g"), lambda t: Command.CANCEL if t > 0.3 else Command.GO_ON
    )
    assert outcome.canceled


@pytest.mark.parametrize("at", [0.05, 0.4])
def test_paused_it_stands_and_resumed_it_ends_well(at: float) -> None:
    start = FloorPose(x=-2.535, y=2.524, yaw=2.16)
    rig = make_rig(LAB, start, localised=False)
    script = [(at, Command.PAUSE), (6.0, Command.RESUME)]
    stood = []

    def command(seconds: float) -> Command:
        if 4.0 < seconds < 6.0:
            stood.append((rig.robot.angular, rig.base.localiser.localised))
        return script.pop(0)[1] if script and seconds > script[0][0] else Command.GO_ON

    outcome = rig.run(rig.base.localise.run(LocaliseGoal(), "g"), command)
    assert outcome.result is not None, outcome.failure
    assert set(stood) == {(0.0, False)}
