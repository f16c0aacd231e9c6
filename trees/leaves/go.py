"""Move the base to a place: straight ahead, or along a planned way where a laser shows what is in it."""

from __future__ import annotations

import math
from typing import Final, cast

from tandem.skills.ports.actions.base import (
    DRIVE,
    GO,
    DriveFeedback,
    DriveGoal,
    DriveResult,
    GoFeedback,
    GoGoal,
    GoResult,
)
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.skill import ActionType
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext
from tandem.trees.course import Course

WITHIN: Final = 0.7
"""Share of the tolerance that the goal keeps: at its end, noise must not put the robot outside."""
_Goal = GoGoal | DriveGoal
_Feedback = GoFeedback | DriveFeedback
_Result = GoResult | DriveResult
Go = Act[_Goal, _Feedback, _Result]


def straight(context: TreeContext) -> bool:
    """Say whether the base goes straight: where a sensor tells its pose, ways are not planned by a laser."""
    robot = context.knowledge.description
    return robot is not None and bool(robot.pose_sensors)


def go(name: str, context: TreeContext, course: Course) -> Go:
    """Return the leaf that goes to the course's target."""

    def action() -> ActionType[_Goal, _Feedback, _Result]:
        return cast("ActionType[_Goal, _Feedback, _Result]", GO if straight(context) else DRIVE)

    def goal() -> _Goal | Failure:
        robot, to = context.knowledge.robot, course.target
        if robot is None or not robot.localised:
            return Failure(kind=FailureKind.NOT_LOCALISED, message="it is not known where the robot is")
        course.sets_out()
        near = WITHIN * to.tolerance
        if straight(context):
            return GoGoal(x=to.x, y=to.y, yaw=to.yaw, position_tolerance=near)
        at = robot.base_in_map
        yaw = math.atan2(to.y - at.y, to.x - at.x) if to.yaw is None else to.yaw
        return DriveGoal(poses=(FloorPose(x=to.x, y=to.y, yaw=yaw),), position_tolerance=near)

    return Act(name, context, action, goal, resources=("base",), believed=lambda _: course.there())
