"""One pybullet world behind typed calls; every call names its client, so several live side by side."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from enum import IntFlag
from typing import Final

import pybullet

from tandem.skills.ports.message import Quaternion, Vector3

TIME_STEP: Final = 0.01 / 3.0
"""Seconds a physics step (300 Hz): three a hardware period."""

SOFT_DAMPING: Final = 0.01
"""Seconds: damping of a soft surface over its stiffness."""

Rays = Sequence[Sequence[float]]

FLOOR_EDGE: Final = 60.0
"""Metres from the map's origin to which a floor with a hole reaches: beyond every room of a scenario."""
GRAVITY: Final = 9.81
"""m/s2, along -z."""

SOLVER_ITERATIONS: Final = 50
"""Sweeps of the contact solver a step; see docs/decisions/001-grasp-by-friction.md."""


class Group(IntFlag):
    """What a body is, for those who look for some bodies only; all collide with all."""

    THING = 1
    FIXED = 2
    ROBOT = 64
    """The first robot; ``robot_group`` has those of the others, ``ROBOTS`` all."""


ROBOTS: Final = Group(sum(Group.ROBOT << number for number in range(8)))
"""What any of the robots is made of."""


def robot_group(number: int) -> Group:
    """Return what a robot is, counted from 0: its own rays pass through itself, and hit the others."""
    return Group(Group.ROBOT << number)


@dataclass(frozen=True)
class Contact:
    """One point where two bodies touch: the links (-1 is a body's root) and the normal force in N."""

    body_a: int
    link_a: int
    body_b: int
    link_b: int
    position: Vector3
    normal_on_b: Vector3
    force: float


