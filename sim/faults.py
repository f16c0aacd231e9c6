"""Faults on purpose, as data: what goes wrong, when, for how long and how badly.

A fault begins ``at`` a time of the robot's clock, or ``when`` something happens; with neither it begins at
once. ``lasts`` is in robot seconds; without it the fault stays. Who carries them out: ``tandem.sim.trouble``.
"""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import Field, model_validator

from tandem.sim.things import Angle, BoxShape, Colour, Coordinate, Friction, Name, Shape
from tandem.skills.ports.item_number import ITEM_OR_TAG, NamedItem
from tandem.skills.ports.message import Count, HandName, Message, PartName, RobotTime

Seconds = Annotated[float, Field(ge=0.0, le=3600.0)]
Duration = Annotated[float, Field(gt=0.0, le=3600.0)]
Share = Annotated[float, Field(ge=0.0, le=1.0)]
Step = Annotated[float, Field(ge=-5.0, le=5.0)]
"""Metres by which something is displaced along one axis."""

PARCEL: Final = BoxShape(size=(0.07, 0.07, 0.07))
"""Metres: as large as the cubes with tags."""


class _Event(Message):
    """Something that the sim sees happen; ``after`` robot seconds later the fault begins.

    ``nth``: which time it happens since the boot or, for a fault that is asked for, since then; 1 is the
    first.
    """

    after: Seconds = 0.0
    nth: Annotated[int, Field(ge=1, le=1000)] = 1


class GripperClosed(_Event):
    """The fingers have closed on something and squeeze it; without a side: of either hand."""

    event: Literal["gripper_closed"] = "gripper_closed"
    side: HandName | None = None


class ItemLifted(_Event):
    """An item, in the robot's hand, is more than 3 cm above where it stood; without ``item``: any."""

    event: Literal["item_lifted"] = "item_lifted"
    item: NamedItem | None = Field(default=None, validation_alias=ITEM_OR_TAG)


class ArmMoving(_Event):
    """An arm starts to move; without a side: either arm."""

    event: Literal["arm_moving"] = "arm_moving"
    side: HandName | None = None


class BaseMoving(_Event):
    """The base starts to move."""

    event: Literal["base_moving"] = "base_moving"


class BaseAtRest(_Event):
    """The base has moved and then stood still for 0.3 s."""

    event: Literal["base_at_rest_after_moving"] = "base_at_rest_after_moving"


class CameraUsed(_Event):
    """The camera gets a subscriber."""

    event: Literal["camera_used"] = "camera_used"


Event = Annotated[
    GripperClosed | ItemLifted | ArmMoving | BaseMoving | BaseAtRest | CameraUsed,
    Field(discriminator="event"),
]


class _Once(Message):
    """A fault that happens in a moment."""

    robot: Name | None = None
    """The robot that is meant, by its name in the scenario; the first unless given."""
    at: Seconds | None = None
    """Robot seconds after the boot; one that has passed means at once."""
    when: Event | None = None

    @model_validator(mode="after")
    def _one_time(self) -> _Once:
        if self.at is not None and self.when is not None:
            raise ValueError("expected either at or when, not both")
        return self


class _Lasting(_Once):
    """A fault that has an end, or none."""

    lasts: Duration | None = None
    """Robot seconds; without it: for good."""


class CameraDark(_Lasting):
    """The lens is covered: pictures are black, without depth."""

    kind: Literal["camera_dark"] = "camera_dark"


class CameraFrozen(_Lasting):
    """The camera repeats one picture, with new stamps."""

    kind: Literal["camera_frozen"] = "camera_frozen"


class CameraSilent(_Lasting):
    """The camera sends nothing."""

    kind: Literal["camera_silent"] = "camera_silent"


class LaserSilent(_Lasting):
    """The laser sends nothing."""

    kind: Literal["laser_silent"] = "laser_silent"


class JointsSilent(_Lasting):
    """The joints' states are not told, though all joints go on as they are told."""

    kind: Literal["joints_silent"] = "joints_silent"


class RangeSilent(_Lasting):
    """A range or a cliff sensor tells nothing; without a name: all of them."""

    kind: Literal["range_silent"] = "range_silent"
    sensor: PartName | None = None


class RangeStuck(_Lasting):
    """A range or a cliff sensor repeats its last distance, with new stamps; without a name: all of them."""

    kind: Literal["range_stuck"] = "range_stuck"
    sensor: PartName | None = None


class OdometryJump(_Once):
    """The odometry jumps although the base doesn't: metres ahead and to the left, and rad to the left."""

    kind: Literal["odometry_jump"] = "odometry_jump"
    dx: Step = 0.0
    dy: Step = 0.0
    dyaw: Angle = 0.0


class JointStall(_Lasting):
    """Motors stop following: they hold their joint or, if ``limp``, exert no force."""

    kind: Literal["joint_stall"] = "joint_stall"
    group: Name | None = None
    """Without it: the arm of the event, whichever that is."""
    joint: str | Count | None = None
    """Its name, or its place in the group (0 is the first); without it: all of the group."""
    limp: bool = False

    @model_validator(mode="after")
    def _which(self) -> JointStall:
        if self.group is None and not isinstance(self.when, ArmMoving | GripperClosed | ItemLifted):
            raise ValueError("group: expected a group's name, or when: {event: arm_moving}")
        return self


class GripperStuck(_Lasting):
    """The fingers ignore commands; without a side: the event's hand, or all."""

    kind: Literal["gripper_stuck"] = "gripper_stuck"
    side: HandName | None = None


