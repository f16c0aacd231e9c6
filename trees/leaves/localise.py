"""Find out where the robot is, from the laser."""

from __future__ import annotations

from tandem.skills.ports.actions.base import LOCALISE, LocaliseFeedback, LocaliseGoal, LocaliseResult
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext


def localise(
    context: TreeContext, name: str = "localise"
) -> Act[LocaliseGoal, LocaliseFeedback, LocaliseResult]:
    """Return the leaf; the start pose is nobody's to know beforehand, so there is no hint."""
    return Act(name, context, LOCALISE, LocaliseGoal, resources=("base",))
