"""Drive the base to the first of some poses that it can get to."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.base import DRIVE, DriveFeedback, DriveGoal, DriveResult
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.pose import FloorPose
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext

Drive = Act[DriveGoal, DriveFeedback, DriveResult]


def drive(
    name: str,
    context: TreeContext,
    poses: Callable[[], tuple[FloorPose, ...] | Failure],
    *,
    serves: Callable[[], int | None] = lambda: None,
) -> Drive:
    """Return the leaf; ``serves`` says for which item, if any (order-picking paper, III-B)."""

    def goal() -> DriveGoal | Failure:
        found = poses()
        return found if isinstance(found, Failure) else DriveGoal(poses=found, serves_item=serves())

    return Act(name, context, DRIVE, goal, resources=("base",))
