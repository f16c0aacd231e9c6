"""Turn the head to what will be looked at, while the base is on its way: the look then begins at once."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.perception import TURN_HEAD, LookFeedback, TurnHeadGoal, TurnHeadResult
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import FloorPose
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext


def turn_head(
    name: str, context: TreeContext, at: Callable[[], Vector3 | Failure], base: Callable[[], FloorPose]
) -> Act[TurnHeadGoal, LookFeedback, TurnHeadResult]:
    """Return the leaf.

    Args:
        name: unique in the tree.
        context: the task's surroundings, or a branch's.
        at: the point in the map (m), or why there is none.
        base: where the base will stand.
    """

    def goal() -> TurnHeadGoal | Failure:
        point = at()
        return point if isinstance(point, Failure) else TurnHeadGoal(at=point, base=base())

    return Act(name, context, TURN_HEAD, goal, resources=("head",))
