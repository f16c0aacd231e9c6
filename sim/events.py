"""What the sim sees happen to its robot, so that a fault can strike at that moment. No skill is asked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.keys import rgbd

if TYPE_CHECKING:
    from collections.abc import Set as AbstractSet

    from tandem.sim.body import RobotBody
    from tandem.sim.faults import Event
    from tandem.sim.hardware import Hardware
    from tandem.sim.world import World
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.message import RobotTime
    from tandem.skills.ports.pose import FloorPose

LIFTED: Final = 0.03
"""Metres above where it stood from which an item counts as lifted."""
STIRRED: Final = 0.01
"""Metres of height below which an item counts as standing where it stood."""
REST_TIME: Final = 0.3
"""Seconds without motion after which the base counts as at rest."""
STANDS_WITHIN: Final = 0.002
"""Metres and rad within which the base stands: it creeps at less than 7 mm/s and 7 mrad/s then. Its speed
from one period to the next says little: that of a light base at rest flickers up to 0.02 rad/s."""


@dataclass(frozen=True)
class Occurrence:
    """An event that happened just now, and to whom."""

    event: str
    side: str | None = None
    item: int | None = None

    def is_one_of(self, awaited: Event) -> bool:
        """Say whether it is what a fault waits for."""
        if awaited.event != self.event:
            return False
        side, item = getattr(awaited, "side", None), getattr(awaited, "item", None)
        return side in {None, self.side} and item in {None, self.item}


class Events:
    """Finds out what begins to be so. Call ``step`` once a period; it looks at what is ``wanted`` only.

    Args:
        bus: tells who listens to the camera.
        hardware: its controllers.
        world: where the items are.
        robot: what touches them.
    """

    def __init__(self, bus: Bus, hardware: Hardware, world: World, robot: RobotBody) -> None:
        self._bus, self._hardware, self._world, self._robot = bus, hardware, world, robot
        self._before: dict[Occurrence, bool] = {}
        self._aloft: set[int] = set()
        self._stood = {name: world.pose(name).position[2] for name in world.movable()}
        self._moved, self._still_since = False, 0.0
        self._still_at: FloorPose | None = None
        self._cameras = [rgbd(each.name) for each in robot.model.description.cameras]
        self._links = {
            robot.link_index[link]: hand.side for hand in robot.model.hands for link in hand.finger_links
        }

    def step(self, now: RobotTime, wanted: AbstractSet[str]) -> list[Occurrence]:
        """Return what began since the last step."""
        so: dict[Occurrence, bool] = {}
        for side, hand in self._hardware.hands.items():
            so[Occurrence("gripper_closed", side)] = hand.controller.squeezing
            group = self._robot.model.description.end_effector(side).group
            at_rest = self._hardware.groups[group].servos.controller.report.at_rest
            so[Occurrence("arm_moving", side)] = not at_rest
        moving = self._is_base_moving()
        so[Occurrence("base_moving")] = moving
        so[Occurrence("base_at_rest_after_moving")] = self._rests(now, moving=moving)
        if "camera_used" in wanted:
            so[Occurrence("camera_used")] = any(self._bus.listened(each) for each in self._cameras)
        began = [what for what, holds in so.items() if holds and not self._before.get(what, holds)]
        self._before = so
        if "item_lifted" in wanted:
            began += self._lifted()
        return [occurrence for occurrence in began if occurrence.event in wanted]

    def look_away(self) -> None:
        """Forget what was so: nobody wants to know for now, and what goes on then does not begin."""
        self._before = {}
        self._moved = False

    def _is_base_moving(self) -> bool:
        controller = self._hardware.base.controller
        return controller.linear != 0.0 or controller.angular != 0.0

    def _rests(self, now: RobotTime, *, moving: bool) -> bool:
        pose = self._hardware.base.odometer.pose
        if moving or not self._still_at or _apart(pose, self._still_at) > STANDS_WITHIN:
            self._moved = self._moved or moving
            self._still_since, self._still_at = now.seconds, pose
        return self._moved and now.seconds - self._still_since >= REST_TIME

    def _lifted(self) -> list[Occurrence]:
        """Return the items that a hand has just lifted; an item stands where it last touched a thing."""
        found = []
        for name in self._world.movable():
            label = self._world.bodies[name].label
            if label is None:
                continue
            height = self._world.pose(name).position[2]
            rise = height - self._stood.setdefault(name, height)
            if abs(rise) < STIRRED:
                self._aloft.discard(label.item)
                continue
            touched = self._world.physics.contacts(self._world.id_of(name))
            if any(contact.body_b != self._robot.body for contact in touched):
                self._stood[name] = height
                continue
            hands = [self._links[contact.link_b] for contact in touched if contact.link_b in self._links]
            if rise > LIFTED and hands and label.item not in self._aloft:
                self._aloft.add(label.item)
                found.append(Occurrence("item_lifted", hands[0], label.item))
        return found


def _apart(a: FloorPose, b: FloorPose) -> float:
    """Return how far apart two poses are, in metres or rad, whichever is more."""
    return max(floor_distance(a, b), abs(wrap(a.yaw - b.yaw)))
