"""Look at the slot before something is put there: what else stands on the depot goes into the scene."""

from __future__ import annotations

from tandem.skills.ports.actions.perception import LOOK, LookFeedback, LookGoal, LookResult
from tandem.trees.behaviours.act import Act
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.look_closely import REACH


def look_at_slot(
    name: str, context: TreeContext, board: FetchBoard
) -> Act[LookGoal, LookFeedback, LookResult]:
    """Return the leaf."""
    return Act(
        name,
        context,
        LOOK,
        lambda: LookGoal(at=board.chosen_slot(context).position, clutter=True, around=REACH),
        resources=("head",),
    )
