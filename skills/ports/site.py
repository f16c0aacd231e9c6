"""``site/...``: what is known beforehand - map, furniture, search spots, depots, items."""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from typing import Annotated, Final, Literal

from pydantic import AfterValidator, Field, field_validator, model_validator

from tandem.skills.ports.message import PLAIN_TEXT, HandName, Message, Vector3
from tandem.skills.ports.occupancy import OccupancySetting
from tandem.skills.ports.planners import PlannerName
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.reflex_setting import ReflexSetting
from tandem.skills.ports.shapes import ROUND, ShapeName

LAST_TAG: Final = 586
"""The last number of the family 36h11, whose first is 0."""
LAST_ITEM: Final = 9999
"""The last number of an item. Four digits are read at a glance; a site has fewer items than that."""
FIRST_MADE: Final = 1000
"""The first number that is made from a name: those below are said, and the tags' are among them."""
FACE: Final = 0.8
"""Share of a face's edge that a tag's black square takes on the sites' labels, with a tenth as margin on each
side. Of an item without a tag as much of a face has to be seen."""
MAX_NAME: Final = 64
"""Characters of an item's name, as of a depot's in a request."""
Edge = Annotated[float, Field(gt=0.0)]
Share = Annotated[float, Field(ge=0.0, le=1.0)]
LocalPlanner = Literal["pursuit", "people", "band"]
"""``pursuit`` follows the plan and takes people for things. ``people`` follows it too, but tracks people,
slows down for them, waits, and lets them pass."""


class SiteBox(Message):
    """A box of a piece of furniture: full edges, centre in the map, turned about z by ``yaw``."""

    size: tuple[Edge, Edge, Edge]
    centre: Vector3
    yaw: float = 0.0


class Furniture(Message):
    """Something that stands still: walls, tables, shelves, pillars. Navigation keeps out of its plan."""

    name: str
    boxes: Annotated[tuple[SiteBox, ...], Field(min_length=1)]
    colour: tuple[float, float, float] = (0.7, 0.7, 0.7)


class Spot(Message):
    """A place to search from."""

    name: str
    pose: FloorPose


class Slot(Message):
    """A place for one item: ``facing`` is the heading (rad) from it to the robot's side."""

    position: Vector3
    facing: float


class Depot(Message):
    """Where items are brought to."""

    name: str
    slots: Annotated[tuple[Slot, ...], Field(min_length=1)]


class GraspPoint(Message):
    """Where a hand takes hold of an item that needs two: g_L or g_R (two-arm thesis, 4.1.1), on its surface.

    Told in the item's frame (its centre, x out of the tagged face, z up at rest); ``inwards`` is the
    direction in which the hand presses.
    """

    side: HandName
    position: Vector3
    inwards: Vector3


def _about(told: Mapping[str, object]) -> Vector3:
    """Return the edges of the box about a cylinder out of its measures; zeros where they are not told."""
    diameter, height = told.get("diameter"), told.get("height")
    if isinstance(diameter, float) and isinstance(height, float):
        return (diameter, diameter, height)
    return (0.0, 0.0, 0.0)


def number_of(name: str) -> int:
    """Return the number of an item of which only the name is said.

    It depends on nothing else, so that beliefs and histories stay true when a site's file changes. The
    checksum is that of ``zlib.crc32``, which is the same everywhere.
    """
    return FIRST_MADE + zlib.crc32(name.encode()) % (LAST_ITEM + 1 - FIRST_MADE)


