"""Look straight ahead for whatever is there."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from tandem.skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.world import Sighting
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext
from tandem.trees.leaves.look import search_tilts


def look_round(
    name: str, context: TreeContext, seen: Callable[[Iterable[Sighting]], None]
) -> Act[LookGoal, LookFeedback, LookResult]:
    """Return the leaf: SUCCESS when what was seen is believed; ``seen`` is told of it."""

    def judge(result: LookResult) -> Failure | None:
        seen(result.sightings)
        return None

    return Act(
        name,
        context,
        LOOK,
        lambda: LookGoal(tilts=search_tilts(context)),
        resources=("head",),
        judge=judge,
        believed=lambda result: context.believes(result.sightings),
    )
