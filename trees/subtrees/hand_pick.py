"""One hand picks its item: by the field or by the planner to before it, then in its turn, or with the other.

Two-arm thesis, 4.2 and 4.3. What fails is tried again as ``trees/behaviours/recovery.py`` does; in the end
the hand is in its safe zone, with the item or without.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.remember import afterwards
from tandem.trees.behaviours.wait_for import WaitFor
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.edit_scene import attach
from tandem.trees.leaves.hand.approach import approach_item
from tandem.trees.leaves.hand.go_safe import go_safe
from tandem.trees.leaves.hand.grip_item import close_on_item, hand_is_full, open_for_item
from tandem.trees.leaves.hand.lift_item import lift_item
from tandem.trees.leaves.hand.reach_item import plan_before_item, reach_item
from tandem.trees.leaves.hand.still_held import still_held
from tandem.trees.recovery_kinds import another_grasp_helps, looking_again_helps
from tandem.trees.subtrees.bring_safe import bring_safe
from tandem.trees.subtrees.recovery_steps import wait_back
from tandem.trees.subtrees.rise import rise

Method = Literal["apf_rrtconnect", "rrtconnect", "rrtconnect_replan"]
"""The thesis's method; its baseline, planned once at the start; and that, planned again for a moved item."""
Arranged = Callable[[Behaviour], Behaviour]
"""Puts the grasp where it belongs: in its turn, behind a barrier, or nowhere."""

WITHIN: Final = 180.0
"""Robot seconds after which nothing is tried again."""
FOLLOWS: Final = 4
"""How often the hand goes back to the field because the item has moved."""
GRASPS: Final = 2
"""How often another grasp is tried, as in ``get_item``: more of them put off what is tried next, or the
failure."""
SEEN_WITHIN: Final = 5.0
"""Robot seconds in which an item that is gone must be seen again."""


def hand_pick(
    context: TreeContext,
    board: HandBoard,
    method: Method,
    *,
    arranged: Arranged = lambda grasp: grasp,
    member: Arranged = lambda pick: pick,
    retreat_apart: bool = False,
) -> Behaviour:
    """Return the subtree: SUCCESS when the item is in the hand, and the hand in its safe zone.

    Args:
        context: of this hand's branch, which keeps its failures.
        board: the hand and its item.
        method: how the hand gets before the item.
        arranged: puts the grasp, from the proximity pose to the safe zone, where it belongs.
        member: has others hear when the pick fails for good.
        retreat_apart: the way from the lift to the safe zone is no part of what is arranged: the next hand's
            grasp overlaps it (the eager mode).
    """
    who = board.who
    to_safety = Sequence(
        f"{who}: bring it to safety",
        memory=True,
        children=[
            go_safe("to safety", context, board),
            still_held("still in hand?", context, board),
        ],
    )
    grasp = _grasp(context, board, follows=method != "rrtconnect")
    if not retreat_apart:
        grasp.add_child(to_safety)
    main = Selector(
        f"{who}: item in hand and safe",
        memory=True,
        children=[
            Sequence(
                f"{who}: has it",
                memory=True,
                children=[
                    Check(f"{who}: item held?", lambda: board.held(context)),
                    bring_safe(context, board, "has it", full=True),
                    still_held("has it: still in hand?", context, board),
                ],
            ),
            Sequence(
                f"{who}: go and pick",
                memory=True,
                children=[
                    open_for_item(context, board),
                    _before_item(context, board, method),
                    arranged(grasp),
                    *((to_safety,) if retreat_apart else ()),
                ],
            ),
        ],
    )
    tried = Recovery(f"{who}: get item", context, main, _steps(context, board, method), within=WITHIN)
    return afterwards(f"{who}: pick", context, member(tried), bring_safe(context, board, "at last"))


def _before_item(context: TreeContext, board: HandBoard, method: Method) -> Behaviour:
    if method == "apf_rrtconnect":
        return approach_item(context, board)
    return plan_before_item(context, board, follows=method == "rrtconnect_replan")


def _grasp(context: TreeContext, board: HandBoard, *, follows: bool) -> Sequence:
    return Sequence(
        f"{board.who}: grasp and lift",
        memory=True,
        children=[
            reach_item(context, board, follows=follows),
            close_on_item(context, board),
            attach(context, board),
            lift_item(context, board),
            hand_is_full(context, board),
        ],
    )


def _steps(context: TreeContext, board: HandBoard, method: Method) -> tuple[RecoveryStep, ...]:
    who = board.who
    patience = wait_back(who, context)
    if method == "rrtconnect":
        return (patience,)

    def seen() -> bool:
        return not isinstance(board.standing(context), Failure)

    in_sight = Selector(
        f"{who}: item in sight",
        memory=True,
        children=[
            Check(f"{who}: item seen?", seen),
            Sequence(
                f"{who}: out of the sight",
                memory=True,
                children=[
                    rise(context, board, "show the item"),
                    go_safe("show the item", context, board),
                    seen_again(context, board),
                ],
            ),
            # What is found on the way out may bar it.
            Check(f"{who}: item seen by now?", seen),
        ],
    )
    follow = RecoveryStep(f"{who}: follow the item", looking_again_helps, FOLLOWS, in_sight)
    if method == "rrtconnect_replan":
        return (patience, follow)
    again = Sequence(
        f"{who}: draw back and begin anew",
        memory=True,
        children=[
            bring_safe(context, board, "draw back"),
            Note(f"{who}: avoid this way", board.give_up_way),
        ],
    )
    return (patience, follow, RecoveryStep(f"{who}: grasp another way", another_grasp_helps, GRASPS, again))


def seen_again(context: TreeContext, board: HandBoard) -> WaitFor:
    """Return the leaf that waits until the item is seen."""

    def otherwise() -> Failure:
        known = board.standing(context)
        if isinstance(known, Failure) and known.kind is FailureKind.ITEM_UNREACHABLE:
            return known
        return Failure(
            kind=FailureKind.ITEM_GONE,
            message=f"{context.called(board.item)} was not seen again within {SEEN_WITHIN:.0f} s",
            evidence={"item": board.item, "waited_s": SEEN_WITHIN},
        )

    def seen() -> bool:
        return not isinstance(board.standing(context), Failure)

    return WaitFor(f"{board.who}: item is seen", context, seen, otherwise, patience=SEEN_WITHIN)
