"""Does the item stand in its slot, and in no hand?"""

from __future__ import annotations

from tandem.trees.behaviours.check import Check
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext


def item_left(context: TreeContext, board: FetchBoard) -> Check:
    """Return the condition "the item was let go where it was to be put down"."""

    def holds() -> bool:
        world = context.knowledge.world
        if world is None or any(hand.item == board.item for hand in world.held):
            return False
        there = (board.item, board.destination, board.slot)
        return board.putting_back or any((it.item, it.depot, it.slot) == there for it in world.placed)

    return Check("item let go?", holds)
