"""Is the item in a hand?"""

from __future__ import annotations

from tandem.trees.behaviours.check import Check
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext


def item_held(context: TreeContext, board: FetchBoard, name: str = "item held?") -> Check:
    """Return the condition "the item is in a hand"; which hand becomes the task's arm."""

    def holds() -> bool:
        world = context.knowledge.world
        held = () if world is None else world.held
        for hand in held:
            if hand.item == board.item:
                board.side, board.sides = hand.side, (hand.side,)
                return True
        return False

    return Check(name, holds)
