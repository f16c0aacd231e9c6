"""Pictures of a ROS camera, with depth where there is some, to one RGB-D picture."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, cast

import numpy as np
from numpy.typing import NDArray

from tandem.skills.ports import keys
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.image import RgbdImage, encode
from tandem.skills.ros.poses import stamped
from tandem.skills.ros.readings import UnfitError, seconds_of
from tandem.skills.ros.stamps import Stamps

if TYPE_CHECKING:
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.message import RobotTime
    from tandem.skills.ports.sensors import CameraSensor
    from tandem.skills.ros.messages import RosCameraInfo, RosImage
    from tandem.skills.ros.node import RosSubscription

TOGETHER: Final = 0.05
"""ROS seconds by which colour and depth of one picture may differ."""
MILLIMETRES: Final = 1000.0
"""In a metre."""
FARTHEST: Final = 65535.0
"""Millimetres that a depth can hold."""

Colour = NDArray[np.uint8]
Depth = NDArray[np.uint16]


def _same(pixels: Colour) -> Colour:
    return pixels


def _swapped(pixels: Colour) -> Colour:
    return pixels[:, :, ::-1]


def _grey(pixels: Colour) -> Colour:
    return np.repeat(pixels, 3, axis=2)


_COLOURS: Final[Mapping[str, tuple[int, Callable[[Colour], Colour]]]] = MappingProxyType(
    {
        "rgb8": (3, _same),
        "bgr8": (3, _swapped),
        "rgba8": (4, lambda pixels: pixels[:, :, :3]),
        "bgra8": (4, lambda pixels: pixels[:, :, 2::-1]),
        "mono8": (1, _grey),
    }
)
"""Bytes of a pixel, and how they become red, green, blue."""
_DEPTHS: Final[Mapping[str, tuple[str, float]]] = MappingProxyType(
    {"16UC1": ("u2", 1.0), "mono16": ("u2", 1.0), "32FC1": ("f4", MILLIMETRES)}
)
"""Type of a pixel, and its millimetres (REP-118)."""


def colour_of(image: RosImage) -> Colour:
    """Return red, green, blue of each pixel.

    Raises:
        UnfitError: an encoding that is not known, or other bytes than it says.
    """
    if image.encoding not in _COLOURS:
        raise UnfitError(f"expected one of {', '.join(_COLOURS)}; found the encoding {image.encoding!r}")
    deep, change = _COLOURS[image.encoding]
    rows = _rows(image, deep)
    return np.ascontiguousarray(change(rows.reshape(image.height, image.width, deep)))


def depth_of(image: RosImage) -> Depth:
    """Return millimetres along the optical axis; 0 where nothing was measured.

    Raises:
        UnfitError: an encoding that is not known, or other bytes than it says.
    """
    if image.encoding not in _DEPTHS:
        raise UnfitError(f"expected one of {', '.join(_DEPTHS)}; found the encoding {image.encoding!r}")
    kind, scale = _DEPTHS[image.encoding]
    order = ">" if image.is_bigendian else "<"
    dtype = np.dtype(f"{order}{kind}")
    told = np.ascontiguousarray(_rows(image, dtype.itemsize)).view(dtype).astype(np.float64) * scale
    told[~np.isfinite(told) | (told < 0.0) | (told > FARTHEST)] = 0.0
    return told.round().astype(np.uint16)


def _rows(image: RosImage, deep: int) -> Colour:
    """Return the bytes of each row, without what fills it up."""
    data, wide = np.asarray(image.data, np.uint8), image.width * deep
    if image.step < wide or data.size != image.step * image.height:
        raise UnfitError(
            f"expected {image.height} rows of at least {wide} bytes ({image.encoding}); "
            f"found {data.size} bytes, {image.step} a row"
        )
    return data.reshape(image.height, image.step)[:, :wide]


@dataclass(eq=False)
class CameraInput:
    """A camera: publishes while somebody listens.

    Args:
        bus: where pictures go.
        camera: of the description.
        colour: sensor_msgs/Image.
        info: its intrinsics; None: those of the described field of view.
        depth: aligned with the colour; None: nothing is measured.
    """

    bus: Bus
    camera: CameraSensor
    colour: RosSubscription
    info: RosSubscription | None
    depth: RosSubscription | None
    stamps: Stamps = field(default_factory=Stamps)
    _info: RosCameraInfo | None = None
    _waiting: RosImage | None = None
    _depth: RosImage | None = None

    def step(self, now: RobotTime) -> None:
        """Publish the newest picture when its parts are there."""
        infos = [] if self.info is None else self.info.take()
        depths = [] if self.depth is None else self.depth.take()
        colours = self.colour.take()
        self._info = cast("RosCameraInfo", infos[-1]) if infos else self._info
        self._depth = cast("RosImage", depths[-1]) if depths else self._depth
        self._waiting = cast("RosImage", colours[-1]) if colours else self._waiting
        ready = self._waiting is not None and (self.info is None or self._info is not None)
        if ready and self._is_complete() and self.bus.listened(keys.rgbd(self.camera.name)):
            self._publish(now)

    def _is_complete(self) -> bool:
        if self.depth is None:
            return True
        if self._waiting is None or self._depth is None:
            return False
        return abs(seconds_of(self._waiting.header) - seconds_of(self._depth.header)) <= TOGETHER

    def _publish(self, now: RobotTime) -> None:
        image, self._waiting = self._waiting, None
        assert image is not None, "there is one"
        told = self.colour.tried(lambda: self._picture(image, now))
        if told is not None:
            self.bus.publish(keys.rgbd(self.camera.name), encode(told))

    def _picture(self, image: RosImage, now: RobotTime) -> RgbdImage:
        camera = self.camera
        for each in (image,) if self._depth is None else (image, self._depth):
            if (each.width, each.height) != (camera.width, camera.height):
                raise UnfitError(
                    f"expected {camera.width} x {camera.height} pixels of camera {camera.name!r}; "
                    f"found {each.width} x {each.height}"
                )
        depth = np.zeros((camera.height, camera.width), np.uint16)
        if self._depth is not None:
            depth = depth_of(self._depth)
        fx, fy, cx, cy = self._lens()
        header = RgbdHeader(
            stamp=stamped(self.stamps, image.header, now),
            camera=camera.name,
            width=camera.width,
            height=camera.height,
            fx=fx,
            fy=fy,
            cx=cx,
            cy=cy,
        )
        return RgbdImage(header, colour_of(image), depth)

    def _lens(self) -> tuple[float, float, float, float]:
        """Return the intrinsics of the rectified picture (P), or of the raw one where P is not filled in."""
        if self._info is None:
            focal = self.camera.width / (2.0 * float(np.tan(self.camera.horizontal_fov / 2.0)))
            return focal, focal, (self.camera.width - 1) / 2.0, (self.camera.height - 1) / 2.0
        p, k = self._info.p, self._info.k
        if float(p[0]) > 0.0:
            return float(p[0]), float(p[5]), float(p[2]), float(p[6])
        if float(k[0]) <= 0.0:
            raise UnfitError("expected intrinsics in camera_info; found a focal length of 0")
        return float(k[0]), float(k[4]), float(k[2]), float(k[5])
