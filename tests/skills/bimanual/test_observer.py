"""What the coordination sees of one arm, of what joints and approaches tell."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tandem.skills.bimanual.coordination import ArmNow
from tandem.skills.bimanual.observer import EVERY, SILENT_AFTER, WAITS_AFTER, ArmObserver
from tandem.skills.ports.actions.approach import ApproachPhase, ApproachStatus, approach_status
from tandem.skills.ports.message import RobotTime
from tandem.skills.wire.memory import MemoryBus
from tests.skills.reflex.two_arms import ASIDE, IN_FRONT, joint_states, positions, robot

Phase = ApproachPhase


class Watched:
    """One arm that is told of, and looked at."""

    def __init__(self) -> None:
        self.bus = MemoryBus()
        description, _ = robot()
        assert description.arms_crossing is not None
        self.observer = ArmObserver(self.bus, description, description.arms_crossing, "left")

    def approaches(
        self, seconds: float, phase: Phase = Phase.FIELD, *, active: bool = True, end: tuple[float, ...] = ()
    ) -> None:
        status = ApproachStatus(
            stamp=RobotTime(boot="test", seconds=seconds),
            side="left",
            active=active,
            phase=phase,
            distance=0.4,
            recorded=7,
            at=6,
            goal_positions=end,
        )
        approach_status("arm_left").publish(self.bus, status)

    def look(self, seconds: float, at: tuple[float, ...] | None = None, speed: float = 0.0) -> ArmNow:
        return self.observer.look(joint_states(seconds, positions(left=at), {"arm_left_3_joint": speed}))


@pytest.fixture
def arm() -> Watched:
    return Watched()


def test_an_arm_at_home_is_safe_and_does_nothing(arm: Watched) -> None:
    seen = arm.look(1.0)
    assert (seen.safe, seen.under_way, seen.back_home) == (True, False, True)


def test_an_arm_that_is_out_is_not_safe_whether_it_moves_or_not(arm: Watched) -> None:
    assert not arm.look(1.0, IN_FRONT).safe
    assert arm.look(1.1, IN_FRONT, speed=0.5).under_way


def test_an_arm_that_stands_for_long_without_a_field_waits(arm: Watched) -> None:
    told = []
    for seconds in np.arange(0.0, 2.0 * WAITS_AFTER, 0.1):
        arm.look(float(seconds), IN_FRONT, speed=0.5 if seconds < WAITS_AFTER / 2 else 0.0)
        told.append(arm.observer.waits)
    assert (told[0], told[-1], told.index(True)) == (False, True, pytest.approx(15 * WAITS_AFTER, abs=1))
    arm.approaches(2.0 * WAITS_AFTER)
    arm.look(2.0 * WAITS_AFTER, IN_FRONT)
    assert not arm.observer.waits


def test_an_approach_tells_how_far_it_is(arm: Watched) -> None:
    arm.approaches(1.0)
    seen = arm.look(1.0, IN_FRONT)
    assert (seen.approaching, seen.distance, seen.recorded, seen.at) == (True, 0.4, 7, 6)


@pytest.mark.parametrize(
    ("tell", "at"),
    [
        (lambda arm: arm.approaches(1.0, active=False), 1.0),
        (lambda arm: arm.approaches(1.0), 1.0 + SILENT_AFTER),
        (lambda _: None, 1.0),
    ],
    ids=["ended", "silent", "never told"],
)
def test_what_does_not_tell_is_no_approach(arm: Watched, tell: Callable[[Watched], None], at: float) -> None:
    tell(arm)
    assert not arm.look(at, IN_FRONT).approaching


def test_an_arm_that_is_told_to_go_back_moves_already_though_its_joints_do_not(arm: Watched) -> None:
    arm.approaches(1.0, Phase.BACK)
    assert arm.look(1.0, IN_FRONT).moving


def test_what_lies_before_it_after_it_went_back_is_the_rest_of_its_record(arm: Watched) -> None:
    shares = (0.0, 0.25, 0.5, 0.75, 1.0)
    way = [tuple(np.array(ASIDE) + s * (np.array(IN_FRONT) - np.array(ASIDE))) for s in shares]
    for k, q in enumerate(way):
        arm.approaches(k * EVERY)
        arm.look(k * EVERY, q, speed=0.5)
    arm.approaches(1.0, Phase.BACK)
    arm.look(1.0, way[1], speed=0.5)
    assert np.allclose(arm.observer.ahead(), way[2:])


def test_the_record_of_an_approach_that_has_ended_is_forgotten(arm: Watched) -> None:
    arm.approaches(0.0)
    arm.look(0.0, ASIDE)
    arm.approaches(0.1, active=False)
    arm.look(0.1, ASIDE)
    assert arm.observer.ahead() == []


def test_where_an_approach_ends_is_remembered_until_the_arm_is_back(arm: Watched) -> None:
    """Then the grasp and the way out lie before it."""
    assert arm.observer.goal_at is None
    arm.approaches(0.0, end=IN_FRONT)
    arm.look(0.0, ASIDE)
    arm.approaches(0.1, active=False)
    arm.look(0.1, IN_FRONT)
    assert arm.observer.goal_at is not None
    assert arm.observer.goal_at == pytest.approx(IN_FRONT)
    arm.look(0.2)
    assert arm.observer.goal_at is None
