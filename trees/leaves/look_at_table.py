"""Look down at the table before the robot: the items, and what else stands there."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext
from tandem.trees.item_failures import ambiguous

TILT: Final = -0.9
"""Radians of the head: one picture spans a table from its near edge at 0.45 m to 1.05 m before the base."""


def look_at_table(
    name: str, context: TreeContext, items: tuple[int, ...]
) -> Act[LookGoal, LookFeedback, LookResult]:
    """Return the leaf: SUCCESS only when all the items were seen; the head stays as it then is."""

    def judge(result: LookResult) -> Failure | None:
        there = [sighting.item for sighting in result.sightings]
        missing = [item for item in items if item not in there and not _held(context, item)]
        if not missing:
            return next(filter(None, (ambiguous(context, item, result.sightings) for item in items)), None)
        seen = ", ".join(map(context.site.called, there)) or "no item"
        words = " and ".join(map(context.called, missing))
        return Failure(
            kind=FailureKind.ITEM_NOT_FOUND,
            message=f"{words} not in view on the table; seen: {seen}",
            evidence={"item": missing[0]},
        )

    return Act(
        name,
        context,
        LOOK,
        lambda: LookGoal(tilts=(TILT,), clutter=True),
        resources=("head",),
        judge=judge,
        believed=lambda result: context.believes(s for s in result.sightings if s.item in items),
    )


def _held(context: TreeContext, item: int) -> bool:
    world = context.knowledge.world
    return world is not None and any(hand.item == item for hand in world.held)
