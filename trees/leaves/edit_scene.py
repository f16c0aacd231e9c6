"""Change the planning scene: order-picking paper, III-D (add, attach, detach, remove)."""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.actions.world import EDIT, EditFeedback, EditGoal, EditResult, SceneEdit
from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.fetch_notes import lets_go
from tandem.trees.hand_task import HandTask

Edit = Act[EditGoal, EditFeedback, EditResult]


def add_to_scene(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: the item becomes an obstacle."""
    return _edit("add to scene", context, lambda: EditGoal(edit=SceneEdit.ADD, item=board.item))


def attach(context: TreeContext, board: HandTask) -> Edit:
    """Return the leaf: the item is in the hand from now on."""

    def goal() -> EditGoal:
        return EditGoal(
            edit=SceneEdit.ATTACH,
            item=board.item,
            side=board.chosen_side(),
            item_in_tool=board.item_in_tool(),
        )

    return _edit(board.node("attach"), context, goal, board.attached)


def detach(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: the item stands in its slot from now on."""

    def goal() -> EditGoal:
        lets_go(context, board)
        return EditGoal(
            edit=SceneEdit.DETACH,
            item=board.item,
            side=board.chosen_side(),
            item_in_map=board.chosen_place().item_in_map,
            depot=None if board.putting_back else board.destination,
            slot=None if board.putting_back else board.slot,
        )

    return _edit("detach", context, goal)


def remove_from_scene(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: the item is no obstacle of this task any more."""
    return _edit("remove from scene", context, lambda: EditGoal(edit=SceneEdit.REMOVE, item=board.item))


def forget(name: str, context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: where the item stands is not believed any more."""
    return _edit(name, context, lambda: EditGoal(edit=SceneEdit.FORGET, item=board.item))


def select(context: TreeContext, board: FetchBoard) -> Edit:
    """Return the leaf: of several things with the item's number, the one that the request locates is it."""
    return _edit(
        "select the one meant",
        context,
        lambda: EditGoal(edit=SceneEdit.SELECT, item=board.item, near=board.near),
    )


def _nothing() -> None:
    """Note nothing."""


def _edit(
    name: str,
    context: TreeContext,
    goal: Callable[[], EditGoal],
    note: Callable[[], None] = _nothing,
) -> Edit:
    def believed(result: EditResult) -> bool:
        world = context.knowledge.world
        return world is not None and world.version >= result.version

    def judge(_: EditResult) -> Failure | None:
        note()
        return None

    return Act(name, context, EDIT, goal, believed=believed, judge=judge)
