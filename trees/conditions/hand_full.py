"""Is something in a hand?"""

from __future__ import annotations

from collections.abc import Callable

from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.check import Check
from tandem.trees.context import TreeContext


def hand_full(name: str, context: TreeContext, side: Callable[[], HandName]) -> Check:
    """Return the condition "the hand of this side may hold something": unless it is known to be empty."""
    return Check(name, lambda: context.knowledge.may_hold(side()))
