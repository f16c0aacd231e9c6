"""Whether a URDF can be believed: each joint that can't be right is refused by its name.

Readers of URDFs take a lower limit above the upper one, a joint that mimics itself, or one name for two
joints, and compute with it. What is refused here would otherwise show as an arm that never finds a way.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from tandem.skills.ports.sources import DocumentError

ONE_NUMBER: Final = frozenset({"revolute", "continuous", "prismatic"})
"""Kinds whose position is one number."""
SEVERAL_NUMBERS: Final = frozenset({"floating", "planar"})
SHORTEST_AXIS: Final = 1e-6
"""What is shorter has lost its direction to rounding; an axis that is written is about 1 long."""
MEASURES: Final[Mapping[str, Mapping[str, int]]] = MappingProxyType(
    {"box": {"size": 3}, "cylinder": {"radius": 1, "length": 1}, "sphere": {"radius": 1}, "mesh": {}}
)
"""Geometries that all readers know, and how many numbers each of their measures has."""
INSTEAD: Final[Mapping[str, str]] = MappingProxyType({"capsule": "write it as a cylinder and two spheres"})
FINGERS: Final = 2
"""Of a hand that Tandem knows how to grasp with."""
OTHER_HANDS: Final = (
    "an arm with another hand is a group without an end effector: its tasks are refused in words"
)
KINDS: Final = ONE_NUMBER | SEVERAL_NUMBERS | {"fixed"}


class UrdfError(DocumentError):
    """A robot description that can't be right; the text names each joint, what was found and expected."""


@dataclass(frozen=True)
class Mimic:
    """A joint that follows another: its position is ``multiplier * source + offset`` (rad or m).

    One that follows a fixed joint stands at its offset.
    """

    source: str
    multiplier: float
    offset: float


def parsed(urdf: str) -> ET.Element:
    """Return the document, if its joints can be believed.

    Raises:
        UrdfError: it is no XML, or a joint can't be right.
    """
    try:
        root = ET.fromstring(urdf)  # noqa: S314 - the robot's own description
    except ET.ParseError as error:
        raise UrdfError(f"the robot's description is no XML: {error}") from error
    check(root)
    return root


def check(root: ET.Element) -> None:
    """Raise UrdfError, with a line for each mistake, unless all joints can be right."""
    if found := list(_mistakes(root)):
        raise UrdfError("\n".join(found))


def check_fingers(root: ET.Element, hands: Mapping[str, Sequence[str]]) -> None:
    """Raise UrdfError unless each hand, given by its name and fingers, is a parallel gripper.

    The width between the pads is the sum of what two fingers have slid, in metres, and the tool frame lies
    halfway. A hook, a suction cup or fingers that turn would be planned with wrong bodies.
    """
    kinds = {joint.get("name", ""): joint.get("type", "") for joint in root.findall("joint")}
    wrong = [
        f"hand {hand!r}: {each}"
        for hand, fingers in hands.items()
        for each in _finger_mistakes(fingers, kinds)
    ]
    if wrong:
        raise UrdfError("\n".join((*wrong, OTHER_HANDS)))


def mimics(root: ET.Element) -> Mapping[str, Mimic]:
    """Return the joints that follow another one, by name; of a document that was checked."""
    return {
        joint.get("name", ""): Mimic(
            mimic.get("joint", ""),
            float(mimic.get("multiplier") or 1.0),
            float(mimic.get("offset") or 0.0),
        )
        for joint in root.findall("joint")
        if (mimic := joint.find("mimic")) is not None
    }


def _mistakes(root: ET.Element) -> Iterator[str]:
    joints, links = root.findall("joint"), root.findall("link")
    for what, elements in (("joint", joints), ("link", links)):
        names = Counter(element.get("name", "").strip() for element in elements)
        yield from (f"{what} {name!r} is there {count} times" for name, count in names.items() if count > 1)
        if "" in names:
            yield f"a {what} without a name"
    for link in links:
        yield from (f"link {link.get('name', '')!r}: {each}" for each in _link_mistakes(link))
    known = Counter(link.get("name", "") for link in links)
    for joint in joints:
        who = f"joint {joint.get('name', '')!r}"
        kind = joint.get("type", "")
        if kind not in KINDS:
            yield f"{who}: expected a type out of {', '.join(sorted(KINDS))}, found {kind!r}"
        yield from (f"{who}: {each}" for each in (*_ends(joint, known), *_parts_once(joint), *_origin(joint)))
        if kind in ONE_NUMBER:
            yield from (f"{who}: {each}" for each in (*_axis(joint), *_limit(joint, kind)))
    yield from _mimic_mistakes(joints)
    yield from _tree_mistakes(joints, known)


def _finger_mistakes(fingers: Sequence[str], kinds: Mapping[str, str]) -> Iterator[str]:
    if len(fingers) != FINGERS:
        found = ", ".join(map(repr, fingers)) or "none"
        yield f"expected the joints of two fingers that slide apart, found {found}"
        return
    for finger in fingers:
        if kinds.get(finger) != "prismatic":
            yield f"expected a prismatic finger, found {finger!r}, which is {kinds.get(finger, 'no joint')}"


def _link_mistakes(link: ET.Element) -> Iterator[str]:
    """Parsers drop an inertial that they can't read, and the link then weighs nothing."""
    for mass in link.findall("inertial/mass"):
        if not 0.0 <= _number(mass.get("value", "")) < math.inf:
            yield f"expected a mass of at least 0, found {mass.get('value', '')!r}"
    for part in (*link.findall("inertial"), *link.findall("visual"), *link.findall("collision")):
        yield from (f"{part.tag}: {each}" for each in _origin(part))
    for collision in link.findall("collision"):
        yield from (f"collision: {each}" for each in _geometry(collision))


