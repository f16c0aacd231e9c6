"""What is believed: items, hands, slots and clutter, and what changes them. No bus, no clock, no disk."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import distance
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.ports.message import HandName, RobotTime, Vector3
from tandem.skills.ports.occupancy import Occupancy
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import Site, SiteItem
from tandem.skills.ports.world import (
    Box,
    Clutter,
    HeldItem,
    ItemFact,
    Placed,
    PlanningScene,
    SceneObject,
    Sighting,
    WorldState,
)
from tandem.skills.world import object_recorder, resting
from tandem.skills.world.doubles import Doubles, matched
from tandem.skills.world.item_facts import fact_of, item_box
from tandem.skills.world.journal import Remembered
from tandem.skills.world.untagged import Untagged

MOVED: Final = 0.02
"""Metres between two sightings from which on the item has moved, however badly it is seen now."""
MUCH_WORSE: Final = 0.5
"""A sighting of less than this share of the old one's quality waits until the old one has aged."""
AGED: Final = 10.0
"""Robot seconds after which any newer sighting is preferred."""
OUT_OF_SLOT: Final = 0.15
"""Metres from its slot from which on a placed item lies there no more."""
VERSIONS_A_START: Final = 1_000_000_000
"""Versions that one start of the keeper may use up. A version that came again after a new start would let a
changed scene pass for the one that a plan was checked against."""
PUT_DOWN_SIGMA: Final = 0.01
"""Metres: how well the place of an item that was put down is known."""


@dataclass(frozen=True)
class Saved:
    """What an edit may change, as it was before."""

    items: dict[int, ItemFact]
    held: dict[HandName, HeldItem]
    placed: dict[int, Placed]
    removed: set[int]
    doubles: tuple[ItemFact, ...]


