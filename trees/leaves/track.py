"""Tell where the items are from each picture, for as long as it is let run: two-arm thesis, 4.3."""

from __future__ import annotations

from tandem.skills.ports.actions.perception import TRACK, LookFeedback, TrackGoal, TrackResult
from tandem.trees.behaviours.act import Lasting
from tandem.trees.context import TreeContext


def track(
    name: str, context: TreeContext, gaze: tuple[int, ...]
) -> Lasting[TrackGoal, LookFeedback, TrackResult]:
    """Return the leaf: all items, since whatever stands there is an obstacle.

    Args:
        name: unique in the tree.
        context: the task's surroundings.
        gaze: the items that the head follows; it is nobody else's meanwhile.
    """
    return Lasting(name, context, TRACK, lambda: TrackGoal(gaze=gaze), resources=("head",))
