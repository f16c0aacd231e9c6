"""Look at the item from near by: its pose for the grasp, and the clutter around it for the arm."""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.item_failures import ambiguous, evidence_of

PICTURES: Final = 3
"""Pictures whose tag poses are averaged before a grasp."""
REACH: Final = 1.15
"""Metres from the base's axis to where no hand gets at a table's height: 1.14 m in 6,582 random postures of
TIAGo++. The look itself goes no farther than the robot's own arms."""


def not_seen(context: TreeContext, item: int, result: LookResult) -> Failure:
    """Return why a look straight at the item's place has not seen it."""
    called = context.called(item)
    if item in result.hidden:
        return Failure(
            kind=FailureKind.ITEM_HIDDEN,
            message=f"{called} can't be seen from here: something stands before it",
            evidence={"item": item},
        )
    if result.head_short:
        short = math.degrees(result.head_short)
        return Failure(
            kind=FailureKind.ITEM_HIDDEN,
            message=f"{called} can't be seen from here: the head stops {short:.0f} degrees short of it",
            evidence=dict(evidence_of(item, result)),
        )
    return Failure(
        kind=FailureKind.ITEM_GONE,
        message=f"{called} is not where it was seen before",
        evidence={"item": item, "pictures": PICTURES},
    )


def look_closely(
    name: str, context: TreeContext, board: FetchBoard
) -> Act[LookGoal, LookFeedback, LookResult]:
    """Return the leaf: FAILURE when the item is hidden, or not where it was believed to be."""

    def goal() -> LookGoal | Failure:
        fact = board.fact(context)
        if fact is None:
            return Failure(
                kind=FailureKind.ITEM_GONE, message=f"{context.called(board.item)} has not been seen"
            )
        return LookGoal(at=fact.tag_in_map.position, pictures=PICTURES, clutter=True, around=REACH)

    def judge(result: LookResult) -> Failure | None:
        if board.near is None and (several := ambiguous(context, board.item, result.sightings)):
            return several
        if any(sighting.item == board.item for sighting in result.sightings):
            return None
        return not_seen(context, board.item, result)

    return Act(
        name,
        context,
        LOOK,
        goal,
        resources=("head",),
        judge=judge,
        believed=lambda result: context.believes(s for s in result.sightings if s.item == board.item),
    )
