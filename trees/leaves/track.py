"""Tell where the items are from each picture, for as long as it is let run: document 002, 4.2."""

from __future__ import annotations

from skills.ports.actions.perception import TRACK, LookFeedback, TrackGoal, TrackResult
from trees.behaviours.act import Lasting
from trees.context import TreeContext


def track(name: str, context: TreeContext) -> Lasting[TrackGoal, LookFeedback, TrackResult]:
    """Return the leaf: all items, since whatever stands there is an obstacle; the head must not turn."""
    return Lasting(name, context, TRACK, TrackGoal, resources=("head",))
