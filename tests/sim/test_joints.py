"""A group's controller, without physics: a plant that follows perfectly, or not at all."""

from __future__ import annotations

import numpy as np
import pytest

from tandem.sim.joints import GroupController
from tandem.skills.ports.hardware import MotionState, SetPoint, TrajectoryGoal, TrajectoryPoint
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.robot_description import JointGroup, JointLimit

PERIOD = 0.01
LIMIT = {"lower": -2.0, "upper": 2.0, "velocity": 2.0, "acceleration": 5.0, "jerk": 50.0, "effort": 10.0}
GROUP = JointGroup(name="arm", limits=tuple(JointLimit(joint=f"j{i}", **LIMIT) for i in (1, 2)))


def goal(end: float = 1.0, seconds: float = 1.0, name: str = "g", start: float = 0.0) -> TrajectoryGoal:
    points = (
        TrajectoryPoint(time=0.0, positions=(start, 0.0), velocities=(0.0, 0.0)),
        TrajectoryPoint(time=seconds, positions=(end, 0.0), velocities=(0.0, 0.0)),
    )
    return TrajectoryGoal(id=name, points=points, path_tolerance=0.1, goal_tolerance=0.01, goal_time=0.2)


class Plant:
    """Goes where the reference goes, but for joints that are stuck."""

    def __init__(self) -> None:
        self.controller = GroupController(GROUP, (0.0, 0.0))
        self.position = np.zeros(2)
        self.stuck: tuple[int, ...] = ()
        self.speeds: list[float] = []

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / PERIOD)):
            before = self.position.copy()
            velocity = (self.position - before) / PERIOD
            self.controller.advance(PERIOD, self.position, velocity)
            for i in range(2):
                if i not in self.stuck:
                    self.position[i] = self.controller.position[i]
            self.speeds.append(float((self.position - before)[0] / PERIOD))


def setpoint(position: float) -> SetPoint:
    return SetPoint(stamp=RobotTime(boot="b", seconds=0.0), positions=(position, 0.0), velocities=(0.0, 0.0))


def test_a_goal_is_followed_along_its_cubic_and_succeeds() -> None:
    plant = Plant()
    assert plant.controller.accept(goal()).accepted
    plant.run(0.5)
    assert plant.position[0] == pytest.approx(0.5)  # a cubic is halfway at half time
    plant.run(0.6)
    report = plant.controller.report
    assert (report.state, report.at_rest) == (MotionState.SUCCEEDED, True)
    assert plant.position[0] == pytest.approx(1.0)


def test_a_joint_that_is_stuck_is_named_when_the_goal_aborts() -> None:
    plant = Plant()
    plant.stuck = (0,)
    plant.controller.accept(goal())
    plant.run(1.0)
    report = plant.controller.report
    assert (report.state, report.joint) == (MotionState.ABORTED, "j1")
    assert 0.1 < report.error < 0.2


def test_a_cancelled_goal_brakes_on_its_path_within_the_acceleration() -> None:
    plant = Plant()
    plant.controller.accept(goal())
    plant.run(0.5)
    assert plant.controller.cancel("g").accepted
    plant.run(1.0)
    assert plant.controller.report.state is MotionState.CANCELED
    assert plant.controller.report.at_rest
    assert plant.position[0] < 0.9
    braking = np.diff(plant.speeds[49:]) / PERIOD
    assert braking.min() > -5.0 * 1.3


@pytest.mark.parametrize(
    ("bad", "words"),
    [
        (goal(end=2.5), "j1: 2.5000 is outside -2.0000 to 2.0000"),
        (goal(seconds=0.1), "too fast"),
        (goal(start=0.5), "j1 stands 0.5000 away"),
    ],
)
def test_a_goal_that_cannot_be_is_refused_with_what_is_wrong(bad: TrajectoryGoal, words: str) -> None:
    answer = Plant().controller.accept(bad)
    assert not answer.accepted
    assert words in answer.reason


def test_the_same_goal_sent_twice_starts_once() -> None:
    plant = Plant()
    plant.controller.accept(goal())
    plant.run(0.5)
    assert plant.controller.accept(goal()).accepted
    plant.run(0.1)
    assert plant.position[0] > 0.5


def test_another_goal_waits_for_rest() -> None:
    plant = Plant()
    plant.controller.accept(goal())
    plant.run(0.5)
    assert "is moving" in plant.controller.accept(goal(name="h")).reason


