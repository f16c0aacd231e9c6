"""After a cancel: put what is in the hand back to where it stood, or into its slot if nobody knows where."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from py_trees.decorators import Inverter

from trees.behaviours.note import Note
from trees.board import FetchBoard
from trees.conditions.item_held import item_held
from trees.context import TreeContext
from trees.subtrees.place import place


def put_back(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return a tree of its own: SUCCESS when the item is in no hand."""

    def decide() -> str:
        board.putting_back = board.origin is not None
        board.forget_tries()
        return "to where it stood" if board.putting_back else f"into slot {board.slot}"

    return Selector(
        "put down",
        memory=True,
        children=[
            Inverter("item in no hand", item_held(context, board)),
            Sequence(
                "put item back",
                memory=True,
                children=[Note("where it goes", decide), place(context, board)],
            ),
        ],
    )
