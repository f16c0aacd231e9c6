"""A person in the physics: a trunk on two legs, carried over the floor by motors.

The body hangs on a joint along x, one along y and one about z; the legs swing along its heading. All of them
are driven by velocity and have a bounded force, so that a person is stopped by what it runs into, and pushes.
Legs are what a laser at ankle or knee height sees.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import pybullet

from tandem.sim.people import RADIUS
from tandem.sim.physics import SOFT_DAMPING, Group
from tandem.skills.geometry.poses import wrap

if TYPE_CHECKING:
    from tandem.sim.physics import Physics

TRUNK: Final = (0.75, 1.70)
"""Metres above the floor: from where to where the trunk is."""
LEG_RADIUS: Final = 0.055
"""Metres, chosen: a lower leg with trousers."""
LEGS_APART: Final = 0.20
"""Metres between the middles of two legs side by side."""
CLEARANCE: Final = 0.01
"""Metres under a foot: legs roll over the floor without touching it."""
STRIDE: Final = 0.14
"""Metres by which a leg swings ahead and back: steps of 0.44 m, as a foot on the floor stays where it is."""
MASSES: Final = (0.5, 0.5, 8.0, 2.0, 2.0)
"""kg: two slides, the trunk, the legs: what of a person takes part when a leg bumps into something. With all
of 70 kg the LoCoBot was thrown 9 cm, by people who stop when they feel it."""
PUSH: Final = 250.0
"""N: from 1.4 m/s to a stop within 6 cm."""
SOFT: Final = 2500.0
"""N/m, of flesh and shoes."""
TWIST: Final = 20.0
"""N m."""
SWING: Final = 60.0
"""N of a leg: at 1.4 m/s its mass is swung with 14 m/s2."""
ALONG_X, ALONG_Y, ABOUT_Z, LEFT, RIGHT = range(5)


class WalkerBody:
    """A person who stands at ``x``, ``y`` (m, in map) and looks along ``yaw``; moved by its motors alone."""

    def __init__(self, physics: Physics, *, x: float, y: float, yaw: float) -> None:
        self._physics, self._yaw = physics, yaw
        self._start = (x, y)
        self._phase = 0.0
        self.body = _make(physics, x, y, yaw)
        physics.set_group(self.body, range(-1, 5), Group.THING)
        for link in range(5):
            physics.set_surface(self.body, link, friction=0.5)
            pybullet.changeDynamics(
                self.body,
                link,
                linearDamping=0.0,
                angularDamping=0.0,
                contactStiffness=SOFT,
                contactDamping=SOFT_DAMPING * SOFT,
                physicsClientId=physics.client,
            )
        self.move(0.0, 0.0, yaw)

    @property
    def place(self) -> tuple[float, float]:
        """Where it is: x and y in map (m)."""
        dx, dy = (self._joint(joint)[0] for joint in (ALONG_X, ALONG_Y))
        return self._start[0] + dx, self._start[1] + dy

    @property
    def heading(self) -> float:
        """Where it looks (rad, in map)."""
        return wrap(self._yaw + self._joint(ABOUT_Z)[0])

    @property
    def velocity(self) -> tuple[float, float]:
        """m/s along map's x and y."""
        return self._joint(ALONG_X)[1], self._joint(ALONG_Y)[1]

    def move(self, vx: float, vy: float, heading: float, seconds: float = 0.0) -> None:
        """Walk at a velocity (m/s, in map) towards a heading (rad), ``seconds`` after the last call."""
        speed = math.hypot(vx, vy)
        self._phase += speed / STRIDE * seconds
        turn = min(max(4.0 * wrap(heading - self.heading), -3.0), 3.0)
        swing = speed * math.cos(self._phase)
        # A leg that has drifted off its swing is drawn back to it.
        offset = STRIDE * math.sin(self._phase)
        left, right = self._joint(LEFT)[0], self._joint(RIGHT)[0]
        legs = (swing + 4.0 * (offset - left), -swing + 4.0 * (-offset - right))
        if speed == 0.0:
            legs = (0.0, 0.0)
        pybullet.setJointMotorControlArray(
            self.body,
            list(range(5)),
            pybullet.VELOCITY_CONTROL,
            targetVelocities=[vx, vy, turn, *legs],
            forces=[PUSH, PUSH, TWIST, SWING, SWING],
            physicsClientId=self._physics.client,
        )

    def touches(self, other: int) -> float:
        """Return the force (N) with which it touches another body, in the last step."""
        return sum(contact.force for contact in self._physics.contacts(self.body, other))

    def _joint(self, joint: int) -> tuple[float, float]:
        state = pybullet.getJointState(self.body, joint, physicsClientId=self._physics.client)
        return state[0], state[1]


def _make(physics: Physics, x: float, y: float, yaw: float) -> int:
    low, high = TRUNK
    trunk = pybullet.createCollisionShape(
        pybullet.GEOM_CYLINDER, radius=RADIUS - 0.01, height=high - low, physicsClientId=physics.client
    )
    tall = low - CLEARANCE
    leg = pybullet.createCollisionShape(
        pybullet.GEOM_CYLINDER, radius=LEG_RADIUS, height=tall, physicsClientId=physics.client
    )
    upright, turned = (0.0, 0.0, 0.0, 1.0), (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
    middle = (low + high) / 2
    foot = CLEARANCE + tall / 2 - middle
    slide, turn = pybullet.JOINT_PRISMATIC, pybullet.JOINT_REVOLUTE
    made: int = pybullet.createMultiBody(
        0.0,
        -1,
        -1,
        (x, y, 0.0),
        upright,
        linkMasses=MASSES,
        linkCollisionShapeIndices=[-1, -1, trunk, leg, leg],
        linkVisualShapeIndices=[-1] * 5,
        linkPositions=[
            (0.0, 0.0, 0.0),
            (0.0, 0.0, 0.0),
            (0.0, 0.0, middle),
            (0.0, LEGS_APART / 2, foot),
            (0.0, -LEGS_APART / 2, foot),
        ],
        linkOrientations=[upright, upright, turned, upright, upright],
        linkInertialFramePositions=[(0.0, 0.0, 0.0)] * 5,
        linkInertialFrameOrientations=[upright] * 5,
        linkParentIndices=[0, 1, 2, 3, 3],
        linkJointTypes=[slide, slide, turn, slide, slide],
        linkJointAxis=[(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0), (1, 0, 0)],
        physicsClientId=physics.client,
    )
    return made
