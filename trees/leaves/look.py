"""Look for the item straight ahead."""

from __future__ import annotations

from typing import Final

from skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from skills.ports.failure import Failure, FailureKind
from trees.behaviours.act import Act
from trees.board import FetchBoard
from trees.context import TreeContext

TILTS: Final = (-0.45,)
"""Radians of the head: with 36 degrees of height, one picture spans what lies 0.6 to 4 m ahead on a table."""


def look(name: str, context: TreeContext, board: FetchBoard) -> Act[LookGoal, LookFeedback, LookResult]:
    """Return the leaf: SUCCESS only when the item's tag was seen."""

    def judge(result: LookResult) -> Failure | None:
        if result.found:
            return None
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
