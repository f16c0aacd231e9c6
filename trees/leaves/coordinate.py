"""Have both arms coordinated for as long as it is let run: two-arm thesis, 4.3.1."""

from __future__ import annotations

from typing import Literal

from tandem.skills.ports.actions.bimanual import (
    COORDINATE,
    CoordinateFeedback,
    CoordinateGoal,
    CoordinateResult,
)
from tandem.trees.behaviours.act import Lasting
from tandem.trees.context import TreeContext

Mode = Literal["faithful", "eager"]


def coordinate(
    name: str, context: TreeContext, mode: Mode
) -> Lasting[CoordinateGoal, CoordinateFeedback, CoordinateResult]:
    """Return the leaf."""
    return Lasting(name, context, COORDINATE, lambda: CoordinateGoal(mode=mode))
