"""Bring a hand before its item by the potential field: two-arm thesis, 4.2."""

from __future__ import annotations

from tandem.skills.ports.actions.approach import ApproachFeedback, ApproachGoal, ApproachResult, approach
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard


def approach_item(
    context: TreeContext, board: HandBoard
) -> Act[ApproachGoal, ApproachFeedback, ApproachResult]:
    """Return the leaf: SUCCESS at the proximity pose of the item, wherever that is by then."""

    def goal() -> ApproachGoal | Failure:
        wrong = board.offer(context)
        if wrong is not None:
            return wrong
        board.safe = False
        return ApproachGoal(
            item=board.item,
            grasps=tuple(way.tool_in_item for way in board.ways),
            hand_width=board.open_width(context),
            turn=board.most_turn(context),
        )

    def judge(result: ApproachResult) -> Failure | None:
        board.choose(result.grasp, result.turned)
        board.frame = result.item_in_map
        return None

    return Act(
        f"{board.who}: approach",
        context,
        approach(board.group),
        goal,
        resources=(board.group,),
        judge=judge,
    )
