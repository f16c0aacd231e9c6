"""Detectors: what recognises the site's items in a picture. Tags are one; others are ``tandem.detectors``.

An entry point names a function of a module. It is called in a worker process, once for each picture.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.plugins import UNTRIED, Group, Loaded, load
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import SiteItem


@dataclass(frozen=True)
class Detection:
    """One face of one item in one picture."""

    item: int
    tag_in_camera: Pose
    """The face as its tag would tell it, in the camera's frame (m): origin in its centre, z out of the face,
    y up as the item stands (docs/conventions.md)."""
    distance: float
    """Metres from the camera."""
    quality: float
    """0 to 1, for choosing among several of one item: falls with distance, viewing angle and doubts."""
    position_sigma: float
    """Metres: standard deviation of the position."""


Detector = Callable[[RgbdImage, tuple[SiteItem, ...], Vector3], tuple[Detection, ...]]
"""Takes a picture with its depth, the site's items, and the map's up in the camera's frame (unit length)."""
TAGS: Final = "tags"
"""The name of the detector that ships."""


def detectors(left_out: Mapping[str, str] | None = UNTRIED) -> Mapping[str, Detector]:
    """Return the detectors by name, the one that ships first.

    Args:
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.
    """
    from tandem.skills.perception.tags import of_items  # noqa: PLC0415 - loads OpenCV

    others = {} if left_out is None else plugged(left_out).found
    return MappingProxyType({TAGS: of_items, **others})


def plugged(left_out: Mapping[str, str] = UNTRIED) -> Loaded[Detector]:
    """Return the detectors of other packages."""
    return load(Group.DETECTORS, _checked, taken=(TAGS,), left_out=left_out)


def _checked(_: str, value: object) -> Detector:
    name = getattr(value, "__qualname__", "")
    if not callable(value) or not name or "<" in name or "." in name:
        raise TypeError(f"expected a function of a module, which a worker can import; found {value!r}")
    detector: Detector = value
    return detector
