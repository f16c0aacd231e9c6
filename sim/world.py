"""The room in the physics: bodies by name, put there, taken away, and asked where they are."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import pybullet

from tandem.sim.people import RADIUS
from tandem.sim.scene import SceneBody, build_scene
from tandem.sim.things import BoxShape, CylinderShape
from tandem.skills.ports.pose import Pose

if TYPE_CHECKING:
    from collections.abc import Mapping

    from tandem.sim.body import RobotBody
    from tandem.sim.crowd import PersonTouch
    from tandem.sim.physics import Physics
    from tandem.sim.scenario import Scenario
    from tandem.sim.things import Drop
    from tandem.sim.walker_body import WalkerBody
    from tandem.skills.ports.site import Site

RESTING_SPEED: Final = 0.002
"""m/s below which a body counts as at rest."""


FIGURE: Final = CylinderShape(radius=RADIUS - 0.01, height=1.70)
"""What is drawn of a person."""
CLOTHES: Final = (0.28, 0.36, 0.55)
"""Red, green, blue from 0 to 1: of a person as drawn."""


class World:
    """All bodies, and the robots among them.

    A body is moved by hand only as the sim's own controls do it: taken away and made anew elsewhere.
    ``revision`` counts such changes, so that a drawing of the world knows when it is out of date.
    """

    def __init__(self, physics: Physics, drop: Drop | None = None) -> None:
        self.physics = physics
        self.floor = (
            physics.add_floor()
            if drop is None
            else physics.add_floor_around(drop.lower, drop.upper, drop.depth)
        )
        self.revision = 0
        self._bodies: dict[str, SceneBody] = {}
        self._ids: dict[str, int] = {}
        self.robots: dict[str, RobotBody] = {}
        """The robots that have been let in, by name; they are no ``bodies``."""
        self.people: dict[str, WalkerBody] = {}
        """Who walks about, by name; they are no ``bodies`` either."""
        self.touches: list[PersonTouch] = []
        """Whom people, and robots that a script drives, have touched of the other robots."""

    @property
    def bodies(self) -> Mapping[str, SceneBody]:
        """What there is, as it was put there, in the order of putting."""
        return self._bodies

    def id_of(self, name: str) -> int:
        """Return a body's number in the physics; KeyError when there is none of that name."""
        return self._ids[name]

    def names_by_id(self) -> dict[int, str]:
        """Return the name of each body by its number, the floor's and the people's too."""
        people = {person.body: name for name, person in self.people.items()}
        return {self.floor: "floor", **{body: name for name, body in self._ids.items()}, **people}

    def admit(self, robot: RobotBody) -> None:
        """Have a robot in the room; the physics has it already."""
        self.robots[robot.name] = robot

    def join(self, name: str, person: WalkerBody) -> None:
        """Have a person in the room; the physics has it already."""
        self.people[name] = person
        self.revision += 1

    def figures(self) -> tuple[SceneBody, ...]:
        """Return the people as a camera sees them: a cylinder each, where it is now."""
        return tuple(
            SceneBody(
                name=name,
                shape=FIGURE,
                pose=Pose(position=(*person.place, FIGURE.height / 2), orientation=(0.0, 0.0, 0.0, 1.0)),
                mass=1.0,
                friction=0.5,
                colour=CLOTHES,
            )
            for name, person in self.people.items()
        )

    def names_with_robots(self) -> dict[int, str]:
        """Return the name of each body by its number, the floor's and the robots' too."""
        return {**self.names_by_id(), **{robot.body: name for name, robot in self.robots.items()}}

    def put(self, body: SceneBody) -> int:
        """Make a body, in place of the one of that name if there is one; return its number."""
        if body.name in self._ids:
            self.remove(body.name)
        made = _make(self.physics, body)
        self._ids[body.name] = made
        self._bodies[body.name] = body
        self.revision += 1
        return made

    def remove(self, name: str) -> None:
        """Take a body away; KeyError when there is none of that name. What stood on it falls."""
        self.physics.remove(self._ids.pop(name))
        del self._bodies[name]
        self.revision += 1

    def pose(self, name: str) -> Pose:
        """Return where a body's centre truly is in map; KeyError when there is none of that name."""
        position, orientation = self.physics.body_pose(self._ids[name])
        return Pose(position=position, orientation=orientation)

    def movable(self) -> tuple[str, ...]:
        """Return the names of the bodies that can move."""
        return tuple(name for name, body in self._bodies.items() if body.mass > 0.0)

    def speed(self) -> float:
        """Return the speed in m/s of the fastest body."""
        fastest = 0.0
        for name in self.movable():
            (x, y, z), _ = self.physics.body_velocity(self._ids[name])
            fastest = max(fastest, (x * x + y * y + z * z) ** 0.5)
        return fastest

    def settle(self, *, most: int = 500, least: int = 50) -> int:
        """Step the physics until all is at rest; return the steps taken, ``most`` at the most."""
        for done in range(1, most + 1):
            self.physics.step()
            if done >= least and self.speed() < RESTING_SPEED:
                return done
        return most


def spawn(physics: Physics, site: Site, scenario: Scenario) -> World:
    """Fill the physics with the room as the scenario has it; nothing is stepped yet.

    Raises:
        ScenarioError: when the scenario doesn't fit the site.
    """
    world = World(physics, scenario.drop)
    for body in build_scene(site, scenario):
        world.put(body)
    return world


def _make(physics: Physics, body: SceneBody) -> int:
    made = _shape(physics, body)
    if body.stiffness is not None:
        physics.soften(made, body.stiffness)
    return made


def _shape(physics: Physics, body: SceneBody) -> int:
    position, orientation = body.pose.position, body.pose.orientation
    if isinstance(body.shape, BoxShape):
        colour = (*body.colour, 1.0)
        return physics.add_box(
            body.shape.size, body.mass, position, orientation, friction=body.friction, colour=colour
        )
    shape = pybullet.createCollisionShape(
        pybullet.GEOM_CYLINDER,
        radius=body.shape.radius,
        height=body.shape.height,
        physicsClientId=physics.client,
    )
    made: int = pybullet.createMultiBody(
        body.mass, shape, -1, position, orientation, physicsClientId=physics.client
    )
    physics.set_surface(made, -1, friction=body.friction)
    return made
