"""Both hands pick one thing: each before its grasp point, then together: two-arm thesis, 4.2 and 4.3.

Squeezed, lifted, held, put down where it stood, and let go; whatever fails, it is not dropped.
"""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from py_trees.decorators import FailureIsSuccess

from tandem.trees.behaviours.barrier import Barrier, Meet, Member
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.pause import Pause
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.remember import afterwards
from tandem.trees.behaviours.side_by_side import SideBySide
from tandem.trees.branch import Branch, branch
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.hand.approach import approach_item
from tandem.trees.leaves.hand.grip_item import open_for_item
from tandem.trees.leaves.hand.reach_item import plan_before_item, reach_item
from tandem.trees.leaves.two_hands import (
    BothBoard,
    let_go_together,
    lift_together,
    put_down_together,
    squeeze,
)
from tandem.trees.recovery_kinds import another_grasp_helps, looking_again_helps
from tandem.trees.subtrees.bring_safe import bring_safe
from tandem.trees.subtrees.hand_pick import FOLLOWS, GRASPS, WITHIN, Method, seen_again
from tandem.trees.subtrees.recovery_steps import wait_back

Hand = tuple[Branch, HandBoard]


def both_pick(context: TreeContext, board: BothBoard, method: Method, hold: float) -> Behaviour:
    """Return the subtree: SUCCESS when it was lifted, held, put down, and both hands are safe.

    Args:
        context: the task's surroundings.
        board: the item and its hands.
        method: how the hands approach it.
        hold: robot seconds for which it is held up.
    """
    hands = (branch(context, board.left.who), board.left), (branch(context, board.right.who), board.right)
    main = Sequence(
        "pick with both hands",
        memory=True,
        children=[
            _before(context, hands, method),
            _at_item(context, hands, follows=method != "rrtconnect"),
            squeeze(context, board),
            lift_together(context, board),
            Pause("hold it", context, hold),
            put_down_together("put down", context, board),
            let_go_together("let go", context, board),
            Pause("hands come to rest", context, REST),
        ],
    )
    tried = Recovery("get it with both hands", context, main, _steps(context, board, method), within=WITHIN)
    end = Sequence(
        "at last",
        memory=True,
        children=[_free(context, board, "at last"), _safe(context, board, "at last")],
    )
    return afterwards("both hands pick", context, tried, end)


def _before(context: TreeContext, hands: tuple[Hand, Hand], method: Method) -> Behaviour:
    """Bring both hands before their grasp points; who is there first waits for the other."""
    barrier = Barrier(*(board.who for _, board in hands))

    def way(at: Branch, board: HandBoard) -> Behaviour:
        near = (
            approach_item(at, board)
            if method == "apf_rrtconnect"
            else plan_before_item(at, board, follows=method == "rrtconnect_replan")
        )
        steps = [
            open_for_item(at, board),
            near,
            Meet(f"{board.who}: wait for the other", at, barrier, board.who),
        ]
        walk = Sequence(f"{board.who}: before its grasp point", memory=True, children=list(steps))
        return Member(f"{board.who}: for both", at, walk, barrier, board.who)

    both = SideBySide("both before it", context, tuple((at, way(at, board)) for at, board in hands))
    return Sequence(
        "both hands before it", memory=True, children=[Note("set up the barrier", barrier.reset), both]
    )


def _at_item(context: TreeContext, hands: tuple[Hand, Hand], *, follows: bool) -> Behaviour:
    return SideBySide(
        "both at it", context, tuple((at, reach_item(at, board, follows=follows)) for at, board in hands)
    )


def _steps(context: TreeContext, board: BothBoard, method: Method) -> tuple[RecoveryStep, ...]:
    patience = wait_back("both", context)
    if method == "rrtconnect":
        return (patience,)
    follow = RecoveryStep(
        "both: follow the item", looking_again_helps, FOLLOWS, seen_again(context, board.left)
    )
    if method == "rrtconnect_replan":
        return (patience, follow)
    again = Sequence(
        "both: draw back and begin anew",
        memory=True,
        children=[
            _free(context, board, "draw back"),
            _safe(context, board, "draw back"),
            *(Note(f"{hand.who}: avoid this way", hand.give_up_way) for hand in board.hands),
        ],
    )
    return (patience, follow, RecoveryStep("both: grasp another way", another_grasp_helps, GRASPS, again))


def _free(context: TreeContext, board: BothBoard, where: str) -> Behaviour:
    """Put down and let go of what is between the hands, if anything is."""
    return Selector(
        f"both: {where}: hands free",
        memory=True,
        children=[
            Check(f"both: {where}: nothing between the hands?", lambda: not board.between),
            Sequence(
                f"both: {where}: put it down",
                memory=True,
                children=[
                    FailureIsSuccess(
                        f"both: {where}: down if it can be",
                        put_down_together(f"{where}: put down", context, board),
                    ),
                    let_go_together(f"{where}: let go", context, board),
                ],
            ),
        ],
    )


def _safe(context: TreeContext, board: BothBoard, where: str) -> Behaviour:
    """Bring both hands to safety, one after the other: the second also when the first does not get there."""
    left, right = board.hands
    return afterwards(
        f"both: {where}: hands safe",
        context,
        bring_safe(context, left, where),
        bring_safe(context, right, where),
    )


REST: Final = 0.3
"""Robot seconds after letting go, in which the arms stop swaying."""
HOLD: Final = 2.0
"""Robot seconds for which it is held up unless a request says otherwise."""
