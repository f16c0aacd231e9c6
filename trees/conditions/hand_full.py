"""Is something in a hand?"""

from __future__ import annotations

from collections.abc import Callable

from skills.ports.world import Side
from trees.behaviours.check import Check
from trees.context import TreeContext


def hand_full(name: str, context: TreeContext, side: Callable[[], Side]) -> Check:
    """Return the condition "the hand of this side is believed to hold something"."""

    def holds() -> bool:
        world = context.knowledge.world
        return world is not None and world.in_hand(side()) is not None

    return Check(name, holds)
