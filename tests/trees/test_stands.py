"""Stands of the base, before item and slot."""

from __future__ import annotations

from py_trees.common import Status

from tandem.executive.trials.exploration.tree_bench import TreeBench
from tandem.skills.geometry.poses import floor_distance, from_axes, wrap
from tandem.skills.ports.actions.arm import SurveyGoal
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.site import load
from tandem.trees.conditions.at_pose import POSITION_TOLERANCE, YAW_TOLERANCE
from tandem.trees.leaves.survey import SAME_STAND, SAME_YAW

TAG = Pose(position=(0.9, 0.1, 0.74), orientation=from_axes((1, 0, 0), (0, 0, 1), (0, -1, 0)))


def test_where_the_base_need_not_be_driven_again_is_no_other_stand() -> None:
    """Else a stand tried in vain is offered again as one 5 cm away, and the base is said to be there."""
    assert SAME_STAND >= POSITION_TOLERANCE
    assert SAME_YAW >= YAW_TOLERANCE


def test_beside_where_the_robot_stands_no_other_stand_is_asked_for() -> None:
    """The base would be said to be there, and the arm would try from where it does not reach."""
    bench = TreeBench(load("lab"), items={29: TAG})
    assert bench.run("fetch", {"item": 29}) is Status.SUCCESS
    goals = [goal for _, goal in bench.robot.calls if isinstance(goal, SurveyGoal)]
    from_here = [goal.bases for goal in goals if goal.enough == 1]
    assert from_here
    assert not any(_one_stand(here, each) for here, *others in from_here for each in others)


def _one_stand(one: FloorPose, other: FloorPose) -> bool:
    return floor_distance(one, other) < POSITION_TOLERANCE and abs(wrap(one.yaw - other.yaw)) < YAW_TOLERANCE
