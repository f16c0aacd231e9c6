"""Look for the item straight ahead."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.act import Act
from tandem.trees.board import NEAR, FetchBoard, is_meant
from tandem.trees.context import TreeContext
from tandem.trees.item_failures import ambiguous

TILTS: Final = (-0.45,)
"""Radians of the head: with 36 degrees of height, one picture spans what lies 0.6 to 4 m ahead on a table."""


def _elsewhere(board: FetchBoard) -> Failure:
    return Failure(
        kind=FailureKind.ITEM_NOT_FOUND,
        message=f"item {board.item} is in view, but not within {NEAR} m of {board.near}",
        evidence={"item": board.item},
    )


def look(name: str, context: TreeContext, board: FetchBoard) -> Act[LookGoal, LookFeedback, LookResult]:
    """Return the leaf: SUCCESS only when the item's tag was seen."""

    def judge(result: LookResult) -> Failure | None:
        if board.near is None and (several := ambiguous(context, board.item, result.sightings)):
            return several
        there = [each for each in result.sightings if each.item == board.item]
        if any(board.near is None or is_meant(each.tag_in_map, board.near) for each in there):
            return None
        if there:
            return _elsewhere(board)
        seen = ", ".join(str(sighting.item) for sighting in result.sightings) or "no tag"
        return Failure(
            kind=FailureKind.ITEM_NOT_FOUND,
            message=f"item {board.item} is not in view; seen: {seen}",
            evidence={"item": board.item},
        )

    return Act(
        name,
        context,
        LOOK,
        lambda: LookGoal(item=board.item, tilts=TILTS),
        resources=("head",),
        judge=judge,
        believed=lambda result: context.believes(s for s in result.sightings if s.item == board.item),
    )
