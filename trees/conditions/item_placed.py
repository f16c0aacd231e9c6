"""Does the item lie in the depot?"""

from __future__ import annotations

from trees.behaviours.check import Check
from trees.board import FetchBoard
from trees.context import TreeContext


def item_placed(context: TreeContext, board: FetchBoard) -> Check:
    """Return the condition "the item was put down in its destination"."""

    def holds() -> bool:
        world = context.knowledge.world
        placed = () if world is None else world.placed
        return any(each.item == board.item and each.depot == board.destination for each in placed)

    return Check("item placed?", holds)
