"""Bring a hand to safety whatever it is at: a full one keeps what it holds, an empty one draws back."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.trees.behaviours.check import Check
from tandem.trees.conditions.hand_full import hand_full
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.hand.go_safe import go_safe
from tandem.trees.leaves.hand.grip_item import let_go
from tandem.trees.leaves.retreat import retreat
from tandem.trees.subtrees.rise import rise


def bring_safe(context: TreeContext, board: HandBoard, where: str, *, full: bool = False) -> Behaviour:
    """Return the subtree; ``where`` in the tree makes its names unique. ``full``: the hand is known to hold.

    A hand that presses on a side holds nothing by itself, and its closed fingers had better stay so.
    """
    who = f"{board.who}: {where}"
    hand = Selector(
        f"{who}: hand free or full",
        memory=True,
        children=[
            hand_full(f"{who}: hand full?", context, lambda: board.side),
            let_go(f"{where}: let go", context, board),
        ],
    )
    keeps = full or board.site_item(context).needs_two
    free = Sequence(
        f"{who}: free and safe",
        memory=True,
        children=[
            *(() if keeps else (hand,)),
            retreat(f"{who}: draw back", context, lambda: board.side),
            go_safe(f"{where}: to safety then", context, board),
        ],
    )
    return Selector(
        f"{who}: hand safe",
        memory=True,
        children=[
            Check(f"{who}: safe?", lambda: board.safe),
            Sequence(
                f"{who}: up and safe",
                memory=True,
                children=[
                    *(() if full else (rise(context, board, where),)),
                    go_safe(f"{where}: to safety", context, board),
                ],
            ),
            free,
        ],
    )
