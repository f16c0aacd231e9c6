"""What the leaves of one hand's pick hand to each other."""

from __future__ import annotations

from dataclasses import dataclass, field

from tandem.skills.geometry.poses import compose, invert, to_pose, turned, yaw_of
from tandem.skills.grasping.hand_grasps import HandGrasp, item_grasps, item_in_tool, side_grasps
from tandem.skills.grasping.item_frames import standing_in_map, turned_like
from tandem.skills.grasping.tag_grasps import FINGER_ROOM
from tandem.skills.grasping.turns import of_every_side
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.shapes import solid
from tandem.skills.ports.world import ItemFact
from tandem.trees.context import TreeContext
from tandem.trees.hand_task import HandTask
from tandem.trees.item_failures import lies


@dataclass(eq=False)
class HandBoard(HandTask):
    """A hand and the item that it is for."""

    side: HandName
    item: int
    ways: tuple[HandGrasp, ...] = ()
    """The ways to take hold that were offered to the last approach, the preferred one first."""
    way: HandGrasp | None = None
    """The one that was taken."""
    turn: float = 0.0
    """Radians by which it was turned about the item: an arm of few joints needs that."""
    item_at: Pose | None = None
    """The item's centre in the map when the hand closed around it."""
    frame: Pose | None = None
    """The item's frame in the map that its ways were told in."""
    avoid: list[tuple[int, float]] = field(default_factory=list)
    """Sides and pitches that have been tried in vain."""
    safe: bool = True
    """Whether the hand is where it is in nobody's way."""

    @property
    def who(self) -> str:
        """The arm, in words."""
        return f"{self.side} arm"

    @property
    def group(self) -> str:
        """The arm's joint group."""
        return f"arm_{self.side}"

    def chosen_side(self) -> HandName:
        """Return the arm."""
        return self.side

    def node(self, what: str) -> str:
        """Return the name with the arm's before it: a tree may have both hands at work."""
        return f"{self.who}: {what}"

    def item_in_tool(self) -> Pose:
        """Return the item's centre frame in the tool as it was grasped."""
        return item_in_tool(self.chosen())

    def attached(self) -> None:
        """Note nothing: the hand and its way stay as they are."""

    def fact(self, context: TreeContext) -> ItemFact | None:
        """Return what is believed of the item, or None."""
        world = context.knowledge.world
        return None if world is None else world.item(self.item)

    def held(self, context: TreeContext) -> bool:
        """Say whether this hand is believed to hold the item."""
        world = context.knowledge.world
        held = None if world is None else world.in_hand(self.side)
        return held is not None and held.item == self.item

    def standing(self, context: TreeContext) -> Pose | Failure:
        """Return the item's centre frame in the map, or why it is not known.

        Whichever of its faces was seen, the frame is the one that the ways to take hold were told in.
        """
        fact = self.fact(context)
        if fact is None or fact.held is not None:
            return Failure(
                kind=FailureKind.ITEM_GONE, message=f"{context.called(self.item)} is not known to stand"
            )
        frame = standing_in_map(fact.tag_in_map, fact)
        if frame is None:
            return lies(context, fact)
        return frame if self.frame is None else turned_like(frame, self.frame)

    def offer(self, context: TreeContext) -> Failure | None:
        """Work out the ways to take hold of the item as it stands; return why there are none."""
        self.frame = None
        item, description = self.standing(context), context.knowledge.description
        if isinstance(item, Failure):
            return item
        self.frame = item
        assert description is not None, "the robot is ready only when it has told who it is"
        hand = description.end_effector(self.side)
        base_heading = 0.0 if context.knowledge.robot is None else context.knowledge.robot.base_in_map.yaw
        known, turned = self.site_item(context), yaw_of(item.orientation)
        if known.needs_two:
            point = next(each for each in known.grasp_points if each.side == self.side)
            ways = side_grasps(point, base_heading - turned)
        else:
            ways = item_grasps(solid(known), hand.work_heading + base_heading - turned)
        # What was tried in vain comes last: it may still be all that there is.
        self.ways = tuple(sorted(ways, key=lambda way: (way.face, way.pitch) in self.avoid))
        return None

    def choose(self, number: int, turned: float) -> None:
        """Note which of the ways was taken, and by how much (rad) it was turned about the item."""
        self.way, self.turn = self.ways[number], turned

    def chosen(self) -> HandGrasp:
        """Return the way that was taken; the approach has chosen it."""
        assert self.way is not None, "the approach chooses the way first"
        return self.way

    def tool_at(self, item: Pose) -> Pose:
        """Return the tool that takes an item there in the chosen way, in the frame of ``item``.

        An item that the fingers have turned until it lies flat between them is held as if nothing had been
        turned: ``item_in_tool`` is not.
        """
        return turned(compose(item, self.chosen().tool_in_item), item.position, self.turn)

    def most_turn(self, context: TreeContext) -> float:
        """Return by how much (rad) the ways may be turned about the item."""
        known, robot = self.site_item(context), context.knowledge.description
        if known.needs_two or robot is None:
            return 0.0
        return of_every_side(solid(known), robot.end_effector(self.side).gripper.max_width)

    def open_width(self, context: TreeContext) -> float:
        """Return the metres to which the hand opens: room for the fingers and no more; 0 if it presses."""
        known = self.site_item(context)
        if known.needs_two:
            return 0.0
        return known.size[1] + 2 * FINGER_ROOM

    def give_up_way(self) -> str:
        """Note that the way that was taken is tried again only when no other helps; return so in words."""
        if self.way is not None:
            self.avoid.append((self.way.face, self.way.pitch))
        return f"{len(self.avoid)} ways to take hold are tried last"

    def in_base(self, context: TreeContext) -> tuple[float, float, float] | None:
        """Return the item's centre in the base (m), or None while it is not known."""
        item, robot = self.standing(context), context.knowledge.robot
        if isinstance(item, Failure) or robot is None:
            return None
        return compose(invert(to_pose(robot.base_in_map)), item).position
