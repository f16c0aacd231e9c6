"""Has the item that a motion was planned for been moved since?"""

from __future__ import annotations

import math

from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.world import WORLD, WorldState


class FollowedItem:
    """Watches the item that a goal names in ``follows_item``.

    The item's centre counts, not its tag: another side of it may have been seen since.

    Args:
        bus: where the beliefs are.
        where: the action's name, for failures.
    """

    def __init__(self, bus: Bus, where: str) -> None:
        self._world, self._where = Latest(bus, WORLD), where
        self._item: int | None = None
        self._tolerance = 0.0
        self._planned_for: Vector3 | None = None

    def begin(self, goal: MoveGoal) -> None:
        """Note where the item is; the plan is made now."""
        self._item, self._tolerance = goal.follows_item, goal.follow_tolerance
        self._planned_for = self._centre()

    def moved(self) -> Failure | None:
        """Return ITEM_GONE when it is elsewhere than when the plan was made, or nowhere any more."""
        if self._item is None or self._planned_for is None:
            return None
        now = self._centre()
        if now is None:
            return self._gone(f"item {self._item} is not believed to stand anywhere any more")
        way = math.dist(now, self._planned_for)
        if way <= self._tolerance:
            return None
        return self._gone(f"item {self._item} has moved by {way:.3f} m since the plan was made", way)

    def _centre(self) -> Vector3 | None:
        """Return the item's centre in the map; None when it is not believed to stand anywhere."""
        world: WorldState | None = self._world.refresh()
        fact = None if world is None or self._item is None else world.item(self._item)
        if fact is None or fact.held is not None:
            return None
        stands = standing_in_map(fact.tag_in_map, fact)
        return None if stands is None else stands.position

    def _gone(self, message: str, moved: float = 0.0) -> Failure:
        evidence: dict[str, str | float | bool] = {"moved_m": round(moved, 4)}
        return Failure(kind=FailureKind.ITEM_GONE, message=message, where=self._where, evidence=evidence)
