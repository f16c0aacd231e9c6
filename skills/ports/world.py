"""``world/...``: what the skills believe. Each fact has its source, its time and one owner."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import Field

from tandem.skills.ports.checks import misfit, strange_hands
from tandem.skills.ports.keys import Nothing, Service, Topic
from tandem.skills.ports.message import Count, HandName, Message, RobotTime
from tandem.skills.ports.occupancy import EditMap, MapEdited, Occupancy
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.shapes import ShapeName

Size = Annotated[float, Field(ge=0.0)]
"""Metres (or what the field says), none below zero."""


class RobotPose(Message):
    """Where the robot is; owner: base. 20 Hz and on each change."""

    stamp: RobotTime
    localised: bool
    base_in_map: FloorPose
    odom_in_map: FloorPose
    position_sigma: Size
    """Metres, one standard deviation."""
    yaw_sigma: Size
    """Radians, one standard deviation."""
    moving: bool
    reason: str = ""
    """Why it is not localised."""


class TrackedPerson(Message):
    """A person as the laser sees them. Places are in map (m), speeds along map's x and y (m/s)."""

    id: Count
    """The same for as long as the person is not lost; never used again under this boot."""
    x: float
    y: float
    vx: float
    vy: float
    position_sigma: Size
    """Metres, one standard deviation."""
    radius: Size
    """Metres around (x, y) that the person takes."""
    unseen: Size
    """Robot seconds since a scan showed them."""


class People(Message):
    """Everybody whom the base knows of (perhaps nobody); owner: base. With each scan."""

    stamp: RobotTime
    """When the scan was taken."""
    people: tuple[TrackedPerson, ...]


class Sighting(Message):
    """A tag in a picture; owner: perception."""

    item: Count
    stamp: RobotTime
    """When the picture was taken."""
    tag_in_map: Pose
    tag_in_base: Pose
    tag_in_camera: Pose
    distance: Size
    """Metres from the camera."""
    quality: Annotated[float, Field(ge=0.0, le=1.0)]
    """1 is best: falls with distance, viewing angle, reprojection error and disagreement with the depth."""
    position_sigma: Size
    """Metres, as expected from the tag's size in the picture."""


class Sightings(Message):
    """All tags of one picture (perhaps none). An item listed twice means two objects with one number."""

    stamp: RobotTime
    sightings: tuple[Sighting, ...]
    absent: tuple[Count, ...] = ()
    """Items that should be in view, but the depth shows nothing there."""


class Box(Message):
    """A box: full edge lengths in metres and the pose of its centre; ``shape``: what of it is filled."""

    size: tuple[Size, Size, Size]
    pose: Pose
    shape: ShapeName = "box"


class Clutter(Message):
    """Untagged things measured from depth in the view of one look; boxes in the map. Owner: perception.

    ``view`` is the region (a box in the map) that was looked at: clutter believed in there before and not
    seen again is forgotten.
    """

    stamp: RobotTime
    boxes: tuple[Box, ...]
    view: tuple[Box, ...] = ()


class SceneObject(Message):
    """One object of the planning scene.

    Its ``box.pose`` is in the map, or in the tool frame of the hand that it is attached to.
    """

    name: str
    kind: Literal["furniture", "clutter", "item"]
    box: Box
    item: Count | None = None
    attached_to: HandName | None = None


class PlanningScene(Message):
    """Obstacles for the arms; owner: the keeper. On each change and every second."""

    stamp: RobotTime
    version: Count
    objects: tuple[SceneObject, ...]
    occupied: Occupancy | None = None
    """Space that nothing of this explains, where it is measured."""


class ItemFact(Message):
    """Beliefs about an item.

    ``size``: full edges (m) of the box about it in its frame, whose z is up at rest; it fills that as
    ``shape`` says.
    """

    item: Count
    size: tuple[Size, Size, Size]
    shape: ShapeName = "box"
    tag_in_map: Pose
    """The tag's face last seen; meaningless while held."""
    seen: RobotTime
    quality: float
    position_sigma: Size
    held: HandName | None = None


class Placed(Message):
    """An item that was put down in a slot of a depot."""

    item: Count
    depot: str
    slot: Count


class HeldItem(Message):
    """What is in a hand, and how: the item's centre frame in the hand's tool frame."""

    side: HandName
    item: Count
    item_in_tool: Pose


class WorldState(Message):
    """All facts of the keeper; on each change and every second."""

    stamp: RobotTime
    version: Count
    items: tuple[ItemFact, ...] = ()
    held: tuple[HeldItem, ...] = ()
    placed: tuple[Placed, ...] = ()
    doubles: tuple[ItemFact, ...] = ()
    """Further things that carry the number of one of ``items``, seen apart from it: two of a kind are told as
    two. Arms keep clear of them; ``world/edit`` (SELECT) says which one is the item."""

    def those(self, number: int) -> tuple[ItemFact, ...]:
        """Return all things known of a number: the item first, then its doubles."""
        return tuple(fact for fact in (*self.items, *self.doubles) if fact.item == number)

    def item(self, number: int) -> ItemFact | None:
        """Return what is known of the item, or None."""
        return next((fact for fact in self.items if fact.item == number), None)

    def in_hand(self, side: HandName) -> HeldItem | None:
        """Return what is in the hand, or None."""
        return next((held for held in self.held if held.side == side), None)


@misfit.register
def _scene(message: PlanningScene, key: str, robot: RobotDescription | None) -> str:
    del key
    return strange_hands((each.attached_to for each in message.objects), robot)


@misfit.register
def _beliefs(message: WorldState, key: str, robot: RobotDescription | None) -> str:
    del key
    facts = (*message.items, *message.doubles)
    return strange_hands((*(each.held for each in facts), *(each.side for each in message.held)), robot)


ROBOT_POSE: Final = Topic("world/robot", RobotPose)
PEOPLE: Final = Topic("world/people", People)
SIGHTINGS: Final = Topic("world/sightings", Sightings)
CLUTTER: Final = Topic("world/clutter", Clutter)
OCCUPANCY: Final = Topic("world/occupancy", Occupancy)
OCCUPANCY_NOW: Final = Service("world/occupancy/now", Nothing, Occupancy, reads=True)
OCCUPANCY_EDIT: Final = Service("world/occupancy/edit", EditMap, MapEdited)
SCENE: Final = Topic("world/scene", PlanningScene)
WORLD: Final = Topic("world/state", WorldState)
