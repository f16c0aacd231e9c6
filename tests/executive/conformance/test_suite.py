"""The simulated robots keep the hardware's contract, and each clause finds a driver that does not."""

from __future__ import annotations

import pytest

from tandem.executive.conformance.clause import State
from tandem.executive.conformance.suite import SUITE, clause
from tandem.skills.ports import keys
from tests.executive.conformance.stands import stand
from tests.executive.conformance.wrong_drivers import WRONG, Answering, Telling, one_finger

LISTENING = frozenset(each.name for each in SUITE if not each.moving and not each.interrupts)


@pytest.mark.lockstep
@pytest.mark.parametrize(
    ("scenario", "lacks"),
    [
        ("Demo", {"cliffs_fit"}),
        (
            "Bench",
            {"laser_fits", "cliffs_fit", "odometry_continuous", "velocity_obeyed", "velocity_dead_man"},
        ),
        ("NoArms", {"cliffs_fit", "gripper_state_told", "gripper_moves"}),
        (
            "RocsP3dx",
            {
                "laser_fits",
                "cliffs_fit",
                "camera_fits",
                "group_status_told",
                "gripper_state_told",
                "unreadable_answered",
            }
            | {"stop_refuses", "trajectory_reaches", "cancel_rests", "bad_start_refused"}
            | {"beyond_limits_refused", "setpoints_hold", "gripper_moves"},
        ),
    ],
)
def test_a_simulated_robot_keeps_every_clause(scenario: str, lacks: set[str]) -> None:
    with stand(scenario) as robot:
        found = robot.check(SUITE)
    assert [each for each in found if each.state is State.FAILED] == []
    assert {each.clause.name for each in found if each.state is State.SKIPPED} == lacks


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_driver_fails_its_clause(name: str) -> None:
    scenario, driver = WRONG[name]
    with stand(scenario, driver()) as robot:
        (found,) = robot.check([clause(name)])
    assert found.state is State.FAILED, found
    assert found.expected
    assert found.found


def test_a_base_that_obeys_without_a_lease_is_found_though_it_answers_nothing() -> None:
    driver = Telling(keys.LEASES.key, lambda table: table | {"refused": 0})
    with stand("RocsP3dx", driver) as robot:
        (found,) = robot.check([clause("no_lease_refused")])
    assert found.state is State.FAILED, found


def test_a_hand_with_one_finger_is_found() -> None:
    with stand("Bench", Answering(keys.DESCRIPTION.key, one_finger)) as robot:
        (found,) = robot.check([clause("urdf_holds_parts")])
    assert found.state is State.FAILED, found
    assert found.expected == "hands with two fingers that slide"


def test_each_clause_has_a_wrong_driver() -> None:
    assert list(WRONG) == [each.name for each in SUITE]


def test_each_clause_has_its_own_name() -> None:
    assert len({each.name for each in SUITE}) == len(SUITE)


def test_what_stands_still_is_tried_before_what_moves() -> None:
    moving = [each.moving for each in SUITE]
    assert moving == sorted(moving)


def test_a_robot_without_a_description_has_one_failure_and_no_guesses() -> None:
    scenario, driver = WRONG["description_served"]
    with stand(scenario, driver()) as robot:
        found = robot.check([each for each in SUITE if each.name in LISTENING][:4])
    assert [each.state for each in found] == [State.FAILED, *[State.SKIPPED] * 3]
    assert found[1].why == "the description is not known"