class SiteItem(Message):
    """An item: number, name, shape (m), its tag or colour if it has one, and its hands.

    ``item`` is the number by which keys and messages call it, and that of its tag if it bears one. Then
    ``tag_size`` is the edge (m) of the tag's black square. Without a tag another detector has to tell it,
    and a file may leave ``item`` out: ``number_of`` makes it from the name.

    A box has ``size``, its full edges. A cylinder has ``diameter`` and ``height``; its ``size`` follows, the
    edges of the upright box about it.

    One with ``grasp_points`` needs both hands at once (two-arm thesis, 4.1.1: O_H2); else ``hands`` says
    which hands it is for (O_HL, O_HR; both unless told).
    """

    item: Annotated[int, Field(ge=0, le=LAST_ITEM)]
    name: Annotated[str, Field(max_length=MAX_NAME, pattern=PLAIN_TEXT)] = ""
    """What people call it, and requests may; none: its number only."""
    shape: ShapeName = "box"
    diameter: Edge | None = None
    height: Edge | None = None
    size: tuple[Edge, Edge, Edge] = Field(default_factory=_about)
    tag_size: Edge | None = None
    """Edge of the black square of its tags; none: it bears no tag."""
    colour: tuple[Share, Share, Share] | None = None
    """Red, green and blue, 0 to 1, for detectors that tell items by it; none: not known. In the simulation
    items without a colour are white, and so are those with a tag."""
    hands: tuple[HandName, ...] = ()
    """Hands that it is for; none: any hand of the robot."""
    grasp_points: tuple[GraspPoint, ...] = ()

    @property
    def words(self) -> str:
        """Its number, with its name if it has one."""
        return f"{self.item} ({self.name})" if self.name else str(self.item)

    @property
    def seen_edge(self) -> float:
        """Edge (m) of what has to be seen in the middle of a face: the tag, or a square as large as one."""
        return FACE * min(self.size) if self.tag_size is None else self.tag_size

    @property
    def needs_two(self) -> bool:
        """Whether it takes both hands."""
        return bool(self.grasp_points)

    def is_for(self, hand: HandName) -> bool:
        """Whether a hand may take it."""
        return not self.hands or hand in self.hands

    @model_validator(mode="after")
    def _measures_are_of_its_shape(self) -> SiteItem:
        if self.shape == "box":
            for name in ("diameter", "height"):
                if getattr(self, name) is not None:
                    raise ValueError(
                        f"expected no {name}: an item without shape: cylinder is a box of a size"
                    )
            if "size" not in self.model_fields_set:
                raise ValueError("expected a size, the three edges of a box (m)")
            return self
        for name in ("diameter", "height"):
            if getattr(self, name) is None:
                raise ValueError(f"expected a {name} (m), for its shape is cylinder")
        if any(abs(one - two) > ROUND for one, two in zip(self.size, _about(self._measures()), strict=True)):
            raise ValueError("expected diameter and height of a cylinder, and no other size beside them")
        room = min(self.size)
        if self.tag_size is not None and self.tag_size > room:
            raise ValueError(f"expected a tag_size of at most {room:g} m, which is its label's edge")
        return self

    @model_validator(mode="after")
    def _tags_have_their_numbers(self) -> SiteItem:
        if self.tag_size is not None and self.item > LAST_TAG:
            raise ValueError(
                f"expected an item of 0 to {LAST_TAG}, the numbers of tags, or no tag_size; found {self.item}"
            )
        return self

    def _measures(self) -> dict[str, object]:
        return {"diameter": self.diameter, "height": self.height}

    @field_validator("name")
    @classmethod
    def _is_no_number(cls, name: str) -> str:
        if name != name.strip() or name.isdecimal():
            raise ValueError("expected a name that is no number, without space around it")
        return name

    @model_validator(mode="after")
    def _one_point_for_each_hand(self) -> SiteItem:
        if self.grasp_points and sorted(each.side for each in self.grasp_points) != ["left", "right"]:
            raise ValueError("expected one grasp point for the left and one for the right hand")
        return self


def _numbers_are_unique(items: tuple[SiteItem, ...]) -> tuple[SiteItem, ...]:
    found: dict[int, SiteItem] = {}
    for item in items:
        other = found.setdefault(item.item, item)
        if other is item or other.name == item.name != "":  # of two of one name it is that which is told
            continue
        both = (other, item)
        called = " and ".join(each.name or "one without a name" for each in both)
        made = [each.name for each in both if each.name and each.item == number_of(each.name)]
        advice = f"; say item: with another number for {' or '.join(made)}" if made else ""
        raise ValueError(f"expected each number once; {item.item} is that of two items, {called}{advice}")
    return items


class Site(Message):
    """A place that robots work in. The map's frame has its origin in ``bounds``; z is up from the floor."""

    name: str
    robot: str
    bounds: tuple[float, float, float, float]
    """x_min, y_min, x_max, y_max of the floor (m)."""
    furniture: tuple[Furniture, ...]
    home: FloorPose
    spots: Annotated[tuple[Spot, ...], Field(min_length=1)]
    depots: tuple[Depot, ...] = ()
    items: Annotated[tuple[SiteItem, ...], AfterValidator(_numbers_are_unique)] = ()
    local_planner: LocalPlanner = "pursuit"
    """How the base drives along a plan."""
    reflexes: tuple[ReflexSetting, ...] = ()
    """Reflexes with other parameters than the robot's, or switched off, at this site."""
    occupancy: OccupancySetting | None = None
    """Measure occupied space from depth and plan against it; None: boxes of clutter only."""
    arm_planner: PlannerName = PlannerName.RRT_CONNECT
    """How arms find their way at this site (docs/planning.md)."""

    @model_validator(mode="after")
    def _names_are_unique(self) -> Site:
        for what, names in (
            ("furniture", [each.name for each in self.furniture]),
            ("spots", [each.name for each in self.spots]),
            ("depots", [each.name for each in self.depots]),
            ("names of items", [each.name for each in self.items if each.name]),
        ):
            twice = sorted({name for name in names if names.count(name) > 1})
            if twice:
                raise ValueError(f"{what}: expected unique names, twice there: {', '.join(twice)}")
        return self

    def item(self, number: int) -> SiteItem | None:
        """Return the item of that number, or None."""
        return next((each for each in self.items if each.item == number), None)

    def meant(self, said: str | int) -> SiteItem | None:
        """Return the item that is called so, by its name or by its number (also as text), or None."""
        text = str(said)
        return next((each for each in self.items if text and text in {each.name, str(each.item)}), None)

    def called(self, number: int) -> str:
        """Return an item's number as people are told of it: with its name, if the site gives it one."""
        known = self.item(number)
        return str(number) if known is None else known.words

    def item_words(self) -> str:
        """Return all items as words, for who asked for another."""
        return ", ".join(each.words for each in self.items)

    def depot(self, name: str) -> Depot | None:
        """Return the depot of that name, or None."""
        return next((each for each in self.depots if each.name == name), None)
