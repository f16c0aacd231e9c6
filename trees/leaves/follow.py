"""Follow another robot."""

from __future__ import annotations

from tandem.skills.ports.actions.base import FOLLOW, FollowFeedback, FollowGoal, FollowResult, FollowSource
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext
from tandem.trees.pursuit import Pursuit

Follow = Act[FollowGoal, FollowFeedback, FollowResult]


def follow(
    name: str, context: TreeContext, pursuit: Pursuit, robot: str, distance: float, *, source: FollowSource
) -> Follow:
    """Return the leaf that follows a robot at so many metres, for the seconds that are left."""

    def goal() -> FollowGoal:
        return FollowGoal(robot=robot, distance=distance, seconds=pursuit.sets_out(), source=source)

    def judge(result: FollowResult) -> Failure | None:
        pursuit.done(result)
        return None

    leaf = Act(name, context, FOLLOW, goal, resources=("base",), judge=judge)
    pursuit.hears = lambda: leaf.feedback
    return leaf
