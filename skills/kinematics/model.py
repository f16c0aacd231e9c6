"""The robot's kinematics out of its URDF: where every frame is, and how it moves with a group's joints.

Everything is told in the base frame, the root of the URDF; the base itself stands still.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.transforms import Array, to_pose
from tandem.skills.ports.packages import resolve
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.urdf_check import SEVERAL_NUMBERS, Mimic, UrdfError, mimics, parsed


class UnknownNameError(KeyError):
    """A joint, frame or group that the robot does not have; the message names some that it has."""


@dataclass(frozen=True)
class Limits:
    """Of some joints, in order: rad (or m) and rad/s (or m/s), each an array (n,)."""

    lower: Array
    upper: Array
    velocity: Array


def plain_urdf(urdf: str) -> str:
    """Return the URDF with the collision meshes' paths resolved, no visuals, and each joint one number.

    An endless joint becomes one of [-pi, pi]: wheels are not moved here, and an arm's endless joint loses
    nothing but a second way round. A floating or planar joint is fixed where the URDF has it: it is what
    moves the whole robot (which is not told here: the base stands still), or a thing that nobody drives.

    Raises:
        UrdfError: the text is no URDF, or a joint of it can't be right.
        FileNotFoundError: a mesh is missing.
    """
    root = parsed(urdf)
    for link in root.iter("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
    for mesh in root.iter("mesh"):
        mesh.set("filename", str(resolve(mesh.get("filename", ""))))
    for joint in root.findall("joint"):
        if joint.get("type") in SEVERAL_NUMBERS:
            joint.set("type", "fixed")
        if joint.get("type") == "continuous":
            joint.set("type", "revolute")
            limit = joint.find("limit")
            limit = ET.SubElement(joint, "limit", effort="100", velocity="3") if limit is None else limit
            limit.set("lower", str(-math.pi))
            limit.set("upper", str(math.pi))
    return ET.tostring(root, encoding="unicode")


class RobotKinematics:
    """The whole robot, its base fixed.

    A joint that mimics another one stands where that puts it, and is in no group; nor is the one that it
    mimics: a chain that moved it would have to move both.

    Args:
        urdf: the text; meshes as ``package://`` addresses.
        groups: joints by the group's name.

    Raises:
        UrdfError: the text is no URDF, a joint of it can't be right, or a group names one that is not of one
            number or does not move alone.
        UnknownNameError: a group names a joint that is not there.
    """

    def __init__(self, urdf: str, groups: Mapping[str, Sequence[str]]) -> None:
        document = parsed(urdf)
        self._mimics = mimics(document)
        _refuse_groups(document, self._mimics, groups)
        self.urdf = plain_urdf(urdf)
        self.model = pin.buildModelFromXML(self.urdf)
        self._data: pin.Data | None = None
        """Of ``poses`` alone; made by the first of them, and by each process anew."""
        self.joints: tuple[str, ...] = tuple(self.model.names)[1:]
        self._index = {name: self._place(name) for name in self.joints}
        self._frames = {frame.name: i for i, frame in enumerate(self.model.frames)}
        self.groups = {name: tuple(joints) for name, joints in groups.items()}
        for name, joints in self.groups.items():
            if missing := [joint for joint in joints if joint not in self._index]:
                raise UnknownNameError(f"group {name!r} names {missing}; the URDF has {self.joints[:40]}")

    def _place(self, joint: str) -> int:
        """Return the joint's place in a configuration.

        It is pinocchio's ``idx_q``, which is its number less one only because each joint is one number:
        ``plain_urdf`` sees to that, and all that counts joints (chains, columns of Jacobians) rests on it.
        """
        number = self.model.getJointId(joint)
        place = int(self.model.joints[number].idx_q)
        if self.model.joints[number].nq != 1 or place != number - 1:
            raise UrdfError(f"joint {joint!r}: expected a joint of one number")
        return place

    def joint_index(self, joint: str) -> int:
        """Return the joint's place in a full configuration."""
        try:
            return self._index[joint]
        except KeyError:
            raise UnknownNameError(f"no joint {joint!r}; there are {', '.join(self.joints[:40])}") from None

    def frame_index(self, frame: str) -> int:
        """Return pinocchio's number of a frame (a link or a joint)."""
        try:
            return self._frames[frame]
        except KeyError:
            raise UnknownNameError(f"no frame {frame!r} among the {len(self._frames)} of the robot") from None

    def limits(self, joints: Sequence[str]) -> Limits:
        """Return the URDF's limits of the joints, in their order.

        Raises:
            UrdfError: one of them mimics another and has none of its own.
        """
        if following := [joint for joint in joints if joint in self._mimics]:
            raise UrdfError(f"joint {following[0]!r} mimics {self._mimics[following[0]].source!r}")
        rows = [self.joint_index(joint) for joint in joints]
        return Limits(
            np.array(self.model.lowerPositionLimit)[rows],
            np.array(self.model.upperPositionLimit)[rows],
            np.array(self.model.velocityLimit)[rows],
        )

    def configuration(self, positions: Mapping[str, float]) -> Array:
        """Return the full configuration (n,) of joint positions by name.

        What is not named stands at zero, or at the limit nearest to it; what mimics another and is not named,
        where that puts it. Names that the model does not have (the hardware may tell more) are left out.
        """
        full = np.clip(
            np.zeros(len(self.joints)), self.model.lowerPositionLimit, self.model.upperPositionLimit
        )
        for name, value in positions.items():
            if name in self._index:
                full[self._index[name]] = value
        for name, mimic in self._mimics.items():
            if name in self._index and name not in positions:
                source = full[self._index[mimic.source]] if mimic.source in self._index else 0.0
                full[self._index[name]] = mimic.multiplier * source + mimic.offset
        return full

    def pose(self, frame: str, positions: Mapping[str, float]) -> Pose:
        """Return the frame in the base, the joints standing at ``positions`` (see ``configuration``)."""
        return self.poses((frame,), positions)[0]

    def poses(self, frames: Sequence[str], positions: Mapping[str, float]) -> tuple[Pose, ...]:
        """Return several frames in the base."""
        if self._data is None:  # making it takes as long as several forward kinematics
            self._data = self.model.createData()
        data = self._data
        pin.forwardKinematics(self.model, data, self.configuration(positions))
        return tuple(
            to_pose(pin.updateFramePlacement(self.model, data, self.frame_index(frame))) for frame in frames
        )

    def chain(self, joints: Sequence[str], positions: Mapping[str, float]) -> Chain:
        """Return the kinematics of some joints while all others stand at ``positions``."""
        return Chain(self, joints, positions)


