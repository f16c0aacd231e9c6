"""Search for the item: order-picking paper, III-A.2 and Fig. 2.

If the tag is in view already, there is no search. Otherwise the robot turns by 30 degrees clockwise and looks
again, up to 360 degrees; then it drives to the next spot. It stops the moment the tag is seen.
"""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import FloorPose
from tandem.trees.behaviours.again import Again
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.decide import Decide
from tandem.trees.behaviours.give_up import GiveUp
from tandem.trees.behaviours.note import Note
from tandem.trees.board import FetchBoard
from tandem.trees.conditions.item_located import item_located
from tandem.trees.context import TreeContext
from tandem.trees.item_failures import ambiguous
from tandem.trees.leaves.edit_scene import select
from tandem.trees.leaves.look import look
from tandem.trees.leaves.rotate import ALL_AROUND, rotate
from tandem.trees.recovery_kinds import unseen
from tandem.trees.subtrees.arms_in import free_and_tuck
from tandem.trees.subtrees.travel import drive_and_give_way


def search(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree: SUCCESS when it is known where the item is, and which one is meant."""
    spots = Again(
        "every spot",
        context,
        Sequence(
            "search a spot",
            memory=True,
            children=[
                _next_spot(context, board),
                _to_spot(context, board),
                _around(context, board, "at spot"),
            ],
        ),
        len(context.site.spots),
        unseen,
    )
    here = Sequence(
        "search from here",
        memory=True,
        children=[free_and_tuck(context, "before search"), _around(context, board, "here")],
    )
    found = Selector(
        "find item",
        memory=True,
        children=[
            item_located(context, board),
            here,
            Sequence("search elsewhere", memory=True, children=[_only_unseen("here", context), spots]),
            _not_found(context, board),
        ],
    )
    if board.near is not None:
        return Sequence("find the one meant", memory=True, children=[found, select(context, board)])
    return Sequence("find the only one", memory=True, children=[found, _only_one(context, board)])


def _only_one(context: TreeContext, board: FetchBoard) -> Decide:
    def decide() -> str | Failure:
        return ambiguous(context, board.item) or f"the only {context.site.called(board.item)}"

    return Decide("which one is meant?", context, decide)


def _around(context: TreeContext, board: FetchBoard, where: str) -> Behaviour:
    again = Sequence(
        f"turn and look {where}",
        memory=True,
        children=[rotate(f"turn 30 degrees {where}", context), look(f"look again {where}", context, board)],
    )
    return Selector(
        f"look around {where}",
        memory=True,
        children=[
            look(f"look {where}", context, board),
            Sequence(
                f"look all around {where}",
                memory=True,
                children=[
                    _only_unseen(f"ahead {where}", context),
                    Again(f"up to 360 degrees {where}", context, again, ALL_AROUND, unseen),
                ],
            ),
        ],
    )


def _only_unseen(where: str, context: TreeContext) -> Check:
    """Return the condition that lets a search go on: a silent camera sees it nowhere."""
    return Check(f"only not seen {where}?", lambda: unseen(context.failures.last()))


def _next_spot(context: TreeContext, board: FetchBoard) -> Note:
    def decide() -> str:
        spot = context.site.spots[board.spot % len(context.site.spots)]
        board.spot += 1
        return f"spot {spot.name}"

    return Note("next spot", decide)


def _to_spot(context: TreeContext, board: FetchBoard) -> Behaviour:
    def poses() -> tuple[FloorPose, ...]:
        return (context.site.spots[(board.spot - 1) % len(context.site.spots)].pose,)

    return drive_and_give_way("drive to spot", context, poses)


def _not_found(context: TreeContext, board: FetchBoard) -> GiveUp:
    spots = len(context.site.spots)

    def reason() -> Failure:
        last = context.failures.last()
        if not unseen(last):
            return last
        return Failure(
            kind=FailureKind.ITEM_NOT_FOUND,
            message=f"{context.called(board.item)} was seen neither here nor from any of the {spots} spots",
            evidence={"item": board.item, "spots": spots, "turns": ALL_AROUND},
        )

    return GiveUp("item not found", context, reason)
