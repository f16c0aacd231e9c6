"""Say that the item is in the hand from now on."""

from __future__ import annotations

from tandem.skills.grasping.hand_grasps import item_in_tool
from tandem.skills.ports.actions.world import EDIT, EditFeedback, EditGoal, EditResult, SceneEdit
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard


def attach_item(context: TreeContext, board: HandBoard) -> Act[EditGoal, EditFeedback, EditResult]:
    """Return the leaf."""

    def goal() -> EditGoal:
        pose = item_in_tool(board.chosen())
        return EditGoal(edit=SceneEdit.ATTACH, item=board.item, side=board.side, item_in_tool=pose)

    def believed(result: EditResult) -> bool:
        world = context.knowledge.world
        return world is not None and world.version >= result.version

    return Act(f"{board.who}: attach", context, EDIT, goal, believed=believed)
