"""Change the planning scene: document 000, III-D (add, attach, detach, remove)."""

from __future__ import annotations

from collections.abc import Callable

from skills.ports.actions.world import EDIT, EditFeedback, EditGoal, EditResult, SceneEdit
from trees.behaviours.act import Act
from trees.board import FetchBoard
from trees.context import TreeContext

Edit = Act[EditGoal, EditFeedback, EditResult]


def add_to_scene(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: the item becomes an obstacle."""
    return _edit("add to scene", context, lambda: EditGoal(edit=SceneEdit.ADD, item=board.item))


def attach(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: the item is in the hand from now on."""

    def goal() -> EditGoal:
        return EditGoal(
            edit=SceneEdit.ATTACH,
            item=board.item,
            side=board.chosen_side(),
            item_in_tool=board.chosen_grasp().item_in_tool,
        )

    return _edit("attach", context, goal)


def detach(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: the item stands in its slot from now on."""

    def goal() -> EditGoal:
        return EditGoal(
            edit=SceneEdit.DETACH,
            item=board.item,
            side=board.chosen_side(),
            item_in_map=board.chosen_place().item_in_map,
            depot=board.destination,
            slot=board.slot,
        )

    return _edit("detach", context, goal)


def remove_from_scene(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: the item is no obstacle of this task any more."""
    return _edit("remove from scene", context, lambda: EditGoal(edit=SceneEdit.REMOVE, item=board.item))


def _edit(name: str, context: TreeContext, goal: Callable[[], EditGoal]) -> Edit:
    def believed(result: EditResult) -> bool:
        world = context.knowledge.world
        return world is not None and world.version >= result.version

    return Act(name, context, EDIT, goal, believed=believed)
