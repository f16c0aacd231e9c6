"""After a cancel: put what is in the hand back to where it stood, or into its slot if nobody knows where.

It may begin in an executive that has just been started again: so it waits until the world is known before it
believes that a hand is empty, and reads from the task's notes what the tree of before the restart knew.
"""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from py_trees.decorators import Inverter

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.decide import Decide
from tandem.trees.board import FetchBoard
from tandem.trees.conditions.arm_tucked import tucked
from tandem.trees.conditions.item_held import item_held
from tandem.trees.context import TreeContext
from tandem.trees.fetch_notes import recall
from tandem.trees.leaves.bind_slot import bind_slot
from tandem.trees.leaves.open_hand import open_hand
from tandem.trees.leaves.retreat import retreat
from tandem.trees.leaves.tuck_arm import tuck_arm
from tandem.trees.subtrees.place import place
from tandem.trees.subtrees.request import ready

PATIENCE: Final = 60.0
"""Seconds, of the robot and of the host, for the keeper and the arms: they start within 10 s."""


def put_back(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return a tree of its own: SUCCESS when the item is in no hand."""

    def decide() -> str | Failure:
        board.origin = board.origin or recall(context).origin
        board.putting_back = board.origin is not None
        board.forget_tries()
        return "to where it stood" if board.putting_back else "into a slot"

    return Sequence(
        "put down",
        memory=True,
        children=[
            ready(context, "hands are known", patience=PATIENCE),
            Selector(
                "item in no hand",
                memory=True,
                children=[
                    Sequence(
                        "hands empty",
                        memory=True,
                        children=[Inverter("not in hand", item_held(context, board)), _let_go(context)],
                    ),
                    Sequence(
                        "put item back",
                        memory=True,
                        children=[
                            item_held(context, board, "in hand?"),
                            Decide("where it goes", context, decide),
                            Selector(
                                "a place for it",
                                memory=True,
                                children=[
                                    Check("it goes back?", lambda: board.putting_back),
                                    bind_slot("bind a slot", context, board),
                                ],
                            ),
                            place(context, board),
                        ],
                    ),
                ],
            ),
        ],
    )


def _let_go(context: TreeContext) -> Behaviour:
    """Open the hand that closed on the item, and was not known to hold it when the task was cancelled."""

    def side() -> HandName:
        closed = recall(context).closed
        assert closed is not None, "asked for before"
        return closed

    def away() -> bool:
        closed = recall(context).closed
        return closed is None or tucked(context, closed)

    return Selector(
        "no hand around it",
        memory=True,
        children=[
            Check("no hand around it?", away),
            Sequence(
                "let go of it",
                memory=True,
                children=[
                    open_hand("open hand", context, side),
                    retreat("draw hand back", context, side),
                    tuck_arm("tuck arm", context, side),
                ],
            ),
        ],
    )
