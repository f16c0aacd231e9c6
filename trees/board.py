"""What the leaves of one task hand to each other.

py_trees' own blackboard is one for the whole process and untyped; a task's board is typed, and gone with it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Final

from tandem.skills.grasping.item_frames import face_towards
from tandem.skills.grasping.tag_grasps import FINGER_ROOM, Grasp, Place
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.site import Depot, Slot
from tandem.skills.ports.world import ItemFact
from tandem.trees.context import TreeContext
from tandem.trees.hand_task import HandTask

NEAR: Final = 0.5
"""Metres: a thing that far from the point that a request names is still meant. It is half a table, about what
an arm reaches from one stand. Of two of a kind within it, the one nearer to the point is meant."""


def is_meant(tag_in_map: Pose, near: tuple[float, float]) -> bool:
    """Say whether a thing stands where a request locates it."""
    return math.dist(tag_in_map.position[:2], near) <= NEAR


@dataclass(eq=False)
class FetchBoard(HandTask):
    """A fetch: what is asked for, and what has been decided so far."""

    item: int
    destination: str
    wanted_arm: HandName | None = None
    side: HandName | None = None
    sides: tuple[HandName, ...] = ()
    """The arms that may be used, the preferred one first."""
    stands: tuple[FloorPose, ...] = ()
    """Base poses from which the arm has been found to reach, the preferred one first."""
    facing: float | None = None
    """Heading (rad) out of the item's face that the hand goes for; the one seen until a stand is chosen."""
    slot: int | None = None
    spot: int = 0
    """Index of the next search spot."""
    grasps: tuple[Grasp, ...] = ()
    grasp: Grasp | None = None
    places: tuple[Place, ...] = ()
    place: Place | None = None
    allowed: tuple[HandName, ...] = ()
    """The arms that the request and the site allow, whatever has been tried since."""
    avoid: list[FloorPose] = field(default_factory=list)
    """Base poses that have been tried in vain."""
    pitches_tried: list[float] = field(default_factory=list)
    """Pitches (rad) of grasps that have failed."""
    slots_taken: set[int] = field(default_factory=set)
    """Slots on which something was found to stand."""
    origin: Slot | None = None
    """Where the item stood when it was picked up."""
    putting_back: bool = False
    """Whether the item goes back to where it stood."""
    near: tuple[float, float] | None = None
    """x, y in the map (m): of several things with the item's number, the one there is meant."""

    def chosen_side(self) -> HandName:
        """Return the arm; the request's leaves have bound it before anything moves."""
        assert self.side is not None, "the request binds the arm first"
        return self.side

    def node(self, what: str) -> str:
        """Return the name as it is: a fetch has one hand."""
        return what

    def item_in_tool(self) -> Pose:
        """Return the item's centre frame in the tool as it was grasped."""
        return self.chosen_grasp().item_in_tool

    def attached(self) -> None:
        """Keep to the arm that holds the item, and begin anew with all stands and grasps."""
        self.sides = (self.chosen_side(),)
        self.forget_tries()

    def chosen_grasp(self) -> Grasp:
        """Return the grasp; the pre-grasp has bound it."""
        assert self.grasp is not None, "the pre-grasp binds the grasp first"
        return self.grasp

    def chosen_place(self) -> Place:
        """Return the place poses; the motion above the slot has bound them."""
        assert self.place is not None, "the motion above the slot binds the place first"
        return self.place

    def depot(self, context: TreeContext) -> Depot:
        """Return the destination; the request has checked that it is known."""
        known = context.site.depot(self.destination)
        assert known is not None, "the request is checked against the site first"
        return known

    def chosen_slot(self, context: TreeContext) -> Slot:
        """Return the slot, or where the item stood if it goes back; the request's leaves have bound it."""
        if self.putting_back and self.origin is not None:
            return self.origin
        assert self.slot is not None, "the request binds the slot first"
        return self.depot(context).slots[self.slot]

    def forget_tries(self) -> None:
        """Begin anew with all stands and grasps."""
        self.avoid.clear()
        self.pitches_tried.clear()

    def face_in_map(self, fact: ItemFact) -> Pose:
        """Return the tag on the face that the hand goes for."""
        if self.facing is None:
            return fact.tag_in_map
        return face_towards(fact.tag_in_map, fact.size[0], self.facing)

    def open_width(self, context: TreeContext) -> float:
        """Return the metres to which the hand opens for the item: room for the fingers and no more."""
        return self.site_item(context).size[1] + 2 * FINGER_ROOM

    def palm(self, context: TreeContext) -> float | None:
        """Return how deep an item the chosen hand takes (``Gripper.palm``)."""
        robot = context.knowledge.description
        return None if robot is None else robot.end_effector(self.chosen_side()).gripper.palm

    def fact(self, context: TreeContext) -> ItemFact | None:
        """Return what is believed of the item, or None; with ``near``, of the one that is meant."""
        world = context.knowledge.world
        fact = None if world is None else world.item(self.item)
        if world is None or self.near is None or (fact is not None and fact.held is not None):
            return fact
        near = self.near
        meant = [each for each in world.those(self.item) if is_meant(each.tag_in_map, near)]
        return min(meant, key=lambda each: math.dist(each.tag_in_map.position[:2], near), default=None)