def test_a_stop_aborts_the_goal() -> None:
    plant = Plant()
    plant.controller.accept(goal())
    plant.run(0.5)
    plant.controller.stop()
    plant.run(1.0)
    assert plant.controller.report.state is MotionState.ABORTED
    assert plant.speeds[-1] == 0.0


@pytest.mark.parametrize(("stuck", "off"), [((0,), 0.0), ((), None)], ids=["held fast", "free"])
def test_what_is_held_fast_is_not_pushed_on_when_its_motion_ends(
    stuck: tuple[int, ...], off: float | None
) -> None:
    plant = Plant()
    plant.controller.accept(goal(end=0.08))
    plant.run(0.7)
    plant.stuck = stuck
    plant.position[0] -= 0.04 if stuck else 0.0
    before = plant.position[0]
    plant.controller.cancel("g")
    plant.run(1.0)
    assert plant.controller.report.at_rest
    if off is not None:
        assert plant.controller.position[0] == pytest.approx(before)
    else:
        assert plant.controller.position[0] > before, "it brakes along its path"


def test_what_brakes_against_an_obstacle_after_it_strayed_is_not_pushed_on() -> None:
    plant = Plant()
    plant.controller.accept(goal())
    plant.run(0.5)
    plant.stuck, plant.position[0] = (0,), plant.position[0] - 0.11
    held_at = plant.position[0]
    plant.controller.advance(PERIOD, plant.position, np.array([1.5, 0.0]))
    assert plant.controller.report.state is MotionState.ABORTED
    plant.run(1.0)
    assert plant.controller.report.at_rest
    assert plant.controller.position[0] == pytest.approx(held_at), "and not 0.2 further, where it would brake"


def test_when_one_joint_strays_the_others_are_held_where_they_are_at_once() -> None:
    plant = Plant()
    points = (
        TrajectoryPoint(time=0.0, positions=(0.0, 0.0), velocities=(0.0, 0.0)),
        TrajectoryPoint(time=1.0, positions=(1.0, 1.0), velocities=(0.0, 0.0)),
    )
    plant.controller.accept(TrajectoryGoal(id="g", points=points, path_tolerance=0.1))
    plant.run(0.5)
    plant.stuck, stood = (0,), plant.position[0]
    for _ in range(30):
        plant.controller.advance(PERIOD, plant.position, np.array([0.0, 1.5]))
        if plant.controller.report.state is MotionState.ABORTED:
            break
        plant.position[1] = plant.controller.position[1]
    assert plant.controller.report.state is MotionState.ABORTED
    assert plant.controller.position == pytest.approx([stood, plant.position[1]])
    assert not plant.controller.velocity.any()


def test_a_stream_is_followed_and_held_when_it_dries_up() -> None:
    plant = Plant()
    for _ in range(30):
        assert plant.controller.stream(setpoint(0.5))
        plant.run(0.05)
    assert plant.position[0] == pytest.approx(0.5, abs=0.005)
    plant.controller.stream(setpoint(2.0))
    plant.run(1.5)
    assert plant.speeds[-1] == 0.0
    assert plant.position[0] < 1.0
    assert max(np.abs(np.diff(plant.speeds))) / PERIOD <= 5.0 + 1e-6


def test_a_group_stands_on_its_path_while_its_keeper_is_silent_and_goes_on_with_it() -> None:
    plant = Plant()
    plant.controller.accept(goal().model_copy(update={"keeper": "skill/x"}))
    plant.run(0.4)
    plant.controller.keep(awake=False, gone=False)
    plant.run(0.5)
    stood = plant.position[0]
    plant.run(1.0)
    assert plant.position[0] == stood < 0.9
    assert plant.controller.report.state is MotionState.ACTIVE
    plant.controller.keep(awake=True, gone=False)
    plant.run(1.2)
    report = plant.controller.report
    assert report.state is MotionState.SUCCEEDED
    assert plant.position[0] == pytest.approx(1.0)
    assert 1.2 < report.held < 1.8  # by so much it came later than planned
    accelerations = np.diff(plant.speeds) / PERIOD
    assert np.abs(accelerations[2:]).max() < 6.0 * 1.3  # the cubic's own, and the braking along it


def test_a_keeper_that_is_gone_for_good_ends_the_goal() -> None:
    plant = Plant()
    plant.controller.accept(goal().model_copy(update={"keeper": "skill/x"}))
    plant.run(0.4)
    plant.controller.keep(awake=False, gone=True)
    plant.run(1.0)
    assert plant.controller.report.state is MotionState.ABORTED
    assert plant.controller.report.at_rest
