"""Whether a URDF can be believed: each joint that can't be right is refused by its name.

Readers of URDFs take a lower limit above the upper one, a joint that mimics itself, or one name for two
joints, and compute with it. What is refused here would otherwise show as an arm that never finds a way.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Final

ONE_NUMBER: Final = frozenset({"revolute", "continuous", "prismatic"})
"""Kinds whose position is one number."""
SEVERAL_NUMBERS: Final = frozenset({"floating", "planar"})
KINDS: Final = ONE_NUMBER | SEVERAL_NUMBERS | {"fixed"}


class UrdfError(ValueError):
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
    joints = root.findall("joint")
    names = Counter(joint.get("name", "") for joint in joints)
    links = Counter(link.get("name", "") for link in root.findall("link"))
    yield from (f"joint {name!r} is there {count} times" for name, count in names.items() if count > 1)
    yield from (f"link {name!r} is there {count} times" for name, count in links.items() if count > 1)
    for joint in joints:
        who = f"joint {joint.get('name', '')!r}"
        kind = joint.get("type", "")
        if kind not in KINDS:
            yield f"{who}: expected a type out of {', '.join(sorted(KINDS))}, found {kind!r}"
        yield from (f"{who}: {each}" for each in _ends(joint, links))
        if kind in ONE_NUMBER:
            yield from (f"{who}: {each}" for each in (*_axis(joint), *_limit(joint, kind)))
    yield from _mimic_mistakes(joints)


def _ends(joint: ET.Element, links: Mapping[str, int]) -> Iterator[str]:
    for end in ("parent", "child"):
        element = joint.find(end)
        link = "" if element is None else element.get("link", "")
        if link not in links:
            yield f"expected a {end} link that is there, found {link!r}"


def _axis(joint: ET.Element) -> Iterator[str]:
    element = joint.find("axis")
    text = "1 0 0" if element is None else element.get("xyz", "1 0 0")
    parts = [_number(part) for part in text.split()]
    if len(parts) != 3 or not all(map(math.isfinite, parts)) or not any(parts):  # noqa: PLR2004 - x, y, z
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
    if not lower <= upper:
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


def _number(text: str) -> float:
    """Return the number, NaN for what is none."""
    try:
        return float(text)
    except ValueError:
        return math.nan
