"""From the proximity pose to the item; it gives up when the item moves away: two-arm thesis, 4.3 and 6."""

from __future__ import annotations

from typing import Final

from tandem.skills.geometry.poses import compose
from tandem.skills.grasping.hand_grasps import before, lifted
from tandem.skills.grasping.turns import to_go_on
from tandem.skills.ports.actions.approach import GOAL_RADIUS
from tandem.skills.ports.actions.arm import Candidate, MoveGoal, MoveResult, TurnAbout
from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.move_hand import Move, move_hand

MOVED: Final = 0.01
"""Metres by which the item may be found elsewhere on the last centimetres: fingers have 8 mm of room."""

SHORT: Final = 0.01
"""Metres before an item for two hands at which each stops."""


def reach_item(context: TreeContext, board: HandBoard, what: str = "grasp", *, follows: bool = True) -> Move:
    """Return the leaf: straight to the item, which the hand may touch, and nothing else.

    One that does not follow goes to where the item stood when the way was planned.
    """

    def goal() -> MoveGoal | Failure:
        item = board.standing(context) if follows or board.item_at is None else board.item_at
        if isinstance(item, Failure):
            return item
        board.item_at = item
        tool = board.tool_at(item)
        if board.site_item(context).needs_two:
            tool = before(tool, SHORT)  # the hands close in together
        return MoveGoal(
            candidates=(Candidate(pose=tool),),
            straight=True,
            turn=to_go_on(tool),
            touch_item=board.item,
            hand_width=board.open_width(context),
            follows_item=board.item if follows else None,
            follow_tolerance=MOVED,
        )

    return move_hand(what, context, board, goal)


def plan_before_item(
    context: TreeContext, board: HandBoard, what: str = "plan before item", *, follows: bool = True
) -> Move:
    """Return the leaf: planned (RRTConnect) to where the way to the item is straight."""

    def goal() -> MoveGoal | Failure:
        wrong = board.offer(context)
        item = board.standing(context)
        if wrong is not None:
            return wrong
        if isinstance(item, Failure):
            return item
        board.item_at, board.safe = item, False
        alone = not board.site_item(context).needs_two
        tools = [compose(item, way.tool_in_item) for way in board.ways]
        return MoveGoal(
            candidates=tuple(
                Candidate(
                    pose=before(tool, GOAL_RADIUS), followed_by=(tool, lifted(tool)) if alone else (tool,)
                )
                for tool in tools
            ),
            turn=TurnAbout(point=item.position, most=board.most_turn(context)),
            touch_item=board.item,
            hand_width=board.open_width(context),
            follows_item=board.item if follows else None,
        )

    def judge(result: MoveResult) -> Failure | None:
        board.choose(result.candidate, result.turned)
        return None

    return move_hand(what, context, board, goal, judge)