class GripperWeak(_Lasting):
    """The gripper has a fraction of the commanded force; without a side: the event's hand, or all."""

    kind: Literal["gripper_weak"] = "gripper_weak"
    side: HandName | None = None
    force: Share = 0.02


class HandOpens(_Lasting):
    """The fingers open, and what they hold falls; without a side: the event's hand, or all."""

    kind: Literal["hand_opens"] = "hand_opens"
    side: HandName | None = None
    lasts: Duration | None = 0.5


class HardwareSilent(_Lasting):
    """The hardware receives and sends nothing, not even its clock. Its physics continues."""

    kind: Literal["hardware_silent"] = "hardware_silent"


class BumperPressed(_Lasting):
    """A bumper reads pressed."""

    kind: Literal["bumper"] = "bumper"
    bumper: PartName | None = None
    """None: the first that the robot has."""


class StopSet(_Lasting):
    """A person sets the hardware's stop; the same one releases it when ``lasts`` is over."""

    kind: Literal["stop"] = "stop"
    by: Annotated[str, Field(min_length=1, max_length=60)] = "a person"
    reason: Annotated[str, Field(max_length=200)] = "the stop was pressed on purpose"


class Place(Message):
    """A place on a piece of furniture or on the floor."""

    support: Name
    x: Coordinate
    y: Coordinate
    yaw: Angle = 0.0


class ItemMoves(_Once):
    """A person moves an item: by a step in map, or ``to`` a place. Without ``item``: the event's."""

    kind: Literal["item_moves"] = "item_moves"
    item: NamedItem | None = Field(default=None, validation_alias=ITEM_OR_TAG)
    dx: Step = 0.0
    dy: Step = 0.0
    dyaw: Angle = 0.0
    to: Place | None = None

    @model_validator(mode="after")
    def _which(self) -> ItemMoves:
        _needs_item(self.item, self.when)
        if self.to is not None and (self.dx or self.dy or self.dyaw):
            raise ValueError("expected either to or dx, dy, dyaw, not both")
        return self


class ItemGone(_Once):
    """A person takes an item away. Without ``item``: the event's."""

    kind: Literal["item_gone"] = "item_gone"
    item: NamedItem | None = Field(default=None, validation_alias=ITEM_OR_TAG)

    @model_validator(mode="after")
    def _which(self) -> ItemGone:
        _needs_item(self.item, self.when)
        return self


class ObstacleAppears(_Lasting):
    """An object that is no item appears at x and y in map, or ``ahead`` of the base, until its end."""

    kind: Literal["obstacle_appears"] = "obstacle_appears"
    name: Name = "intruder"
    shape: Shape = BoxShape(size=(0.4, 0.4, 1.0))
    support: Name = "floor"
    x: Coordinate | None = None
    y: Coordinate | None = None
    yaw: Angle = 0.0
    """Heading in map, or relative to the base when it is put ``ahead``."""
    ahead: Annotated[float, Field(ge=0.3, le=10.0)] | None = None
    """Metres from the base's centre to the thing's, in the direction in which the base heads."""
    mass: Annotated[float, Field(ge=0.0, le=50.0)] = 0.0
    """In kg; 0 means that it can't be pushed."""
    friction: Friction = 0.6
    colour: Colour = (0.72, 0.20, 0.20)
    waits: bool = False
    """If the place is taken, appear as soon as there is room instead of being refused."""

    @model_validator(mode="after")
    def _where(self) -> ObstacleAppears:
        placed = self.x is not None and self.y is not None
        if placed == (self.ahead is not None) or (self.x is None) != (self.y is None):
            raise ValueError("expected either x and y, or ahead")
        return self


class DepotTaken(_Lasting):
    """A slot of a depot is taken: by an item, or by a parcel that is none.

    With ``lasts``, the parcel is removed at the end; an item stays.
    """

    kind: Literal["depot_taken"] = "depot_taken"
    depot: Name = "depot"
    slot: Annotated[int, Field(ge=0, le=1000)] = 0
    """0 is the first."""
    item: NamedItem | None = Field(default=None, validation_alias=ITEM_OR_TAG)
    shape: Shape = PARCEL

    @model_validator(mode="after")
    def _ends(self) -> DepotTaken:
        if self.item is not None and self.lasts is not None:
            raise ValueError("lasts is for a parcel; an item that was put there stays")
        return self


Fault = Annotated[
    CameraDark
    | CameraFrozen
    | CameraSilent
    | LaserSilent
    | JointsSilent
    | RangeSilent
    | RangeStuck
    | OdometryJump
    | JointStall
    | GripperStuck
    | GripperWeak
    | HandOpens
    | HardwareSilent
    | BumperPressed
    | StopSet
    | ItemMoves
    | ItemGone
    | ObstacleAppears
    | DepotTaken,
    Field(discriminator="kind"),
]


class FaultRequest(Message):
    """Inject a fault: at its time, or at once if it has none."""

    fault: Fault


class FaultEvent(Message):
    """A fault began, ended, or could not be made (``refused``)."""

    stamp: RobotTime
    number: Count
    """Since the boot: those of the scenario first, in order, from 0; then those that were asked for."""
    kind: str
    phase: Literal["began", "ended", "refused"]
    words: str
    """Description: what happened where, or why it could not."""


def _needs_item(item: int | None, when: object) -> None:
    if item is None and not isinstance(when, ItemLifted):
        raise ValueError("item: expected an item's name or number, or when: {event: item_lifted}")
