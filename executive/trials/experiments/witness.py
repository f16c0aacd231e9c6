"""What truly happens in a run: contacts, the hands' paths, and how the things are held."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from tandem.sim.scene import item_name
from tandem.skills.geometry.poses import invert, rotate, transform
from tandem.skills.grasping.hand_grasps import TIP
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.message import HandName, Message, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import SiteItem

if TYPE_CHECKING:
    from tandem.sim.station import Station

CLEAR: Final = 0.02
"""Metres above where it stood from which on a thing is off the table: beyond what a push may raise it."""
PATH_EVERY: Final = 10
"""Steps between two points of a hand's path: 0.1 s."""
ARM_LINKS: Final = {side: (f"arm_{side}_", f"gripper_{side}_", f"wrist_{side}_") for side in PAIR}
_UP: Final[Vector3] = (0.0, 0.0, 1.0)


class Touch(Message):
    """Something that must not touch: what, what it touched, and when it began (robot seconds)."""

    first: str
    second: str
    at: float


@dataclass(eq=False)
class Witness:
    """A node that looks at the simulation itself; call ``step`` after each of its periods.

    Args:
        station: the simulation.
        items: what is picked.
    """

    station: Station
    items: tuple[SiteItem, ...]
    touches: list[Touch] = field(default_factory=list)
    paths: dict[HandName, list[Vector3]] = field(default_factory=lambda: {"left": [], "right": []})
    heights: dict[int, float] = field(default_factory=dict)
    """Highest that each item's centre has been above where it stood (m)."""
    tilts: dict[int, float] = field(default_factory=dict)
    """Largest tilt of each item while it was lifted by 2 cm or more (rad)."""

    def __post_init__(self) -> None:
        """Note where all stands."""
        self._steps = 0
        self._under_way: set[tuple[str, str]] = set()
        self._stood = {each.item: self.pose(each.item).position[2] for each in self.items}
        links = {index: name for name, index in self.station.body.link_index.items()}
        self._arm_of = {
            index: side for index, name in links.items() for side in PAIR if name.startswith(ARM_LINKS[side])
        }

    def step(self) -> bool:
        """Look."""
        self._contacts()
        for each in self.items:
            pose = self.pose(each.item)
            height = pose.position[2] - self._stood[each.item]
            self.heights[each.item] = max(self.heights.get(each.item, 0.0), height)
            if height > CLEAR:
                self.tilts[each.item] = max(self.tilts.get(each.item, 0.0), tilt(pose))
        if self._steps % PATH_EVERY == 0:
            for side in PAIR:
                self.paths[side].append(self.tool(side).position)
        self._steps += 1
        return False

    def pose(self, item: int) -> Pose:
        """Return where an item's centre truly is in the map."""
        return self.station.world.pose(item_name(item))

    def tool(self, side: HandName) -> Pose:
        """Return where a hand's tool frame truly is in the map."""
        from tandem.sim.camera import pose_of  # noqa: PLC0415 - pybullet prints when it is imported

        frame = self.station.model.description.end_effector(side).frame
        return pose_of(self.station.body.frame_matrix(frame))

    def offset(self, side: HandName, item: SiteItem) -> Vector3:
        """Return the finger tips' place from the item's grasp point of that side, in the item's axes (m)."""
        point = next(each for each in item.grasp_points if each.side == side)
        tip = transform(self.tool(side), (TIP, 0.0, 0.0))
        x, y, z = transform(invert(self.pose(item.item)), tip)
        px, py, pz = point.position
        return (x - px, y - py, z - pz)

    def held_by(self, side: HandName, item: int) -> bool:
        """Say whether both fingers of a hand touch the item, and nothing but that hand does."""
        fingers = set(next(hand for hand in self.station.model.hands if hand.side == side).finger_links)
        names = self.station.world.names_by_id()
        links = {index: name for name, index in self.station.body.link_index.items()}
        touching = set()
        for contact in self.station.physics.contacts(self.station.world.id_of(item_name(item))):
            if contact.force <= 0.0:
                continue
            if contact.body_b == self.station.body.body:
                touching.add(links[contact.link_b])
            else:
                touching.add(names.get(contact.body_b, "?"))
        return fingers <= touching and all(name.startswith(ARM_LINKS[side]) for name in touching)

    def _contacts(self) -> None:
        body, names = self.station.body.body, self.station.world.names_by_id()
        now: set[tuple[str, str]] = set()
        in_hand = {
            item_name(each.item): each.hands[0]
            for each in self.items
            if len(each.hands) == 1 and self.pose(each.item).position[2] - self._stood[each.item] > CLEAR
        }
        for contact in self.station.physics.contacts(body):
            arm = self._arm_of.get(contact.link_a)
            if arm is None or contact.force <= 0.0:
                continue
            if contact.body_b == body:
                other = self._arm_of.get(contact.link_b)
                if other is not None and other != arm:
                    now.add(("left arm", "right arm"))
            elif names.get(contact.body_b, "").startswith("table"):
                now.add((f"{arm} arm", "table"))
            elif (held := in_hand.get(names.get(contact.body_b, ""))) not in {None, arm}:
                now.add((f"{arm} arm", f"what is in the {held} hand"))
        seconds = round(self.station.hardware.now.seconds, 2)
        self.touches += [
            Touch(first=first, second=second, at=seconds) for first, second in sorted(now - self._under_way)
        ]
        self._under_way = now


def lean(pose: Pose) -> float:
    """Return the radians between the map's up and whichever axis of the body is nearest to it."""
    axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), _UP)
    return math.acos(min(1.0, max(abs(rotate(pose.orientation, axis)[2]) for axis in axes)))


def tilt(pose: Pose) -> float:
    """Return the radians between the body's up and the map's."""
    return math.acos(max(-1.0, min(1.0, rotate(pose.orientation, _UP)[2])))
