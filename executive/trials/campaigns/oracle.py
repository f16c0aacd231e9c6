"""Judges a lockstep run by the truth: what a person would see who had watched all of it.

A task's own word is not asked here but for the slot that it reports.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from tandem.sim.disturbances import Disturbances
from tandem.sim.truth import Truth, lies_on
from tandem.skills.geometry.poses import distance, floor_distance, to_floor, wrap
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import WORLD

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tandem.executive.system.systems import LockstepSystem
    from tandem.skills.ports.site import Site

IN_SLOT: Final = 0.05
"""Metres from its slot within which an item lies in it: the lab's slots are 0.156 m apart at the least."""
HOME_WITHIN: Final = 0.10
"""Metres from home at which the base is at home: the tree's own 0.06 m, and the localiser's error."""
HOME_TURNED: Final = math.radians(8.0)
"""Rad likewise: the tree's 5 degrees, and the localiser's error."""
ARM_AT_HOME: Final = 0.05
"""Rad by which a joint may be off its posture: what the arm's motion allows itself."""
REST: Final = 1.0
"""Robot seconds over which the robot must stand still after the end."""
STILL: Final = 0.01
"""Metres (base) and rad/s (joints) that count as standing still."""
STOOD: Final = 1.0
"""Robot seconds for which the base has stood when a person's running into it is not its doing."""


@dataclass(frozen=True)
class Verdict:
    """What was wrong in truth, each in words; nothing where it was not asked for.

    ``misplaced``: the item is not in the slot that was reported. ``moved``: other things that moved or fell.
    ``untouched``: those of them that neither the robot nor what it held ever touched. ``touched``: furniture
    that the robot touched. ``people``: whom it touched while it moved, or had stood for less than a second,
    a person or another robot. ``not_home``: base or arms are elsewhere. ``restless``: it still moves.
    """

    misplaced: tuple[str, ...]
    moved: tuple[str, ...]
    untouched: tuple[str, ...]
    touched: tuple[str, ...]
    people: tuple[str, ...]
    not_home: tuple[str, ...]
    restless: tuple[str, ...]

    @property
    def disturbed(self) -> tuple[str, ...]:
        """What the robot did to the room."""
        return tuple(each for each in self.moved if each not in self.untouched) + self.touched + self.people

    @property
    def wrong(self) -> tuple[str, ...]:
        """All of it: nothing, when the run is right."""
        return self.misplaced + self.moved + self.touched + self.people + self.not_home + self.restless


class Oracle:
    """Watches a run from its begin. It sends nothing, so that the run's digest stays the same.

    Args:
        system: what runs; it is watched after each period.
        site: furniture, slots, home.
        item: the item asked for.
        depot: where it is to be brought.
    """

    name = "oracle"

    def __init__(self, system: LockstepSystem, site: Site, item: int, depot: str) -> None:
        self._system, self._site, self._item, self._depot = system, site, item, depot
        station = system.lockstep.station
        self._station = station
        self._world = Latest(system.bus, WORLD)
        self._seen = Disturbances(station.world, station.body, item)
        system.lockstep.nodes.append(self)

    def step(self) -> bool:
        """Look at the physics of this period."""
        self._seen.step(robot_seconds(self._system.clocks))
        return False

    def close(self) -> None:
        """Stop watching."""
        self._world.close()
        self._seen.close()

    def slot(self) -> int | None:
        """Return the slot in which the item is reported to lie, or None."""
        world = self._world.refresh()
        placed = () if world is None else world.placed
        asked = (self._item, self._depot)
        return next((each.slot for each in placed if (each.item, each.depot) == asked), None)

    def verdict(self) -> Verdict:
        """Let a second pass, in which the robot must stand still, and judge."""
        restless = tuple(self._moving())
        truth, shifts = self._station.truth(), self._seen.shifts()
        return Verdict(
            misplaced=misplaced(truth, self._site, self._item, self._depot, self.slot()),
            moved=tuple(str(each) for each in shifts),
            untouched=tuple(str(each) for each in shifts if not each.robots_doing),
            touched=tuple(str(each) for each in self._seen.touches()),
            people=bumped(truth),
            not_home=(*_off_home(truth.base_in_map, self._site), *self._arms_out()),
            restless=restless,
        )

    def _moving(self) -> Iterator[str]:
        before = self._station.truth().base_in_map
        for _ in range(round(REST / self._system.lockstep.period)):
            self._system.advance()
        moved = distance(before, self._station.truth().base_in_map)
        if moved >= STILL:
            yield f"the base moves by {moved:.3f} m in the {REST:g} s after the end"
        for group in self._station.model.description.groups:
            speeds = [abs(each.velocity) for each in self._station.body.read(group.joints)]
            if max(speeds) >= STILL:
                yield f"{group.name} moves at {max(speeds):.3f} rad/s {REST:g} s after the end"

    def _arms_out(self) -> Iterator[str]:
        description = self._station.model.description
        arms = {hand.group for hand in description.end_effectors}
        for posture in description.postures:
            if posture.name != "home" or posture.group not in arms:
                continue
            joints = description.group(posture.group).joints
            readings = self._station.body.read(joints)
            off = max(
                abs(reading.position - at) for reading, at in zip(readings, posture.positions, strict=True)
            )
            if off > ARM_AT_HOME:
                yield f"{posture.group} is {off:.2f} rad off its posture at home"


def misplaced(truth: Truth, site: Site, item: int, depot: str, slot: int | None) -> tuple[str, ...]:
    """Return in words why an item does not lie in the depot's slot that was reported; nothing if it does."""
    try:
        if not lies_on(truth, site, item, depot):
            return (f"item {item} does not lie in the {depot}",)
    except KeyError:  # somebody took it away
        return (f"there is no item {item}",)
    slots = () if (known := site.depot(depot)) is None else known.slots
    if slot is None or slot >= len(slots):
        return (f"item {item} lies in the {depot}, and no slot was reported",)
    x, y, _ = truth.item(item).pose.position
    off = math.dist((x, y), slots[slot].position[:2])
    if off <= IN_SLOT:
        return ()
    nearest = min(range(len(slots)), key=lambda each: math.dist((x, y), slots[each].position[:2]))
    return (f"item {item} lies {off:.3f} m from slot {slot}, which was reported, and next to slot {nearest}",)


def bumped(truth: Truth) -> tuple[str, ...]:
    """Return in words whom a robot touched while it moved, or had stood for less than a second."""

    def how(stood: float) -> str:
        return f"had stood for {stood:.2f} s" if stood > 0.0 else "moved"

    return tuple(
        f"{each.robot} touches {each.person} at {each.at:.2f} s, when it {how(each.stood)}"
        for each in truth.touches
        if each.stood < STOOD
    )


def _off_home(base: Pose, site: Site) -> Iterator[str]:
    here = to_floor(base)
    away, turned = floor_distance(here, site.home), abs(wrap(here.yaw - site.home.yaw))
    if away > HOME_WITHIN or turned > HOME_TURNED:
        yield f"the base is {away:.2f} m and {math.degrees(turned):.0f} degrees from home"
