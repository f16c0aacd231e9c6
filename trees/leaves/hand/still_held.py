"""Is the item still in the hand that has brought it to safety? What was lost on the way is not in hand."""

from __future__ import annotations

from tandem.skills.ports.failure import Failure
from tandem.trees.behaviours.decide import Decide
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.item_failures import no_longer_held


def still_held(what: str, context: TreeContext, board: HandBoard) -> Decide:
    """Return the leaf: FAILURE with GRASP_LOST when the hand is no longer believed to hold its item."""

    def decide() -> str | Failure:
        if board.held(context):
            return f"{context.called(board.item)} is in the {board.side} hand"
        return no_longer_held(context, board.item, board.side)

    return Decide(f"{board.who}: {what}", context, decide)
