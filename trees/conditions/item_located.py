"""Is it known where the item is?"""

from __future__ import annotations

from tandem.trees.behaviours.check import Check
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext


def item_located(context: TreeContext, board: FetchBoard, name: str = "item located?") -> Check:
    """Return the condition "the item's tag has been seen, and the item is in no hand"."""

    def holds() -> bool:
        fact = board.fact(context)
        return fact is not None and fact.held is None

    return Check(name, holds)
