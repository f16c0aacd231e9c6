"""Look for the item straight ahead."""

from __future__ import annotations

from tandem.skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.act import Act
from tandem.trees.board import NEAR, FetchBoard, is_meant
from tandem.trees.context import TreeContext
from tandem.trees.item_failures import ambiguous, evidence_of


def search_tilts(context: TreeContext) -> tuple[float, ...]:
    """Return the tilts (rad) of a look straight ahead: the robot's, or the usual ones before it was heard."""
    description = context.knowledge.description
    return LookGoal().tilts if description is None else description.search_tilts


def _elsewhere(context: TreeContext, board: FetchBoard) -> Failure:
    return Failure(
        kind=FailureKind.ITEM_NOT_FOUND,
        message=f"{context.called(board.item)} is in view, but not within {NEAR} m of {board.near}",
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
            return _elsewhere(context, board)
        seen = ", ".join(context.site.called(sighting.item) for sighting in result.sightings) or "no item"
        return Failure(
            kind=FailureKind.ITEM_NOT_FOUND,
            message=f"{context.called(board.item)} is not in view; seen: {seen}",
            evidence=dict(evidence_of(board.item, result)),
        )

    return Act(
        name,
        context,
        LOOK,
        lambda: LookGoal(item=board.item, tilts=search_tilts(context)),
        resources=("head",),
        judge=judge,
        believed=lambda result: context.believes(s for s in result.sightings if s.item == board.item),
    )
