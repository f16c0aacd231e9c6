"""Camera pictures for a recording: smaller, as JPEG, a few a second. Listening makes the camera work."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import cv2
import numpy as np

from tandem.executive.records.ears import PICTURES
from tandem.executive.records.foxglove_view import put_picture
from tandem.executive.records.mcap_writing import McapFile
from tandem.executive.records.recording import Recorded
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.image import decode, header_of

EVERY: Final = 0.2
"""Host seconds between two pictures of a camera."""
WIDTH: Final = 640
"""Pixels; a picture of 1280 x 720 costs 2.4 ms to encode, half as wide 0.7."""
QUALITY: Final = 80
"""Of JPEG's 100, for people who look at a run. Higher makes files larger; lower blurs edges, such as those of
tags."""


class Pictures:
    """Takes pictures in, at most five a second.

    Args:
        bus: where cameras publish.
        monotonic: the host's monotonic clock in seconds.
        write: has something written into the file of the recording.
    """

    def __init__(
        self, bus: Bus, monotonic: Callable[[], float], write: Callable[[Callable[[McapFile], None]], None]
    ) -> None:
        self._inbox = bus.subscribe(PICTURES, depth=1)
        self._ear, self._monotonic, self._write = bus.ear, monotonic, write
        self._last = float("-inf")

    def step(self, when: Recorded | None) -> None:
        """Write the newest picture of each camera, if it is time; ``when``: a message of now."""
        now = self._monotonic()
        if when is None or now - self._last < EVERY - 1e-6:
            return
        self._last = now
        for sample in self._inbox.drain():
            header = self._ear.read(sample.key, header_of, sample.payload)
            jpeg = b"" if header is None else as_jpeg(sample.payload)
            if jpeg:
                self._put(sample.key, jpeg, when)

    def close(self) -> None:
        """Stop listening."""
        self._inbox.close()

    def _put(self, key: str, jpeg: bytes, when: Recorded) -> None:
        camera = key.split("/")[2]
        self._write(lambda file: put_picture(file, key, camera, jpeg, when))


def as_jpeg(payload: bytes) -> bytes:
    """Return a picture as JPEG, at most ``WIDTH`` pixels wide; empty for what is no picture."""
    try:
        image = decode(payload)
    except ValueError:
        return b""
    height, width = image.colour.shape[:2]
    colour = image.colour
    if width > WIDTH:
        size = (WIDTH, round(height * WIDTH / width))
        colour = np.asarray(cv2.resize(colour, size, interpolation=cv2.INTER_AREA), np.uint8)
    good, coded = cv2.imencode(".jpg", colour[:, :, ::-1], [cv2.IMWRITE_JPEG_QUALITY, QUALITY])
    return bytes(coded.tobytes()) if good else b""
