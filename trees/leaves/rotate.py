"""Turn on the spot, a step of the search."""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.ports.actions.base import ROTATE, RotateFeedback, RotateGoal, RotateResult
from tandem.trees.behaviours.act import Act
from tandem.trees.context import TreeContext

STEP: Final = -math.radians(30.0)
"""Clockwise, as in the order-picking paper, III-A.2."""
ALL_AROUND: Final = round(math.tau / abs(STEP))
"""Turns after which the robot stands as it stood."""


def rotate(name: str, context: TreeContext) -> Act[RotateGoal, RotateFeedback, RotateResult]:
    """Return the leaf."""
    return Act(name, context, ROTATE, lambda: RotateGoal(angle=STEP), resources=("base",))
