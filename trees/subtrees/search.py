"""Search for the item: document 000, III-A.2 and Fig. 2.

If the tag is in view already, there is no search. Otherwise the robot turns by 30 degrees clockwise and looks
again, up to 360 degrees; then it drives to the next spot. It stops the moment the tag is seen.
"""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from py_trees.decorators import Retry

from skills.ports.failure import Failure, FailureKind
from skills.ports.geometry import FloorPose
from trees.behaviours.decide import Decide
from trees.board import FetchBoard
from trees.conditions.item_located import item_located
from trees.context import TreeContext
from trees.leaves.drive import drive
from trees.leaves.look import look
from trees.leaves.turn import turn
from trees.subtrees.home import tuck

TURNS = 12
"""Turns of 30 degrees make 360."""


def search(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree: SUCCESS when it is known where the item is."""
    spots = Retry(
        "every spot",
        Sequence(
            "search a spot",
            memory=True,
            children=[
                _next_spot(context, board),
                _to_spot(context, board),
                _around(context, board, "at spot"),
            ],
        ),
        num_failures=len(context.site.spots),
    )
    here = Sequence(
        "search from here",
        memory=True,
        children=[tuck(context, "before search"), _around(context, board, "here")],
    )
    return Selector(
        "find item",
        memory=True,
        children=[item_located(context, board), here, spots, _not_found(context, board)],
    )


def _around(context: TreeContext, board: FetchBoard, where: str) -> Behaviour:
    again = Sequence(
        f"turn and look {where}",
        memory=True,
        children=[turn(f"turn 30 degrees {where}", context), look(f"look again {where}", context, board)],
    )
    return Selector(
        f"look around {where}",
        memory=True,
        children=[look(f"look {where}", context, board), Retry(f"up to 360 degrees {where}", again, TURNS)],
    )


def _next_spot(context: TreeContext, board: FetchBoard) -> Decide:
    def decide() -> str | Failure:
        spot = context.site.spots[board.spot % len(context.site.spots)]
        board.spot += 1
        return f"spot {spot.name}"

    return Decide("next spot", context, decide)


def _to_spot(context: TreeContext, board: FetchBoard) -> Behaviour:
    def poses() -> tuple[FloorPose, ...]:
        return (context.site.spots[(board.spot - 1) % len(context.site.spots)].pose,)

    return drive("drive to spot", context, poses)


def _not_found(context: TreeContext, board: FetchBoard) -> Decide:
    spots = len(context.site.spots)

    def decide() -> str | Failure:
        return Failure(
            kind=FailureKind.ITEM_NOT_FOUND,
            message=f"item {board.item} was seen neither here nor from any of the {spots} spots",
            evidence={"item": board.item, "spots": spots, "turns": TURNS},
        )

    return Decide("item not found", context, decide)
