"""The keeper of a mocked robot: it believes what is seen, and takes in what skills tell of the scene."""

from __future__ import annotations

import math
from typing import Protocol

from tandem.skills.ports.actions.world import EditGoal, EditResult, SceneEdit
from tandem.skills.ports.pose import IDENTITY
from tandem.skills.ports.site import Site
from tandem.skills.ports.skill import Outcome, succeeded
from tandem.skills.ports.world import HeldItem, ItemFact, Placed, Sighting, WorldState


class _Believing(Protocol):
    """The robot whose beliefs they are."""

    world: WorldState

    def believe(self, **changes: object) -> None:
        """Change facts and tell."""
        ...


class MockKeeper:
    """What ``MockRobot`` believes with.

    Args:
        robot: whose.
        site: sizes and shapes of the items.
    """

    def __init__(self, robot: _Believing, site: Site) -> None:
        self._robot, self._site = robot, site

    def take_in(self, sightings: tuple[Sighting, ...]) -> None:
        """Believe that these items stand where they are seen."""
        known = {fact.item: fact for fact in self._robot.world.items}
        for sighting in sightings:
            site_item = self._site.item(sighting.item)
            known[sighting.item] = ItemFact(
                item=sighting.item,
                size=(0.06, 0.06, 0.06) if site_item is None else site_item.size,
                shape="box" if site_item is None else site_item.shape,
                tag_in_map=sighting.tag_in_map,
                seen=sighting.stamp,
                quality=1.0,
                position_sigma=0.002,
            )
        self._robot.believe(items=tuple(known.values()))

    def edit(self, goal: EditGoal) -> Outcome[EditResult]:
        """Change what is held, placed, known, or meant."""
        if goal.edit is SceneEdit.SELECT and goal.near is not None:
            return self._select(goal.item, goal.near)
        held = {hand.item: hand for hand in self._robot.world.held}
        placed = {each.item: each for each in self._robot.world.placed}
        if goal.edit is SceneEdit.ATTACH and goal.side is not None:
            pose = goal.item_in_tool or IDENTITY
            held[goal.item] = HeldItem(side=goal.side, item=goal.item, item_in_tool=pose)
        elif goal.edit is SceneEdit.DETACH:
            held.pop(goal.item, None)
            if goal.depot is not None and goal.slot is not None:
                placed[goal.item] = Placed(item=goal.item, depot=goal.depot, slot=goal.slot)
        forgotten = goal.item if goal.edit is SceneEdit.FORGET else None
        items = tuple(
            fact.model_copy(update={"held": held[fact.item].side if fact.item in held else None})
            for fact in self._robot.world.items
            if fact.item != forgotten
        )
        self._robot.believe(items=items, held=tuple(held.values()), placed=tuple(placed.values()))
        return succeeded(EditResult(version=self._robot.world.version))

    def _select(self, item: int, near: tuple[float, float]) -> Outcome[EditResult]:
        there = self._robot.world.those(item)
        first, *others = sorted(there, key=lambda fact: math.dist(fact.tag_in_map.position[:2], near))
        items = tuple(first if fact.item == item else fact for fact in self._robot.world.items)
        strangers = tuple(fact for fact in self._robot.world.doubles if fact.item != item)
        self._robot.believe(items=items, doubles=(*strangers, *others))
        return succeeded(EditResult(version=self._robot.world.version))
