"""The survey: from which base poses could the hand do it?"""

from __future__ import annotations

import numpy as np
import pytest

from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm
from tandem.skills.arm.slices import BREATH
from tandem.skills.arm.survey import Survey
from tandem.skills.geometry.poses import from_rpy
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.actions.arm import Candidate, SurveyGoal, SurveyResult
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.skill import Command, Outcome, Slice
from tests.fakes.arm_rig import ArmRig, box, panda

TARGET = Candidate(pose=Pose(position=(0.45, 0.0, 0.4), orientation=from_rpy(np.pi, 0.0, 0.0)))
HERE = FloorPose(x=0.0, y=0.0, yaw=0.0)
FAR = FloorPose(x=-3.0, y=0.0, yaw=0.0)
BESIDE = FloorPose(x=0.45, y=-0.45, yaw=np.pi / 2)


def survey(
    hulls: RobotHulls, goal: SurveyGoal, *, wall: bool = False, cancel_after: int = -1
) -> Outcome[SurveyResult]:
    rig = ArmRig(panda(), "arm", hulls=hulls)
    skill = Survey(rig.bus, rig.clocks, Arm(hulls, panda(), "arm"), PlannerSettings())
    if wall:
        rig.set_scene(box("wall", (0.1, 2.0, 2.0), (0.45, 0.0, 1.0)))
    else:
        rig.set_scene()
    rig.rounds(1)
    run = skill.run(goal, "t/survey/1")
    yielded, slices = next(run), 0
    while True:
        slices += isinstance(yielded, Slice)
        try:
            yielded = run.send(Command.CANCEL if slices == cancel_after else Command.GO_ON)
        except StopIteration as stop:
            outcome: Outcome[SurveyResult] = stop.value
            return outcome


def test_a_base_out_of_reach_is_left_out(hulls: RobotHulls) -> None:
    outcome = survey(hulls, SurveyGoal(bases=(FAR, HERE, BESIDE), candidates=(TARGET,)))
    assert outcome.result == SurveyResult(bases=(1, 2))


def test_it_ends_when_enough_are_found(hulls: RobotHulls) -> None:
    outcome = survey(hulls, SurveyGoal(bases=(HERE, BESIDE), candidates=(TARGET,), enough=1))
    assert outcome.result == SurveyResult(bases=(0,))


def test_what_stands_in_the_way_counts(hulls: RobotHulls) -> None:
    outcome = survey(hulls, SurveyGoal(bases=(HERE, BESIDE), candidates=(TARGET,)), wall=True)
    assert outcome.result == SurveyResult(bases=())


def test_a_cancel_is_obeyed_between_two_slices(hulls: RobotHulls) -> None:
    outcome = survey(hulls, SurveyGoal(bases=(FAR,) * 50, candidates=(TARGET,)), cancel_after=2)
    assert outcome.canceled


def test_a_cancel_is_obeyed_as_soon_as_a_checker_is_made(hulls: RobotHulls) -> None:
    rig = ArmRig(panda(), "arm", hulls=hulls)
    skill = Survey(rig.bus, rig.clocks, Arm(hulls, panda(), "arm"), PlannerSettings())
    rig.set_scene()
    rig.rounds(1)
    run = skill.run(SurveyGoal(bases=(HERE,), candidates=(TARGET,)), "t/survey/1")
    yielded = next(run)
    while not isinstance(yielded, Slice):
        yielded = run.send(Command.GO_ON)
    assert yielded == BREATH
    with pytest.raises(StopIteration) as stop:
        run.send(Command.CANCEL)
    assert stop.value.value.canceled