class Beliefs:
    """The facts of one robot at one site. ``version`` rises with each change.

    Args:
        site: items, furniture and depots.
        remembered: what a journal gave back.
    """

    def __init__(self, site: Site, remembered: Remembered | None = None) -> None:
        self.site = site
        kept = remembered or Remembered()
        self.version = 1 + kept.openings * VERSIONS_A_START
        self._items: dict[int, ItemFact] = {fact.item: fact for fact in kept.items}
        self._held: dict[HandName, HeldItem] = {held.side: held for held in kept.held}
        self._placed: dict[int, Placed] = {placed.item: placed for placed in kept.placed}
        self._removed: set[int] = set(kept.removed)
        self._doubles = Doubles(kept.doubles)
        cells = site.occupancy is not None and site.occupancy.replaces_clutter
        self._untagged = Untagged(kept.clutter, cells_for_clutter=cells)
        self._boot = kept.boot
        self._furniture = tuple(
            SceneObject(name=f"{each.name}_{i}", kind="furniture", box=box_in_map(box))
            for each in site.furniture
            for i, box in enumerate(each.boxes)
        )

    def saved(self) -> Saved:
        """Return what ``restore`` takes back."""
        return Saved(
            dict(self._items), dict(self._held), dict(self._placed), set(self._removed), self._doubles.facts
        )

    def restore(self, saved: Saved) -> None:
        """Have what was edited since ``saved`` not have happened.

        The version rises all the same: nobody has heard of what was undone, but two states never share one.
        """
        self._items, self._held = dict(saved.items), dict(saved.held)
        self._placed, self._removed = dict(saved.placed), set(saved.removed)
        self._doubles = Doubles(saved.doubles)
        self.version += 1

    def item(self, number: int) -> ItemFact | None:
        """Return what is known of the item, or None."""
        return self._items.get(number)

    def in_hand(self, side: HandName) -> HeldItem | None:
        """Return what is in the hand, or None."""
        return self._held.get(side)

    def hand_of(self, number: int) -> HandName | None:
        """Return the hand that the item is in, or None."""
        return next((side for side, held in sorted(self._held.items()) if held.item == number), None)

    def slot_of(self, number: int) -> Placed | None:
        """Return where the item was put down, or None."""
        return self._placed.get(number)

    def in_slot(self, depot: str, slot: int) -> int | None:
        """Return the item that lies in the slot, or None."""
        return next(
            (item for item, at in sorted(self._placed.items()) if (at.depot, at.slot) == (depot, slot)), None
        )

    def see(self, sighting: Sighting) -> bool:
        """Take in a sighting; say whether it changed anything.

        Newer replaces older, unless it is much worse, the item has not moved, and the older one is fresh. An
        item in a hand is where the hand is: sightings of it are passed over.
        """
        item = self.site.item(sighting.item)
        if item is None or self.hand_of(sighting.item) is not None:
            return False
        sighting = self._on_top(sighting, item)
        if not self._better(sighting):
            return False
        self._items = object_recorder.update(self._items, {sighting.item: fact_of(sighting, item)})
        box = item_box(sighting.tag_in_map, item)
        self._removed.discard(sighting.item)
        self._untagged.recognise(box)
        if self._left_its_slot(sighting.item, box.pose.position):
            del self._placed[sighting.item]
        self.version += 1
        return True

    def see_together(self, sightings: Sequence[Sighting]) -> bool:
        """Take in what one message tells of one number, best first; say whether it changed anything.

        Each sighting is that of the nearest thing known. Those that are left over are doubles.
        """
        number = sightings[0].item
        item, mine, doubles = self.site.item(number), self._items.get(number), self._doubles.of(number)
        if item is None or self.hand_of(number) is not None:
            return False
        if len(sightings) == 1 and not doubles:
            return self.see(sightings[0])
        sightings = [self._on_top(each, item) for each in sightings]
        if mine is None:
            mine, doubles = (doubles[0], doubles[1:]) if doubles else (fact_of(sightings[0], item), ())
            self._items[number] = mine
        known = [mine, *doubles]
        places = [item_box(fact.tag_in_map, fact).pose.position for fact in known]
        seen = [item_box(each.tag_in_map, item).pose.position for each in sightings]
        which = matched(places, seen)
        for index, sighting in enumerate(sightings):
            if which.get(index) == 0:
                self.see(sighting)
                continue
            known.append(fact_of(sighting, item))
            self._untagged.recognise(item_box(sighting.tag_in_map, item))
        told_anew = set(which.values())
        self._doubles.put(number, [each for at, each in enumerate(known) if at and at not in told_anew])
        self.version += 1
        return True

    def those(self, number: int) -> tuple[ItemFact, ...]:
        """Return all things known of a number: the item first, then its doubles."""
        mine = self._items.get(number)
        return (*(() if mine is None else (mine,)), *self._doubles.of(number))

    def select(self, number: int, near: tuple[float, float]) -> None:
        """Have the thing of that number which stands nearest to a point of the map (m) be the item."""
        first, *others = sorted(
            self.those(number), key=lambda fact: math.dist(fact.tag_in_map.position[:2], near)
        )
        self._items[number] = first
        self._doubles.put(number, others)
        self.version += 1

    def miss(self, number: int, stamp: RobotTime) -> bool:
        """Forget where the item stands: a picture of ``stamp`` proves it gone. Say whether it was known.

        A double of it is the item then.
        """
        fact = self._items.get(number)
        if fact is None or self.hand_of(number) is not None:
            return False
        if stamp.is_after(fact.seen) is False:
            return False
        doubles = self._doubles.of(number)
        changed = self.forget(number)
        if doubles:
            self._items[number] = doubles[0]
            self._doubles.put(number, doubles[1:])
        return changed

    def forget(self, number: int) -> bool:
        """Forget where the item stands, and its doubles; say whether it was known.

        What is in a hand stays there.
        """
        if self.hand_of(number) is not None:
            return False
        self._doubles.put(number, ())
        known = self._items.pop(number, None) is not None
        if self._placed.pop(number, None) is None and not known:
            return False
        self._removed.discard(number)
        self.version += 1
        return True

    def look(self, seen: Clutter) -> bool:
        """Take in the clutter of a look; say whether it changed anything."""
        doubled = [box for _, box in self._doubled()]
        changed = self._untagged.look(seen, [*self._standing().values(), *doubled])
        forgotten = self._doubles.looked_through(seen.view, doubled, seen.stamp)
        if not changed and not forgotten:
            return False
        self.version += 1
        return True

    def occupy(self, told: Occupancy) -> bool:
        """Take in which space is occupied; say whether that changed anything."""
        changed = self._untagged.occupy(told)
        if changed:
            self.version += 1
        return changed

    def wake(self, boot: str) -> tuple[HandName, ...]:
        """Take in which boot of the hardware this is; return the hands that were full before it.

        Nobody knows what happened in the room while the hardware was off, so nothing that stood about is
        believed any more, placed items included: the camera sees them again. What is in a hand stays
        believed until the hand tells that it is empty.
        """
        if boot == self._boot:
            return ()
        held = {each.item for each in self._held.values()}
        self._items = {number: fact for number, fact in self._items.items() if number in held}
        self._placed.clear()
        self._removed.clear()
        self._doubles = Doubles()
        self._untagged.forget()
        self._boot = boot
        self.version += 1
        return tuple(sorted(self._held))

    def add(self, number: int) -> None:
        """Make the item an obstacle where it was last seen."""
        self._removed.discard(number)
        self.version += 1

    def remove(self, number: int) -> None:
        """Make the item no obstacle, until it is added or seen again."""
        self._removed.add(number)
        self.version += 1

    def attach(self, number: int, side: HandName, item_in_tool: Pose, now: RobotTime) -> None:
        """Put the item into the hand."""
        thing = self._known(number)
        self._held[side] = HeldItem(side=side, item=number, item_in_tool=item_in_tool)
        self._placed.pop(number, None)
        self._removed.discard(number)
        known = self._items.get(number) or ItemFact(
            item=number,
            size=thing.size,
            shape=thing.shape,
            tag_in_map=Pose(),
            seen=now,
            quality=0.0,
            position_sigma=0.0,
        )
        self._items[number] = known.model_copy(update={"held": side})
        self.version += 1

    def detach(
        self, number: int, item_in_map_now: Pose | None, placed: Placed | None, now: RobotTime
    ) -> None:
        """Take the item out of its hand: put down at a pose, or lost (then nobody knows where it is)."""
        side = self.hand_of(number)
        if side is not None:
            del self._held[side]
        if item_in_map_now is None:
            self._items.pop(number, None)
        else:
            thing = self._known(number)
            self._items[number] = ItemFact(
                item=number,
                size=thing.size,
                shape=thing.shape,
                tag_in_map=tag_of_item(item_in_map_now, thing.size[0]),
                seen=now,
                quality=0.5,
                position_sigma=PUT_DOWN_SIGMA,
            )
        if placed is not None:
            self._placed[number] = placed
        self.version += 1

    def state(self, now: RobotTime) -> WorldState:
        """Return the facts."""
        return WorldState(
            stamp=now,
            version=self.version,
            items=tuple(self._items[number] for number in sorted(self._items)),
            held=tuple(self._held[side] for side in sorted(self._held)),
            placed=tuple(self._placed.values()),
            doubles=self._doubles.facts,
        )

    def scene(self, now: RobotTime) -> PlanningScene:
        """Return what arms must not hit."""
        standing, doubled = self._standing(), self._doubled()
        things = [
            SceneObject(name=name, kind="clutter", box=box) for name, box in (*self._untagged.boxes, *doubled)
        ]
        for number, box in standing.items():
            if number not in self._removed:
                things.append(SceneObject(name=f"item_{number}", kind="item", box=box, item=number))
        for side, held in sorted(self._held.items()):
            thing = self._known(held.item)
            box = Box(size=thing.size, pose=held.item_in_tool, shape=thing.shape)
            name = f"item_{held.item}"
            things.append(SceneObject(name=name, kind="item", box=box, item=held.item, attached_to=side))
        return PlanningScene(
            stamp=now,
            version=self.version,
            objects=(*self._furniture, *things),
            # An item may have been recognised since the cells were measured.
            occupied=self._untagged.occupied_but_for((*standing.values(), *(box for _, box in doubled))),
        )

    @property
    def firm(self) -> tuple[tuple[HeldItem, ...], tuple[Placed, ...]]:
        """What no sensor can restore: what is in which hand, and what lies in which slot."""
        return tuple(self._held[side] for side in sorted(self._held)), tuple(self._placed.values())

    def remembered(self, written_at: float) -> Remembered:
        """Return what a journal keeps; ``written_at`` is UTC seconds."""
        held, placed = self.firm
        return Remembered(
            written_at=written_at,
            held=held,
            placed=placed,
            items=tuple(self._items[number] for number in sorted(self._items)),
            removed=tuple(sorted(self._removed)),
            clutter=self._untagged.boxes,
            doubles=self._doubles.facts,
            boot=self._boot,
        )

    def _better(self, sighting: Sighting) -> bool:
        old = self._items.get(sighting.item)
        age = None if old is None else sighting.stamp.since(old.seen)
        if old is None or age is None:  # what was seen in another boot is older, whatever its seconds say
            return True
        if age < 0.0:
            return False
        before, after = (item_box(tag, old).pose for tag in (old.tag_in_map, sighting.tag_in_map))
        moved = distance(before, after) > MOVED
        return moved or age > AGED or sighting.quality >= MUCH_WORSE * old.quality

    def _on_top(self, sighting: Sighting, item: SiteItem) -> Sighting:
        return resting.on_top(sighting, item, (each.box for each in self._furniture))

    def _left_its_slot(self, number: int, centre: Vector3) -> bool:
        placed = self._placed.get(number)
        depot = None if placed is None else self.site.depot(placed.depot)
        if placed is None or depot is None or placed.slot >= len(depot.slots):
            return False
        slot = depot.slots[placed.slot].position
        return math.dist(slot[:2], centre[:2]) > OUT_OF_SLOT or abs(centre[2] - slot[2]) > 2 * OUT_OF_SLOT

    def _standing(self) -> dict[int, Box]:
        """Return the boxes of the items that stand somewhere, by item (two-arm thesis, Algorithm 1)."""
        held = {each.item for each in self._held.values()}
        facts = object_recorder.scene(self._items, held)
        return {number: item_box(fact.tag_in_map, fact) for number, fact in facts.items()}

    def _doubled(self) -> list[tuple[str, Box]]:
        """Return the doubles' boxes with their names; no skill is to take one for the item."""
        return [
            (f"item_{fact.item}_double_{number}", item_box(fact.tag_in_map, fact))
            for number, fact in enumerate(self._doubles.facts, start=1)
        ]

    def _known(self, number: int) -> SiteItem:
        item = self.site.item(number)
        if item is None:
            raise KeyError(f"no item {number} at site {self.site.name}")
        return item
