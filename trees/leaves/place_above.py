"""Bring the item above its slot: order-picking paper, III-D.2 a."""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.grasping.tag_grasps import Place, place
from tandem.skills.grasping.turns import to_place
from tandem.skills.ports.actions.arm import Candidate, MoveFeedback, MoveGoal, MoveResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.move_hand import move_hand

TURNS: Final = tuple(math.radians(angle) for angle in (0.0, 20.0, -20.0, 40.0, -40.0))
"""Turns of the item about the vertical, in the order in which they are tried."""


def ways_to_place(context: TreeContext, board: FetchBoard, side: HandName) -> tuple[Place, ...] | Failure:
    """Return the ways to put the item down as the hand of ``side`` holds it, one for each turn."""
    world = context.knowledge.world
    held = None if world is None else world.in_hand(side)
    if held is None or held.item != board.item:
        return Failure(
            kind=FailureKind.GRASP_LOST, message=f"{context.called(board.item)} is not in the {side} hand"
        )
    slot, height = board.chosen_slot(context), board.site_item(context).size[2]
    return tuple(place(slot.position, slot.facing + turn, held.item_in_tool, height) for turn in TURNS)


def place_candidates(ways: tuple[Place, ...]) -> tuple[Candidate, ...]:
    """Return the ways as goals of the arm: above the slot, then straight down, and back."""
    return tuple(Candidate(pose=way.above, followed_by=(way.place, way.retraction)) for way in ways)


def place_above(context: TreeContext, board: FetchBoard) -> Act[MoveGoal, MoveFeedback, MoveResult]:
    """Return the leaf: offers some turns of the item, and binds the place that was taken."""

    def goal() -> MoveGoal | Failure:
        ways = ways_to_place(context, board, board.chosen_side())
        if isinstance(ways, Failure):
            return ways
        board.places = ways
        return MoveGoal(
            candidates=place_candidates(ways),
            touch_item=board.item,
            touch_support=True,
            turn=to_place(board.chosen_slot(context).position),
        )

    def judge(result: MoveResult) -> Failure | None:
        board.place = board.places[result.candidate].turned(result.turned)
        return None

    return move_hand("place above", context, board, goal, judge)
