"""Things with a number that another thing has, too: known apart from it, and told apart from it.

The site has one item of a number. A second tag of that number in the room (a label printed twice, last week's
box) makes "item 29" ambiguous. One of them is *the* item for all skills; the others are doubles: obstacles,
and a reason for trees to ask which one is meant.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Sequence
from typing import Final

from tandem.skills.ports.message import RobotTime, Vector3
from tandem.skills.ports.world import Box, ItemFact

MOST: Final = 8
"""Doubles of one number that are kept, the newest: more are a mistake, and each is an obstacle to check."""
A_LOOK: Final = 30.0
"""Robot seconds that a look lasts at the most (``LOOK.timeout``): what one of its views shows is not gone
because the next one looks elsewhere."""


class Doubles:
    """The doubles of all items, by number and newest last."""

    def __init__(self, facts: Iterable[ItemFact] = ()) -> None:
        self._facts: dict[int, tuple[ItemFact, ...]] = {}
        for fact in facts:
            self._facts[fact.item] = (*self._facts.get(fact.item, ()), fact)

    @property
    def facts(self) -> tuple[ItemFact, ...]:
        """All of them, by number."""
        return tuple(fact for number in sorted(self._facts) for fact in self._facts[number])

    def of(self, number: int) -> tuple[ItemFact, ...]:
        """Return those of a number."""
        return self._facts.get(number, ())

    def put(self, number: int, facts: Sequence[ItemFact]) -> None:
        """Have these be all doubles of a number, the newest last."""
        self._facts[number] = tuple(facts[-MOST:])
        if not facts:
            del self._facts[number]

    def looked_through(self, shown: Collection[Box], boxes: Sequence[Box], stamp: RobotTime) -> bool:
        """Forget those whose box was wholly in view, in a look that ended at ``stamp``, and not seen again.

        ``boxes`` are those of ``facts``, in their order. Say whether one was forgotten.
        """
        gone = [
            fact
            for fact, box in zip(self.facts, boxes, strict=True)
            if box in shown and ((age := stamp.since(fact.seen)) is None or age > A_LOOK)
        ]
        for fact in gone:
            self.put(fact.item, [each for each in self.of(fact.item) if each is not fact])
        return bool(gone)


def matched(known: Sequence[Vector3], seen: Sequence[Vector3]) -> dict[int, int]:
    """Return which known thing each seen one is: one each, the nearest pairs first.

    As few things as explain what is seen: a place that fits none of the known is that of one that was moved,
    unless all of them are seen.
    """
    pairs = sorted(
        (math.dist(here, there), i, j) for i, here in enumerate(seen) for j, there in enumerate(known)
    )
    found: dict[int, int] = {}
    for _, i, j in pairs:
        if i not in found and j not in found.values():
            found[i] = j
    return found
