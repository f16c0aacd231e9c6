"""Work on a URDF document: cut a branch, weld what is rigidly joined, hang on new links."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from tandem.skills.ports.urdf_check import SEVERAL_NUMBERS, UrdfError, check, mimics

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Inertial:
    """Mass in kg, centre of mass in the link's frame, 3x3 inertia about it with the link frame's axes."""

    mass: float
    centre: Array
    inertia: Array


def rotation(roll: float, pitch: float, yaw: float) -> Array:
    """Return R_z(yaw) R_y(pitch) R_x(roll), the URDF's convention."""
    cr, sr, cp, sp, cy, sy = (f(a) for a in (roll, pitch, yaw) for f in (np.cos, np.sin))
    return np.array(
        [
            [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr],
        ]
    )


def rpy_of(turn: Array) -> tuple[float, float, float]:
    """Return roll, pitch, yaw of a rotation matrix (yaw 0 at a pitch of a right angle)."""
    pitch = float(np.arctan2(-turn[2, 0], np.hypot(turn[0, 0], turn[1, 0])))
    if abs(np.cos(pitch)) < 1e-7:
        return float(np.arctan2(-turn[1, 2], turn[1, 1])), pitch, 0.0
    return (
        float(np.arctan2(turn[2, 1], turn[2, 2])),
        pitch,
        float(np.arctan2(turn[1, 0], turn[0, 0])),
    )


def pose_matrix(element: ET.Element | None) -> Array:
    """Return the 4x4 transform of an ``<origin>``; the identity where there is none."""
    matrix = np.eye(4)
    if element is not None:
        matrix[:3, :3] = rotation(*_numbers(element.get("rpy", "0 0 0")))
        matrix[:3, 3] = _numbers(element.get("xyz", "0 0 0"))
    return matrix


def _numbers(text: str) -> tuple[float, float, float]:
    a, b, c = (float(part) for part in text.split())
    return a, b, c


def write_origin(parent: ET.Element, matrix: Array) -> None:
    """Set the ``<origin>`` of a joint, visual, collision or inertial."""
    origin = parent.find("origin")
    if origin is None:
        origin = ET.Element("origin")
        parent.insert(0, origin)
    origin.set("xyz", " ".join(f"{v:.9g}" for v in matrix[:3, 3]))
    origin.set("rpy", " ".join(f"{v:.9g}" for v in rpy_of(matrix[:3, :3])))


def read_inertial(link: ET.Element) -> Inertial | None:
    """Return a link's mass and inertia, or None for a link without mass."""
    element = link.find("inertial")
    if element is None:
        return None
    mass_element, tensor = element.find("mass"), element.find("inertia")
    mass = 0.0 if mass_element is None else float(mass_element.get("value", "0"))
    if mass <= 0.0 or tensor is None:
        return None
    i = {key: float(value) for key, value in tensor.attrib.items()}
    local = np.array(
        [
            [i["ixx"], i["ixy"], i["ixz"]],
            [i["ixy"], i["iyy"], i["iyz"]],
            [i["ixz"], i["iyz"], i["izz"]],
        ]
    )
    at = pose_matrix(element.find("origin"))
    return Inertial(mass, at[:3, 3], at[:3, :3] @ local @ at[:3, :3].T)


def write_inertial(link: ET.Element, inertial: Inertial) -> None:
    """Replace a link's mass and inertia."""
    old = link.find("inertial")
    if old is not None:
        link.remove(old)
    element = ET.Element("inertial")
    link.insert(0, element)
    at = np.eye(4)
    at[:3, 3] = inertial.centre
    write_origin(element, at)
    ET.SubElement(element, "mass", value=f"{inertial.mass:.9g}")
    keys = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
    ET.SubElement(element, "inertia", {k: f"{inertial.inertia[at]:.9g}" for k, at in keys.items()})


def add_inertials(first: Inertial | None, second: Inertial | None) -> Inertial | None:
    """Return both as one body (parallel axes); both are given in the same frame."""
    if first is None or second is None:
        return first or second
    mass = first.mass + second.mass
    centre = (first.mass * first.centre + second.mass * second.centre) / mass
    inertia = sum((_about(part, centre) for part in (first, second)), np.zeros((3, 3)))
    return Inertial(mass, centre, inertia)


def _about(part: Inertial, point: Array) -> Array:
    d = part.centre - point
    shift: Array = np.dot(d, d) * np.eye(3) - np.outer(d, d)
    return part.inertia + part.mass * shift


