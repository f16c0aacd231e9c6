"""Does the item lie in the depot?"""

from __future__ import annotations

from tandem.trees.behaviours.check import Check
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext


def item_placed(context: TreeContext, board: FetchBoard) -> Check:
    """Return the condition "the item was put down in its destination"."""

    def holds() -> bool:
        world = context.knowledge.world
        placed = () if world is None else world.placed
        return any(each.item == board.item and each.depot == board.destination for each in placed)

    return Check("item placed?", holds)
