"""Raise a hand straight up before it goes: what it was at may stand unseen beside it.

An arm hides what is near it from the camera. A way to safety is planned around what is believed; on its first
centimetres a hand among things on a table would sweep away what nobody sees. Straight up it meets nothing.
"""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector

from tandem.skills.ports.actions.arm import MoveGoal
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.note import Note
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.move_hand import move_hand

RISE: Final = 0.12
"""Metres: a hand that grasps at the middle of a cube of 7 cm is well above it then."""
LATELY: Final = 0.5
"""Robot seconds: items in sight are seen five times a second."""


def rise(context: TreeContext, board: HandBoard, where: str) -> Behaviour:
    """Return the subtree: SUCCESS always, the hand raised when its item has not been seen lately.

    ``where`` makes its names unique. No way up is no failure: the way to safety is tried all the same.
    """
    who = f"{board.who}: {where}"

    def nothing_unseen() -> bool:
        if board.safe or board.held(context):
            return True
        fact, now = board.fact(context), context.clocks.robot()
        return fact is not None and now is not None and fact.seen.is_fresh(now, LATELY)

    return Selector(
        f"{who}: above what is not seen",
        memory=True,
        children=[
            Check(f"{who}: nothing unseen?", nothing_unseen),
            move_hand(f"{where}: rise", context, board, lambda: MoveGoal(up=RISE)),
            Note(f"{who}: go as it is", lambda: "there is no way up"),
        ],
    )
