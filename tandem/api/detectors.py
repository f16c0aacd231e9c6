"""Detectors: functions that recognise the site's items in a picture."""

from __future__ import annotations

from tandem.skills.perception.detectors import Detection, Detector
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import SiteItem

__all__ = ["Detection", "Detector", "Pose", "RgbdImage", "SiteItem", "Vector3"]