def _refuse_groups(
    document: ET.Element, following: Mapping[str, Mimic], groups: Mapping[str, Sequence[str]]
) -> None:
    """Raise UrdfError for a group with a joint that can't be moved as one number of its own."""
    kinds = {joint.get("name", ""): joint.get("type", "") for joint in document.findall("joint")}
    followed = {mimic.source: name for name, mimic in following.items()}
    for name, joints in groups.items():
        for joint in joints:
            who = f"group {name!r}: joint {joint!r}"
            if kinds.get(joint) in SEVERAL_NUMBERS:
                raise UrdfError(f"{who} is {kinds[joint]}; expected joints of one number")
            if joint in following:
                raise UrdfError(f"{who} mimics {following[joint].source!r} and can't be moved by itself")
            if joint in followed:
                raise UrdfError(f"{who} moves {followed[joint]!r} too, which mimics it; no chain knows that")


class Chain:
    """Some joints of a robot, the others locked: small, so that it is fast.

    Args:
        robot: the whole.
        joints: those that move, in the order of every array (n,) here.
        positions: where the others stand.
    """

    def __init__(self, robot: RobotKinematics, joints: Sequence[str], positions: Mapping[str, float]) -> None:
        self.robot = robot
        self.joints = tuple(joints)
        self.reference = robot.configuration(positions)
        moving = {robot.joint_index(joint) + 1 for joint in joints}
        self.locked = [i for i in range(1, robot.model.njoints) if i not in moving]
        self.model = pin.buildReducedModel(robot.model, self.locked, self.reference)
        self._data = self.model.createData()
        names = list(self.model.names)[1:]
        order = [names.index(joint) for joint in self.joints]
        self._order = None if order == list(range(len(order))) else np.argsort(order)
        self._columns = order
        self._frames = {frame.name: i for i, frame in enumerate(self.model.frames)}

    def to_model(self, q: Array) -> Array:
        """Return the positions in the order of pinocchio's reduced model."""
        return q if self._order is None else np.asarray(q)[self._order]

    def placement(self, q: Array, frame: str) -> pin.SE3:
        """Return the frame in the base as SE3."""
        pin.forwardKinematics(self.model, self._data, self.to_model(q))
        return pin.updateFramePlacement(self.model, self._data, self.frame(frame)).copy()

    def pose(self, q: Array, frame: str) -> Pose:
        """Return the frame in the base."""
        return to_pose(self.placement(q, frame))

    def frame(self, name: str) -> int:
        """Return the frame's number in the reduced model."""
        if name not in self._frames:
            raise UnknownNameError(f"no frame {name!r} among the {len(self._frames)} of the robot")
        return self._frames[name]

    def jacobian(self, q: Array, frame: str) -> Array:
        """Return the Jacobian (6, n) of the frame, along and about the base's axes at the frame's origin.

        Rows 0 to 2 are linear (m/s per rad/s), 3 to 5 angular.
        """
        full = pin.computeFrameJacobian(
            self.model, self._data, self.to_model(q), self.frame(frame), pin.LOCAL_WORLD_ALIGNED
        )
        return np.asarray(full)[:, self._columns]

    def twist_to(self, q: Array, frame: str, target: pin.SE3) -> tuple[Array, Array]:
        """Return the twist (6,) that brings the frame to the target in one second, and its Jacobian (6, n).

        Both in the frame's own axes: log6(T^-1 T_target) and the Jacobian of that error with respect to
        the joints, -Jlog6 J (Pinocchio's CLIK example).
        """
        number = self.frame(frame)
        pin.computeJointJacobians(self.model, self._data, self.to_model(q))
        local = pin.getFrameJacobian(self.model, self._data, number, pin.LOCAL)
        here = pin.updateFramePlacement(self.model, self._data, number)
        motion = pin.log6(here.actInv(target))  # kept alive: ``vector`` only looks into it
        return np.array(motion.vector), np.asarray(local)[:, self._columns]
