"""Does the robot know where it is?"""

from __future__ import annotations

from tandem.trees.behaviours.check import Check
from tandem.trees.context import TreeContext


def localised(context: TreeContext) -> Check:
    """Return the condition "the robot is localised"."""
    return Check("localised?", lambda: context.knowledge.robot_localised)
