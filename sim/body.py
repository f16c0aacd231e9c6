"""The robot's body in the physics: joints addressed by name, frames found by arithmetic."""

from __future__ import annotations

import itertools
import math
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
import pybullet

from tandem.sim.model import Hand, RobotModel
from tandem.sim.physics import ROBOTS, Group, Physics, robot_group
from tandem.sim.starts import ALONE
from tandem.sim.urdf import Array
from tandem.skills.ports.message import Quaternion, Vector3
from tandem.skills.ports.packages import resolve

PAD_FRICTION: Final = 1.0
"""Of fingertips, chosen as rubber: a hand holds by contact and friction alone."""
SKIN_FRICTION: Final = 0.5
"""Of the robot's other surfaces, chosen as metal and plastic."""
SPAWN_HEIGHT: Final = 0.001
"""Metres above the floor at which a robot is made, so that nothing starts inside the floor."""


@dataclass(frozen=True)
class JointReading:
    """Of one joint: rad or m, rad/s or m/s, and the motor's N m or N."""

    position: float
    velocity: float
    effort: float


class RobotBody:
    """A robot in a physics world.

    It is put at ``start`` once, in the given posture; from then on it is moved by its motors alone.

    Args:
        physics: the world to load it into.
        model: what to load.
        x: start on the floor, metres.
        y: start on the floor, metres.
        yaw: start heading, rad.
        positions: joint positions to start with, by joint; others start at the nearest to zero that they can.
        name: what the truth calls it.
        number: counts the robots of the world from 0.
    """

    def __init__(
        self,
        physics: Physics,
        model: RobotModel,
        *,
        x: float = 0.0,
        y: float = 0.0,
        yaw: float = 0.0,
        positions: dict[str, float] | None = None,
        name: str = ALONE,
        number: int = 0,
    ) -> None:
        self.physics = physics
        self.name = name
        self._group = robot_group(number)
        self.seen = Group.THING | Group.FIXED | Group(int(ROBOTS) & ~int(self._group))
        """What the rays of its sensors hit: everything but itself."""
        self.model = model
        self.body = _load(
            physics, model, (x, y, SPAWN_HEIGHT), (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))
        )
        self.joint_index: dict[str, int] = {}
        self.link_index: dict[str, int] = {model.root: -1}
        for index in range(pybullet.getNumJoints(self.body, physicsClientId=physics.client)):
            info = pybullet.getJointInfo(self.body, index, physicsClientId=physics.client)
            self.joint_index[info[1].decode()] = index
            self.link_index[info[12].decode()] = index
        self._root_in_mass_centre = self._inertial_offset()
        self._set_surfaces()
        self._forbid_neighbours_contacts()
        self._reset(positions or {})
        self._mass_centres: dict[str, Vector3] = {}
        for hand in model.hands:
            index = self.joint_index[hand.wrench_joint]
            info = pybullet.getDynamicsInfo(self.body, index, physicsClientId=physics.client)
            self._mass_centres[hand.wrench_joint] = info[3]
            pybullet.enableJointForceTorqueSensor(
                self.body, self.joint_index[hand.wrench_joint], 1, physicsClientId=physics.client
            )

    def overlaps(self) -> list[tuple[float, str, str]]:
        """Return which links are in each other and would be pushed apart, and how deep (m), deepest first.

        Looked at as the joints stand, without a step: contacts that the physics keeps are not touched.
        """
        allowed = {frozenset(pair) for pair in self.model.touching_links}
        names = {index: name for name, index in self.link_index.items()}
        for index in range(pybullet.getNumJoints(self.body, physicsClientId=self.physics.client)):
            parent = pybullet.getJointInfo(self.body, index, physicsClientId=self.physics.client)[16]
            allowed.add(frozenset((names[index], names[parent])))
        found = []
        for (first, i), (second, j) in itertools.combinations(self.link_index.items(), 2):
            if frozenset((first, second)) not in allowed:
                points = pybullet.getClosestPoints(
                    self.body, self.body, 0.0, linkIndexA=i, linkIndexB=j, physicsClientId=self.physics.client
                )
                found += [(-float(point[8]), first, second) for point in points or ()][:1]
        return sorted(found, reverse=True)

    def read(self, joints: Sequence[str]) -> list[JointReading]:
        """Return the joints' readings, in order."""
        if not joints:
            return []  # pybullet answers None to a question about no joint
        states = pybullet.getJointStates(
            self.body, [self.joint_index[name] for name in joints], physicsClientId=self.physics.client
        )
        return [JointReading(s[0], s[1], s[3]) for s in states or ()]  # None of no joints

    def reaction(self, joint: str) -> tuple[Vector3, Vector3]:
        """Return the force (N) and torque (N m) that a joint with a sensor passes to its child link.

        In the axes of the child link's frame, about its origin (pybullet gives it about the centre of mass).
        """
        state = pybullet.getJointState(
            self.body, self.joint_index[joint], physicsClientId=self.physics.client
        )
        fx, fy, fz, mx, my, mz = state[2]
        x, y, z = self._mass_centres[joint]
        return (fx, fy, fz), (mx + y * fz - z * fy, my + z * fx - x * fz, mz + x * fy - y * fx)

    def drive_velocities(
        self, joints: Sequence[str], velocities: Sequence[float], efforts: Sequence[float]
    ) -> None:
        """Set each motor's velocity (rad/s or m/s) and the most it may exert (N m or N)."""
        pybullet.setJointMotorControlArray(
            self.body,
            [self.joint_index[name] for name in joints],
            pybullet.VELOCITY_CONTROL,
            targetVelocities=velocities,
            forces=efforts,
            physicsClientId=self.physics.client,
        )

    def anchor_pads(self, hand: Hand, *, anchored: bool) -> None:
        """Let static friction at a hand's pads keep its place, or not: only while they squeeze.

        An anchor that outlives the squeezing pulls on what it should let go of (docs/decisions/001). Bullet
        keeps the anchors of contact points that it has; saying anew what the links are makes it find them
        afresh.
        """
        links = [self.link_index[link] for link in hand.finger_links]
        for link in links:
            self.physics.set_surface(self.body, link, friction=PAD_FRICTION, anchored=anchored)
        if not anchored:
            self.physics.set_group(self.body, links, self._group)

    def pad_force(self, hand: Hand) -> float:
        """Return the newtons with which a hand's fingers press on what is not the robot."""
        links = [self.link_index[link] for link in hand.finger_links]
        touched = self.physics.contacts(self.body, links=links)
        return sum(contact.force for contact in touched if contact.body_b != self.body)

    def base_pose(self) -> tuple[Vector3, Quaternion]:
        """Return the pose of the root frame (base_footprint) in the world."""
        centre, turn = self.physics.body_pose(self.body)
        at, rotation = pybullet.multiplyTransforms(centre, turn, *self._root_in_mass_centre)
        return at, rotation

    def frame_matrix(self, frame: str) -> Array:
        """Return the 4x4 pose in the world of any link or named frame, of the last step.

        Raises:
            KeyError: when the robot has no such frame.
        """
        if frame not in self.model.frames:
            raise KeyError(f"{self.model.description.name} has no frame {frame!r}")
        link, at = self.model.frames[frame]
        return self._link_matrix(link) @ at

    def _link_matrix(self, link: str) -> Array:
        index = self.link_index[link]
        if index < 0:
            position, orientation = self.base_pose()
        else:
            state = pybullet.getLinkState(
                self.body, index, computeForwardKinematics=1, physicsClientId=self.physics.client
            )
            position, orientation = state[4], state[5]
        matrix = np.eye(4)
        matrix[:3, :3] = np.array(pybullet.getMatrixFromQuaternion(orientation)).reshape(3, 3)
        matrix[:3, 3] = position
        return matrix

    def _inertial_offset(self) -> tuple[Vector3, Quaternion]:
        info = pybullet.getDynamicsInfo(self.body, -1, physicsClientId=self.physics.client)
        at, turn = pybullet.invertTransform(info[3], info[4])
        return at, turn

    def _set_surfaces(self) -> None:
        self.physics.set_group(self.body, self.link_index.values(), self._group)
        for link in self.link_index.values():
            self.physics.set_surface(self.body, link, friction=SKIN_FRICTION)
        for name, friction in self.model.floor_frictions.items():
            share = self.model.sideways_frictions.get(name, 1.0)
            self.physics.set_surface(
                self.body,
                self.link_index[name],
                friction=friction,
                sideways=share,
                anchored=name in self.model.anchored_wheels,
            )
        for name in (link for hand in self.model.hands for link in hand.finger_links):
            self.physics.set_surface(self.body, self.link_index[name], friction=PAD_FRICTION)
        for joint in self.joint_index.values():
            pybullet.changeDynamics(
                self.body, joint, linearDamping=0.0, angularDamping=0.0, physicsClientId=self.physics.client
            )

    def _forbid_neighbours_contacts(self) -> None:
        """Links that touch by construction (two joints apart, or the base's own parts) don't collide."""
        for first, second in self.model.touching_links:
            pybullet.setCollisionFilterPair(
                self.body, self.body, self.link_index[first], self.link_index[second], 0,
                physicsClientId=self.physics.client,
            )  # fmt: skip

    def _reset(self, positions: dict[str, float]) -> None:
        """Put the joints where they start, at rest; the only place where a state is set by hand."""
        for name, index in self.joint_index.items():
            info = pybullet.getJointInfo(self.body, index, physicsClientId=self.physics.client)
            if info[2] == pybullet.JOINT_FIXED:
                continue
            start = positions.get(name, min(max(0.0, info[8]), info[9]) if info[8] <= info[9] else 0.0)
            pybullet.resetJointState(self.body, index, start, physicsClientId=self.physics.client)


def _load(physics: Physics, model: RobotModel, position: Vector3, orientation: Quaternion) -> int:
    text = model.physics_urdf
    for uri in sorted({part.split('"')[0] for part in text.split('filename="')[1:]}):
        text = text.replace(uri, str(resolve(uri)))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "robot.urdf"
        path.write_text(text, encoding="utf-8")
        body: int = pybullet.loadURDF(
            str(path),
            position,
            orientation,
            useFixedBase=model.wheels is None,
            flags=pybullet.URDF_USE_INERTIA_FROM_FILE
            | pybullet.URDF_USE_SELF_COLLISION
            | pybullet.URDF_USE_SELF_COLLISION_EXCLUDE_PARENT
            | pybullet.URDF_MAINTAIN_LINK_ORDER,
            physicsClientId=physics.client,
        )
    return body