def _geometry(collision: ET.Element) -> Iterator[str]:
    """Parsers drop a shape that they can't read, and arms then go through the link."""
    shapes = collision.findall("geometry/*")
    if len(shapes) != 1:
        yield f"expected one geometry, found {', '.join(each.tag for each in shapes) or 'none'}"
        return
    (shape,) = shapes
    if shape.tag not in MEASURES:
        instead = f"; {INSTEAD[shape.tag]}" if shape.tag in INSTEAD else ""
        yield f"expected a geometry out of {', '.join(MEASURES)}, found {shape.tag}{instead}"
        return
    for name, count in MEASURES[shape.tag].items():
        numbers = [_number(each) for each in shape.get(name, "").split()]
        if len(numbers) != count or not all(0.0 <= each < math.inf for each in numbers):
            wanted = "a number" if count == 1 else f"{count} numbers"
            yield f"expected {wanted} of at least 0 for the {shape.tag}'s {name}, found {shape.get(name)!r}"


def _parts_once(joint: ET.Element) -> Iterator[str]:
    """Parsers take the first of two, or the last."""
    for name in ("parent", "child", "origin", "axis", "limit", "mimic"):
        if len(joint.findall(name)) > 1:
            yield f"expected one <{name}>, found several"


def _origin(element: ET.Element) -> Iterator[str]:
    origin = element.find("origin")
    for name in ("xyz", "rpy"):
        text = None if origin is None else origin.get(name)
        if text is not None and not _is_vector(text):
            yield f"expected three numbers for the origin's {name}, found {text!r}"


def _tree_mistakes(joints: list[ET.Element], links: Mapping[str, int]) -> Iterator[str]:
    """Each link hangs on one joint, but for the root; whatever is left over hangs on itself."""
    parents: dict[str, str] = {}
    for joint in joints:
        child, name = _end(joint, "child"), joint.get("name", "")
        if child in parents:
            yield f"link {child!r}: expected one joint that it hangs on, found {name!r} as well"
        parents[child] = _end(joint, "parent")
    roots = [link for link in links if link not in parents]
    if len(roots) > 1:
        yield f"expected one link that hangs on no joint, found {', '.join(map(repr, roots))}"
    if not links:
        yield "expected at least one link"
    below: dict[str, list[str]] = {}
    for child, parent in parents.items():
        below.setdefault(parent, []).append(child)
    reached, waiting = set(roots), list(roots)
    while waiting:
        children = [each for each in below.get(waiting.pop(), ()) if each not in reached]
        reached.update(children)
        waiting.extend(children)
    if circle := [link for link in links if link not in reached]:
        yield f"expected a tree; these links hang on each other: {', '.join(map(repr, circle))}"


def _ends(joint: ET.Element, links: Mapping[str, int]) -> Iterator[str]:
    for end in ("parent", "child"):
        link = _end(joint, end)
        if link not in links:
            yield f"expected a {end} link that is there, found {link!r}"


def _end(joint: ET.Element, end: str) -> str:
    element = joint.find(end)
    return "" if element is None else element.get("link", "")


def _axis(joint: ET.Element) -> Iterator[str]:
    element = joint.find("axis")
    text = "1 0 0" if element is None else element.get("xyz", "1 0 0")
    if not _is_vector(text) or math.hypot(*map(float, text.split())) < SHORTEST_AXIS:
        yield f"expected an axis of three numbers, not all 0, found {text!r}"


def _limit(joint: ET.Element, kind: str) -> Iterator[str]:
    limit = joint.find("limit")
    if limit is None:
        if kind != "continuous":
            yield f"a {kind} joint needs a <limit>"
        return
    for name in ("velocity", "effort"):
        text = limit.get(name, "")
        if not 0.0 <= _number(text) < math.inf:
            yield f"expected {name} of at least 0, found {text!r}"
    if kind == "continuous":
        return
    lower, upper = (_number(limit.get(name, "0")) for name in ("lower", "upper"))
    if not all(map(math.isfinite, (lower, upper))):
        yield f"expected finite limits, found {limit.get('lower')!r} and {limit.get('upper')!r}"
    elif not lower <= upper:
        yield f"expected a lower limit of at most the upper one, found {lower:g} and {upper:g}"


def _mimic_mistakes(joints: list[ET.Element]) -> Iterator[str]:
    kinds = {joint.get("name", ""): joint.get("type", "") for joint in joints}
    following = {joint.get("name", "") for joint in joints if joint.find("mimic") is not None}
    for joint in joints:
        mimic = joint.find("mimic")
        if mimic is None:
            continue
        who, source = f"joint {joint.get('name', '')!r}", mimic.get("joint", "")
        if source not in kinds:
            yield f"{who}: it mimics {source!r}, and there is no such joint"
        elif SEVERAL_NUMBERS & {kinds[source], joint.get("type", "")}:
            yield f"{who}: it mimics {source!r}; only joints of one number can do that"
        elif source in following:
            yield f"{who}: it mimics {source!r}, which mimics another"
        for name in ("multiplier", "offset"):
            if not math.isfinite(_number(mimic.get(name) or "0")):
                yield f"{who}: expected a number for {name}, found {mimic.get(name)!r}"


def _is_vector(text: str) -> bool:
    parts = [_number(part) for part in text.split()]
    return len(parts) == 3 and all(map(math.isfinite, parts))  # noqa: PLR2004 - x, y, z


def _number(text: str) -> float:
    """Return the number, NaN for what is none."""
    try:
        return float(text)
    except ValueError:
        return math.nan
