"""What is really so: for tests and reports only. No skill and no tree may read this."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from pydantic import Field

from tandem.sim.scene import item_name, support_height
from tandem.skills.ports.item_number import ITEM_OR_TAG
from tandem.skills.ports.keys import Nothing, Service
from tandem.skills.ports.message import Count, Message, RobotTime
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import Site

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tandem.sim.body import RobotBody
    from tandem.sim.walker_body import WalkerBody
    from tandem.sim.world import World

LYING_TOLERANCE: Final = 0.01
"""Metres by which an item's underside may be off its support's top."""


class TrueBody(Message):
    """Pose of a body's centre in map; an item's with its number."""

    name: str
    pose: Pose
    item: Count | None = Field(default=None, validation_alias=ITEM_OR_TAG)


class TrueContact(Message):
    """Two touching bodies, as ``<robot>/<link>`` or a body's name, and the sum of the normal forces in N."""

    first: str
    second: str
    force: float


class TrueRobot(Message):
    """Where a robot of the scenario is, and how fast: m/s along map's x and y, rad/s to the left."""

    name: str
    base_in_map: Pose
    linear: tuple[float, float]
    angular: float


class TruePerson(Message):
    """Where a person's axis is (m, in map), and how fast they walk (m/s along map's x and y)."""

    name: str
    x: float
    y: float
    linear: tuple[float, float]


class TrueTouch(Message):
    """A contact of a person with a robot, from its beginning at ``at`` (robot seconds) on.

    A robot that a script drives counts as a person does.
    """

    at: float
    person: str
    robot: str
    stood: float
    """Seconds for which the robot had stood still then; 0 where it moved."""


class Truth(Message):
    """The true state of the world; ``bodies`` are those that can move.

    ``base_in_map`` is that of the robot whose keys were asked; ``robots`` are all, in the scenario's order.
    """

    stamp: RobotTime
    base_in_map: Pose
    bodies: tuple[TrueBody, ...]
    contacts: tuple[TrueContact, ...]
    robots: tuple[TrueRobot, ...] = ()
    people: tuple[TruePerson, ...] = ()
    touches: tuple[TrueTouch, ...] = ()
    """All contacts of people, and of robots that a script drives, with the others, in order."""

    def robot(self, name: str) -> TrueRobot:
        """Return a robot; KeyError when there is none of that name."""
        for robot in self.robots:
            if robot.name == name:
                return robot
        raise KeyError(f"no robot {name}; there are {', '.join(each.name for each in self.robots)}")

    def item(self, number: int) -> TrueBody:
        """Return an item; KeyError when there is none with that number."""
        for body in self.bodies:
            if body.item == number:
                return body
        there = ", ".join(str(body.item) for body in self.bodies if body.item is not None)
        raise KeyError(f"no item {number}; there are {there}")

    def touching(self, name: str) -> tuple[str, ...]:
        """Return what a body touches, sorted."""
        pairs = [(c.first, c.second) for c in self.contacts] + [(c.second, c.first) for c in self.contacts]
        return tuple(sorted({other for one, other in pairs if one == name}))


TRUTH: Final = Service("sim/truth", Nothing, Truth, reads=True)


def read_truth(world: World, robot: RobotBody, stamp: RobotTime) -> Truth:
    """Return what is so now."""
    position, orientation = robot.base_pose()
    robots = tuple(world.robots.values()) or (robot,)
    bodies = []
    for name in world.movable():
        label = world.bodies[name].label
        bodies.append(TrueBody(name=name, pose=world.pose(name), item=None if label is None else label.item))
    return Truth(
        stamp=stamp,
        base_in_map=Pose(position=position, orientation=orientation),
        bodies=tuple(bodies),
        contacts=_contacts(world, robots),
        robots=tuple(_true_robot(each) for each in robots),
        people=tuple(_true_person(name, each) for name, each in world.people.items()),
        touches=tuple(
            TrueTouch(at=each.at, person=each.person, robot=each.robot, stood=each.stood)
            for each in world.touches
        ),
    )


def lies_on(truth: Truth, site: Site, item: int, furniture: str) -> bool:
    """Say whether an item stands on a piece of furniture, on one of its sides, free of the robot.

    Raises:
        KeyError: when there is no such item or furniture.
    """
    body, known = truth.item(item), site.item(item)
    if known is None:
        raise KeyError(f"site {site.name} knows no item {item}")
    if furniture not in [piece.name for piece in site.furniture]:
        raise KeyError(f"no furniture '{furniture}' at site {site.name}")
    x, y, z = body.pose.position
    try:
        top = support_height(site, furniture, x, y)
    except KeyError:
        return False
    resting = any(abs(z - top - edge / 2) < LYING_TOLERANCE for edge in known.size)
    held = any("/" in other for other in truth.touching(item_name(item)))
    return resting and not held


def _true_robot(robot: RobotBody) -> TrueRobot:
    position, orientation = robot.base_pose()
    (vx, vy, _), (_, _, turning) = robot.physics.body_velocity(robot.body)
    pose = Pose(position=position, orientation=orientation)
    return TrueRobot(name=robot.name, base_in_map=pose, linear=(vx, vy), angular=turning)


def _true_person(name: str, person: WalkerBody) -> TruePerson:
    x, y = person.place
    return TruePerson(name=name, x=x, y=y, linear=person.velocity)


def _contacts(world: World, robots: Sequence[RobotBody]) -> tuple[TrueContact, ...]:
    """Return the contacts of the robots and of all that can move, one for each pair, sorted."""
    names = world.names_by_id()
    links = {
        robot.body: {index: f"{robot.name}/{name}" for name, index in robot.link_index.items()}
        for robot in robots
    }

    def name_of(body: int, link: int) -> str:
        return links[body][link] if body in links else names[body]

    forces: dict[tuple[str, str], float] = {}
    told: set[int] = set()
    for body in (*links, *(world.id_of(name) for name in world.movable())):
        for contact in world.physics.contacts(body):
            if contact.body_b in told or contact.force <= 0.0:
                continue
            first = name_of(contact.body_a, contact.link_a)
            second = name_of(contact.body_b, contact.link_b)
            pair = (min(first, second), max(first, second))
            forces[pair] = forces.get(pair, 0.0) + contact.force
        told.add(body)
    return tuple(TrueContact(first=a, second=b, force=round(f, 3)) for (a, b), f in sorted(forces.items()))