class UrdfDocument:
    """A URDF that is being changed. Links and joints are found by name."""

    def __init__(self, text: str) -> None:
        self.root = ET.fromstring(text)  # noqa: S314  # the file comes from the installed package
        for tag in ("gazebo", "transmission"):
            for element in self.root.findall(tag):
                self.root.remove(element)
        self.welded: dict[str, tuple[str, Array]] = {}

    def links(self) -> list[str]:
        """Return the links' names in the document's order."""
        return [link.attrib["name"] for link in self.root.findall("link")]

    def joints(self) -> list[ET.Element]:
        """Return the joints in the document's order."""
        return self.root.findall("joint")

    def link(self, name: str) -> ET.Element:
        """Return a link.

        Raises:
            KeyError: naming it, when there is none.
        """
        return self._named("link", name)

    def joint(self, name: str) -> ET.Element:
        """Return a joint.

        Raises:
            KeyError: naming it, when there is none.
        """
        return self._named("joint", name)

    def _named(self, tag: str, name: str) -> ET.Element:
        found = next((e for e in self.root.findall(tag) if e.get("name") == name), None)
        if found is None:
            raise KeyError(f"no {tag} {name!r} in this URDF")
        return found

    def cut(self, link: str) -> None:
        """Remove a link, the joint that holds it, and all that hangs on it."""
        for joint in self.joints():
            if end_of(joint, "parent") == link:
                self.cut(end_of(joint, "child"))
        for joint in self.joints():
            if end_of(joint, "child") == link:
                self.root.remove(joint)
        self.root.remove(self.link(link))

    def add(self, elements: str) -> None:
        """Append links and joints written as URDF."""
        for element in ET.fromstring(f"<robot>{elements}</robot>"):  # noqa: S314  # written in this package
            self.root.append(element)

    def put_first(self, link: str) -> None:
        """Put a new root before all links: pybullet crashes on one that comes after its children."""
        element = self.link(link)
        self.root.remove(element)
        self.root.insert(0, element)

    def parents_first(self) -> None:
        """Put each link that comes before its parent behind it; all others stay in their order.

        pybullet measures the reaction at a joint as NaN, or crashes, when a child link comes first.
        """
        parent_of = {end_of(joint, "child"): end_of(joint, "parent") for joint in self.joints()}
        waiting: dict[str, list[str]] = {}
        ordered: list[str] = []
        for name in self.links():
            parent = parent_of.get(name)
            if parent is not None and parent not in ordered and parent != name:
                waiting.setdefault(parent, []).append(name)
                continue
            ready = [name]
            while ready:
                ordered.append(ready[0])
                ready[:1] = waiting.pop(ready[0], [])
        if ordered == self.links() or len(ordered) < len(self.links()):
            return  # what hangs on no root is for ``check`` to say
        slots = [index for index, element in enumerate(self.root) if element.tag == "link"]
        for index, link in zip(slots, [self.link(name) for name in ordered], strict=True):
            self.root[index] = link

    def fix(self, joint_name: str) -> None:
        """Make a joint rigid at its zero."""
        joint = self.joint(joint_name)
        joint.set("type", "fixed")
        for child in list(joint):
            if child.tag not in ("parent", "child", "origin"):
                joint.remove(child)

    def weld(self, keep: Iterable[str]) -> None:
        """Merge every link on a fixed joint into its parent, but those named in ``keep``.

        ``welded`` then says where each merged link's frame went: the link it is part of now and the
        4x4 pose in it.
        """
        kept = frozenset(keep)
        while True:
            fixed = (joint for joint in self.joints() if joint.get("type") == "fixed")
            joint = next((joint for joint in fixed if end_of(joint, "child") not in kept), None)
            if joint is None:
                return
            self._merge(joint)

    def _merge(self, joint: ET.Element) -> None:
        parent, child = end_of(joint, "parent"), end_of(joint, "child")
        child_in_parent = pose_matrix(joint.find("origin"))
        parent_link, child_link = self.link(parent), self.link(child)
        inertial = read_inertial(child_link)
        if inertial is not None:
            turn = child_in_parent[:3, :3]
            moved = Inertial(
                inertial.mass,
                child_in_parent[:3, 3] + turn @ inertial.centre,
                turn @ inertial.inertia @ turn.T,
            )
            total = add_inertials(read_inertial(parent_link), moved)
            assert total is not None
            write_inertial(parent_link, total)
        for shape in [*child_link.findall("visual"), *child_link.findall("collision")]:
            write_origin(shape, child_in_parent @ pose_matrix(shape.find("origin")))
            parent_link.append(shape)
        for other in self.joints():
            if other is not joint and end_of(other, "parent") == child:
                write_origin(other, child_in_parent @ pose_matrix(other.find("origin")))
                _end(other, "parent").set("link", parent)
        for name, (link, at) in self.welded.items():
            if link == child:
                self.welded[name] = (parent, child_in_parent @ at)
        self.welded[child] = (parent, child_in_parent)
        self.root.remove(joint)
        self.root.remove(child_link)

    def add_frame(self, name: str, parent: str, at: Array) -> None:
        """Hang a link without mass or shape on ``parent``: a named frame."""
        ET.SubElement(self.root, "link", name=name)
        joint = ET.SubElement(self.root, "joint", name=f"{name}_frame_joint", type="fixed")
        write_origin(joint, at)
        ET.SubElement(joint, "parent", link=parent)
        ET.SubElement(joint, "child", link=name)

    def check(self) -> None:
        """Refuse what the physics would not move as the URDF says.

        Raises:
            UrdfError: naming a joint that can't be right, that mimics another (the physics would move it by
                itself), or that is of several numbers (the physics has no motor for it).
        """
        check(self.root)
        for name, mimic in mimics(self.root).items():
            raise UrdfError(
                f"joint {name!r} mimics {mimic.source!r}; the simulation moves each joint by itself"
            )
        for joint in self.joints():
            if joint.get("type") in SEVERAL_NUMBERS:
                raise UrdfError(f"joint {joint.get('name')!r} is {joint.get('type')}; no motor moves that")

    def text(self) -> str:
        """Return the document."""
        ET.indent(self.root)
        return ET.tostring(self.root, encoding="unicode")


def _end(joint: ET.Element, end: str) -> ET.Element:
    element = joint.find(end)
    if element is None:
        raise KeyError(f"joint {joint.get('name')!r} has no <{end}>")
    return element


def end_of(joint: ET.Element, end: str) -> str:
    """Return the link at a joint's ``parent`` or ``child`` end."""
    return _end(joint, end).attrib["link"]