class Physics:
    """A pybullet client with gravity and a fixed step.

    The client's number (``client``) is for whoever needs a call that is not wrapped here: pass it as
    ``physicsClientId``.

    Raises:
        RuntimeError: from the constructor, when pybullet can't start a client (a window without a display).
    """

    def __init__(self, *, gui: bool = False, time_step: float = TIME_STEP) -> None:
        self.time_step = time_step
        self.client: int = pybullet.connect(pybullet.GUI if gui else pybullet.DIRECT)
        if self.client < 0:
            raise RuntimeError("pybullet could not start; without a display use it headless")
        self._steps = 0
        self.watchers: list[Callable[[], None]] = []
        """Called after each physics step: what touches for one step only is seen by nobody else."""
        self._configure()

    def _configure(self) -> None:
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=self.time_step,
            numSubSteps=0,
            numSolverIterations=SOLVER_ITERATIONS,
            deterministicOverlappingPairs=1,
            physicsClientId=self.client,
        )
        pybullet.setGravity(0.0, 0.0, -GRAVITY, physicsClientId=self.client)

    @property
    def seconds(self) -> float:
        """Simulated time since the client was made or cleared."""
        return self._steps * self.time_step

    def step(self, count: int = 1) -> None:
        """Advance by ``count`` physics steps."""
        for _ in range(count):
            pybullet.stepSimulation(physicsClientId=self.client)
            self._steps += 1
            for watcher in self.watchers:
                watcher()

    def clear(self) -> None:
        """Remove every body and start the time anew."""
        pybullet.resetSimulation(physicsClientId=self.client)
        self._steps = 0
        self._configure()

    def close(self) -> None:
        """End the client. Closing twice is allowed."""
        if self.client >= 0 and pybullet.isConnected(physicsClientId=self.client):
            pybullet.disconnect(physicsClientId=self.client)
        self.client = -1

    def add_floor(self, *, friction: float = 1.0) -> int:
        """Lay an endless floor at z = 0 and return its body."""
        shape = pybullet.createCollisionShape(pybullet.GEOM_PLANE, physicsClientId=self.client)
        body: int = pybullet.createMultiBody(0.0, shape, physicsClientId=self.client)
        self.set_surface(body, -1, friction=friction)
        return body

    def add_floor_around(
        self, lower: tuple[float, float], upper: tuple[float, float], depth: float, *, friction: float = 1.0
    ) -> int:
        """Lay a floor at z = 0 with a rectangle that lies ``depth`` metres lower; return its one body.

        Four slabs about the rectangle, ``FLOOR_EDGE`` long, and one below it.
        """
        (x0, y0), (x1, y1), far = lower, upper, FLOOR_EDGE
        slabs = (
            ((-far, -far), (x0, far), 0.0),
            ((x1, -far), (far, far), 0.0),
            ((x0, -far), (x1, y0), 0.0),
            ((x0, y1), (x1, far), 0.0),
            (lower, upper, -depth),
        )
        thick = depth + 0.1
        shape = pybullet.createCollisionShapeArray(
            shapeTypes=[pybullet.GEOM_BOX] * len(slabs),
            halfExtents=[[(b[0] - a[0]) / 2, (b[1] - a[1]) / 2, thick / 2] for a, b, _ in slabs],
            collisionFramePositions=[
                [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, top - thick / 2] for a, b, top in slabs
            ],
            physicsClientId=self.client,
        )
        body: int = pybullet.createMultiBody(0.0, shape, physicsClientId=self.client)
        self.set_surface(body, -1, friction=friction)
        return body

    def add_box(
        self,
        size: Vector3,
        mass: float,
        position: Vector3,
        orientation: Quaternion = (0.0, 0.0, 0.0, 1.0),
        *,
        friction: float = 0.8,
        colour: tuple[float, float, float, float] = (0.8, 0.7, 0.5, 1.0),
    ) -> int:
        """Make a box of the full ``size`` in metres; mass 0.0 makes it immovable. Return its body."""
        half = [edge / 2.0 for edge in size]
        shape = pybullet.createCollisionShape(
            pybullet.GEOM_BOX, halfExtents=half, physicsClientId=self.client
        )
        visual = pybullet.createVisualShape(
            pybullet.GEOM_BOX, halfExtents=half, rgbaColor=colour, physicsClientId=self.client
        )
        body: int = pybullet.createMultiBody(
            mass, shape, visual, position, orientation, physicsClientId=self.client
        )
        self.set_surface(body, -1, friction=friction)
        return body

    def remove(self, body: int) -> None:
        """Take a body out of the world."""
        pybullet.removeBody(body, physicsClientId=self.client)

    def set_surface(
        self, body: int, link: int, *, friction: float, anchored: bool = False, sideways: float = 1.0
    ) -> None:
        """Set the friction of a link's surface.

        Bullet multiplies the coefficients of the two that touch, so each is at most 1. ``anchored`` lets
        static friction correct the drift that the solver leaves, within Coulomb's cone: for pads, and for a
        light base's wheels, which roll on as before. See docs/decisions/001-grasp-by-friction.md.
        ``sideways`` is the friction along the link's y, a wheel's axle, as a share of that in its other
        directions.

        Raises:
            ValueError: for a coefficient outside [0, 1].
        """
        if not 0.0 <= friction <= 1.0:
            raise ValueError(f"a coefficient of friction lies between 0 and 1, not at {friction}")
        pybullet.changeDynamics(
            body,
            link,
            lateralFriction=friction,
            spinningFriction=0.0,
            rollingFriction=0.0,
            frictionAnchor=int(anchored),
            anisotropicFriction=(1.0, sideways, 1.0),
            physicsClientId=self.client,
        )

    def soften(self, body: int, stiffness: float) -> None:
        """Have a body's surface yield: ``stiffness`` N/m at each point of contact, well damped.

        A rigid wall is touched at one corner of a pad, which then turns on it; one that yields by a
        millimetre, as cardboard does, bears on the whole pad.
        """
        pybullet.changeDynamics(
            body,
            -1,
            contactStiffness=stiffness,
            contactDamping=SOFT_DAMPING * stiffness,
            physicsClientId=self.client,
        )

    def set_group(self, body: int, links: Iterable[int], group: Group) -> None:
        """Say what the links of a body are. They go on colliding with everything."""
        for link in links:
            pybullet.setCollisionFilterGroupMask(body, link, int(group), -1, physicsClientId=self.client)

    def cast(self, starts: Rays, ends: Rays, groups: Group) -> list[float]:
        """Return the part of each ray, from its start to its end in the world, that is free; 1 if all is.

        Only bodies of the ``groups`` are hit.
        """
        hits = pybullet.rayTestBatch(
            starts,
            ends,
            numThreads=1,
            collisionFilterMask=int(groups),
            physicsClientId=self.client,
        )
        return [hit[2] if hit[0] >= 0 else 1.0 for hit in hits]

    def body_pose(self, body: int) -> tuple[Vector3, Quaternion]:
        """Return the pose of a body's centre of mass in the world."""
        position, orientation = pybullet.getBasePositionAndOrientation(body, physicsClientId=self.client)
        return position, orientation

    def body_velocity(self, body: int) -> tuple[Vector3, Vector3]:
        """Return the linear and angular velocity of a body's centre of mass in the world."""
        linear, angular = pybullet.getBaseVelocity(body, physicsClientId=self.client)
        return linear, angular

    def contacts(self, body: int, other: int = -1, links: Sequence[int] | None = None) -> list[Contact]:
        """Return where ``body`` touches ``other`` (-1: anything), as found in the last step."""
        more = {} if other < 0 else {"bodyB": other}
        points = pybullet.getContactPoints(bodyA=body, physicsClientId=self.client, **more)
        return [
            Contact(p[1], p[3], p[2], p[4], p[5], p[7], p[9])
            for p in points or ()
            if links is None or p[3] in links
        ]

    def near(self, body: int, other: int, within: float) -> list[tuple[Vector3, float]]:
        """Return points of ``other`` closer to ``body`` than ``within`` m, with their distances (m)."""
        points = pybullet.getClosestPoints(body, other, within, physicsClientId=self.client)
        return [(point[6], point[8]) for point in points]

    def depth(self, body: int, other: int) -> float:
        """Return by how many metres two bodies are inside each other; 0 when they aren't."""
        points = pybullet.getClosestPoints(body, other, 0.0, physicsClientId=self.client)
        return max((-point[8] for point in points), default=0.0)
