"""The record, the progress, velocities, set-points and surroundings of an approach, each alone."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.field.live import AHEAD, Live
from tandem.skills.arm.field.progress import WINDOW, Progress
from tandem.skills.arm.field.record import Record
from tandem.skills.arm.field.reference import State, Stepper, standing
from tandem.skills.arm.field.velocities import Dampers, VelocitySolver
from tandem.skills.arm.problem import Arm
from tandem.skills.arm.trajectory import MotionLimits
from tandem.skills.kinematics.model import Limits
from tandem.skills.ports.keys import JOINT_STATES
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tests.skills.reflex.two_arms import joint_states, positions, robot

LIMITS = MotionLimits(np.full(2, 2.0), np.full(2, 5.0), np.full(2, 50.0))
RANGE = Limits(np.full(2, -1.0), np.full(2, 1.0), np.full(2, 2.0))
JACOBIAN = np.eye(6)[:, :2]
NOTHING = Dampers(np.zeros((0, 2)), np.zeros(0), np.zeros(0))


def recorded(steps: int) -> Record:
    """Return a record of a joint that turned by 0.01 rad in each 10 ms, thinned to 0.1 s."""
    record = Record(phi=0.1)
    for k in range(steps + 1):
        record.add(np.array([0.01 * k, 0.0]), 0.01)
    return record


def test_a_record_is_thinned_by_phi_and_begins_at_the_start() -> None:
    record = recorded(50)
    assert record.samples == 6
    assert [round(float(record.sample(k)[0]), 2) for k in (0, 1, 5)] == [0.0, 0.1, 0.5]


def test_the_way_back_ends_in_the_sample_and_never_before_the_start() -> None:
    record = recorded(50)
    way = record.way_back(np.array([0.5, 0.0]), 2)
    assert way[0][0] == pytest.approx(0.5)
    assert way[-1][0] == pytest.approx(0.2)
    assert (np.diff(way[:, 0]) < 0.0).all()
    assert record.way_back(np.array([0.5, 0.0]), -3)[-1][0] == pytest.approx(0.0)


def test_what_was_gone_back_over_is_forgotten() -> None:
    record = recorded(50)
    record.cut(2)
    assert record.samples == 3
    other = recorded(50)
    other.cut_at(np.array([0.33, 0.0]))
    assert other.samples == 4


def test_no_gain_for_a_window_is_stuck() -> None:
    progress = Progress()
    assert not any(progress.stuck(1.0 - 0.002 * k, 0.0, "") for k in range(200))
    assert [progress.stuck(0.6, 0.0, "") for _ in range(WINDOW)][-1]


def test_set_points_stay_within_speed_acceleration_and_jerk_and_brake_where_it_was_said() -> None:
    stepper, state = Stepper(LIMITS, 0.01), standing(np.zeros(2))
    states = [state]
    for _ in range(40):
        states.append(stepper.to_velocity(states[-1], np.array([2.0, -1.0])))
    where = stepper.braking(states[-1])[-1]
    while not states[-1].still:
        states.append(stepper.brake(states[-1]))
    assert np.allclose(states[-1].q, where, atol=1e-6)
    assert_within(states)


def test_an_arm_that_brakes_stays_on_its_way() -> None:
    """One joint is slow and could stop at once: then the other would go on without it."""
    stepper, state = Stepper(LIMITS, 0.01), standing(np.zeros(2))
    for _ in range(100):
        state = stepper.to_velocity(state, np.array([2.0, -0.3]))
    before = state.q
    for _ in range(200):
        state = stepper.brake(state)
        assert (state.q - before)[1] == pytest.approx(-0.15 * (state.q - before)[0], abs=1e-6)
    assert state.still


def test_a_velocity_turns_into_a_landing_without_a_jerk() -> None:
    stepper, states = Stepper(LIMITS, 0.01), [standing(np.zeros(2))]
    for _ in range(30):
        states.append(stepper.to_velocity(states[-1], np.array([1.5, 0.5])))
    for _ in range(120):
        states.append(stepper.to_place(states[-1], np.array([0.8, 0.1])))
    assert states[-1].still
    assert np.allclose(states[-1].q, (0.8, 0.1))
    assert_within(states)


def assert_within(states: list[State]) -> None:
    v, a = np.array([each.v for each in states]), np.array([each.a for each in states])
    assert np.abs(v).max() <= 2.0 + 1e-6
    assert np.abs(a).max() <= 5.0 + 1e-6
    assert np.abs(np.diff(a, axis=0)).max() / 0.01 <= 50.0 + 1e-3


def test_a_wish_that_nothing_hinders_is_granted() -> None:
    solver = VelocitySolver(RANGE, LIMITS)
    twist = np.array([0.3, -0.2, 0.0, 0.0, 0.0, 0.0])
    found = solver.solve(np.zeros(2), np.zeros(2), JACOBIAN, twist, twist[:2], NOTHING)
    assert np.allclose(found, (0.3, -0.2), atol=1e-6)


def test_a_joint_at_its_limit_does_not_go_on() -> None:
    solver = VelocitySolver(RANGE, LIMITS)
    twist = np.array([1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
    found = solver.solve(np.array([1.0, 0.0]), np.zeros(2), JACOBIAN, twist, twist[:2], NOTHING)
    assert found[0] == pytest.approx(0.0, abs=1e-9)


def test_a_hand_slides_along_what_it_can_not_pass() -> None:
    solver = VelocitySolver(RANGE, LIMITS)
    wall = Dampers(np.array([[-1.0, 0.0]]), np.array([0.01]), np.array([0.01]))  # nearer with the first joint
    twist = np.array([0.3, 0.3, 0.0, 0.0, 0.0, 0.0])
    found = solver.solve(np.zeros(2), np.zeros(2), JACOBIAN, twist, twist[:2], wall)
    assert found[0] <= 1e-3
    assert found[1] > 0.1


@pytest.mark.parametrize("speed", [0.0, 0.5])
def test_another_arm_is_looked_at_where_it_is_about_to_be_and_where_it_may_be_stopped(speed: float) -> None:
    description, hulls = robot()
    bus, clocks = MemoryBus(), SteppedClocks("test")
    live = Live(bus, clocks, Arm(hulls, description, "arm_left"))
    at, joint = positions(), "arm_right_1_joint"
    JOINT_STATES.publish(bus, joint_states(1.0, at, {joint: speed}))
    live.refresh()
    cases = live.cases(live.measured()[0])
    column = hulls.robot.joint_index(joint)
    assert sorted(case[column] - at[joint] for case in cases) == pytest.approx(
        [0.0, AHEAD * speed] if speed else [0.0]
    )
