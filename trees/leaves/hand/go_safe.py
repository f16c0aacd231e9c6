"""Bring a hand to its safe zone: two-arm thesis, 4.1.1, S_L and S_R."""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.grasping.hand_grasps import upright_at
from tandem.skills.ports.actions.arm import Candidate, MoveGoal, MoveResult
from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.move_hand import Move, move_hand

HEADINGS: Final = tuple(math.radians(angle) for angle in (30.0, 60.0, 0.0, 90.0))
"""By how much a hand that holds something points inwards there, in the order in which they are tried."""


def go_safe(what: str, context: TreeContext, board: HandBoard) -> Move:
    """Return the leaf: an empty hand to its posture "home"; a full one holds its item upright."""

    def goal() -> MoveGoal:
        candidates = _holding(context, board) if board.held(context) else ()
        return MoveGoal(candidates=candidates, frame="base") if candidates else MoveGoal(posture=_posture())

    def _posture() -> str:
        return "carry" if context.knowledge.may_hold(board.side) else "home"

    def judge(_: MoveResult) -> Failure | None:
        board.safe = True
        return None

    return move_hand(what, context, board, goal, judge)


def _holding(context: TreeContext, board: HandBoard) -> tuple[Candidate, ...]:
    """Return poses of the tool in the base with the item upright at the hand's safe point."""
    description = context.knowledge.description
    point = None if description is None else description.end_effector(board.side).safe_point
    if point is None or board.way is None:
        return ()
    sense = -1.0 if board.side == "left" else 1.0
    return tuple(Candidate(pose=upright_at(point, sense * heading, board.way)) for heading in HEADINGS)
