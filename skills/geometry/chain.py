"""Where a frame of the robot is: a chain of joints out of a URDF text, in plain Python.

For a sensor's mount (camera, laser) the whole kinematics library would be too much: one walk from the root
to the tip, a few microseconds a joint.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import dataclass

from tandem.skills.geometry.poses import about, compose, from_rpy, scale
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import IDENTITY, Pose

_FIXED = "fixed"
_TURNING = frozenset({"revolute", "continuous"})
_SLIDING = "prismatic"


@dataclass(frozen=True)
class ChainJoint:
    """One joint: its frame in the parent link, its kind ("fixed" as well) and its axis in its own frame."""

    name: str
    parent: str
    child: str
    kind: str
    origin: Pose
    axis: Vector3
    mimics: tuple[str, float, float] | None = None
    """The joint that it follows, with multiplier and offset."""

    def motion(self, positions: Mapping[str, float]) -> Pose:
        """Return the child's pose in the joint's frame at these positions (rad or m).

        Raises:
            KeyError: naming the joint whose position is missing.
        """
        if self.kind == _FIXED:
            return IDENTITY
        source, factor, offset = self.mimics or (self.name, 1.0, 0.0)
        if source not in positions:
            raise KeyError(f"no position of joint {source!r}; there are {', '.join(sorted(positions))}")
        value = factor * positions[source] + offset
        if self.kind == _SLIDING:
            return Pose(position=scale(self.axis, value))
        return Pose(orientation=about(self.axis, value))


@dataclass(frozen=True)
class Chain:
    """The joints from ``root`` to ``tip``, neighbouring fixed ones folded into one pose each."""

    root: str
    tip: str
    steps: tuple[ChainJoint, ...]
    """The moving joints; each one's origin is told in the child link of the moving joint before it."""
    end: Pose
    """The tip in the child of the last moving joint (or in the root)."""

    @classmethod
    def from_urdf(cls, urdf: str, root: str, tip: str) -> Chain:
        """Read the chain.

        Args:
            urdf: the text of the URDF.
            root: the link (or frame, as a link without mass) that poses are told in.
            tip: the link or frame that is asked for; below the root.

        Raises:
            ValueError: when the text is no URDF, has a joint of another kind in the chain, or when the tip
                is not below the root.
        """
        by_child = {joint.child: joint for joint in _joints(urdf)}
        path: list[ChainJoint] = []
        link = tip
        while link != root:
            if link not in by_child:
                raise ValueError(f"expected {tip!r} below {root!r}; its chain ends at {link!r}")
            path.append(by_child[link])
            link = path[-1].parent
        steps: list[ChainJoint] = []
        before = IDENTITY
        for joint in reversed(path):
            if joint.kind == _FIXED:
                before = compose(before, joint.origin)
            elif joint.kind == _SLIDING or joint.kind in _TURNING:
                steps.append(_moved(joint, before))
                before = IDENTITY
            else:
                raise ValueError(f"joint {joint.name!r}: fixed, revolute or prismatic, not {joint.kind!r}")
        return cls(root=root, tip=tip, steps=tuple(steps), end=before)

    @property
    def joints(self) -> tuple[str, ...]:
        """The joints whose positions ``pose`` needs, from the root on."""
        return tuple(step.mimics[0] if step.mimics else step.name for step in self.steps)

    def pose(self, joint_positions: Mapping[str, float]) -> Pose:
        """Return the tip in the root at these joint positions (rad or m, by name; others are ignored).

        Raises:
            KeyError: naming the joint whose position is missing.
        """
        return self.poses(joint_positions)[-1]

    def poses(self, joint_positions: Mapping[str, float]) -> tuple[Pose, ...]:
        """Return the child of each moving joint, and last the tip, in the root.

        Raises:
            KeyError: naming the joint whose position is missing.
        """
        reached = [IDENTITY]
        for step in self.steps:
            reached.append(compose(compose(reached[-1], step.origin), step.motion(joint_positions)))
        return (*reached[1:], compose(reached[-1], self.end))


def _moved(joint: ChainJoint, before: Pose) -> ChainJoint:
    return ChainJoint(
        joint.name,
        joint.parent,
        joint.child,
        joint.kind,
        compose(before, joint.origin),
        joint.axis,
        joint.mimics,
    )


def _joints(urdf: str) -> list[ChainJoint]:
    try:
        robot = ET.fromstring(urdf)  # noqa: S314 - the text comes from the robot's own hardware
    except ET.ParseError as error:
        raise ValueError(f"expected a URDF text: {error}") from None
    return [_joint(element) for element in robot.findall("joint")]


def _joint(element: ET.Element) -> ChainJoint:
    origin, mimic = element.find("origin"), element.find("mimic")
    axis = _numbers(element.find("axis"), "xyz", (1.0, 0.0, 0.0))
    size = math.sqrt(sum(part * part for part in axis)) or 1.0
    return ChainJoint(
        name=element.get("name", ""),
        parent=_link(element, "parent"),
        child=_link(element, "child"),
        kind=element.get("type", ""),
        origin=Pose(
            position=_numbers(origin, "xyz", (0.0, 0.0, 0.0)),
            orientation=from_rpy(*_numbers(origin, "rpy", (0.0, 0.0, 0.0))),
        ),
        axis=scale(axis, 1.0 / size),
        mimics=None
        if mimic is None
        else (mimic.get("joint", ""), float(mimic.get("multiplier", "1")), float(mimic.get("offset", "0"))),
    )


def _link(element: ET.Element, end: str) -> str:
    found = element.find(end)
    return "" if found is None else found.get("link", "")


def _numbers(element: ET.Element | None, name: str, default: Vector3) -> Vector3:
    if element is None or name not in element.attrib:
        return default
    x, y, z = (float(part) for part in element.attrib[name].split())
    return (x, y, z)
