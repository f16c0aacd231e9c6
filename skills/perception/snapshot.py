"""A camera's next picture as JPEG, for whoever asks: what did it look like when it went wrong?"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import cv2

from tandem.skills.ports.actions.perception import PICTURE, AskView
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.compute import Compute, Job
from tandem.skills.ports.endpoint import Call, endpoint
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.image import decode, header_of
from tandem.skills.ports.keys import Nothing, Service, rgbd
from tandem.skills.ports.serving import Endpoints

NEXT_PICTURE: Final = Service(PICTURE, AskView, Nothing, reads=True, exact=True)
"""Answered with a JPEG; with nothing when no picture came."""
PICTURE_AFTER: Final = 1.0
"""Robot seconds within which a picture must come."""
WORK_AFTER: Final = 1.0
"""Robot seconds after that within which it must be JPEG."""
WIDEST: Final = 640
"""Pixels across, at the most."""
QUALITY: Final = 80
"""JPEG's, of 100: people look at it, and nothing is measured in it."""


class Snapshots:
    """Answers ``skill/perception/picture``; a ``Node``. It listens to a camera only while somebody asks.

    Args:
        bus: where the cameras and the askers are.
        clocks: robot time.
        compute: who writes the JPEG.
        cameras: their names; the first is meant where none is named.
    """

    name: Final = "perception/picture"

    def __init__(self, bus: Bus, clocks: Clocks, compute: Compute, cameras: Sequence[str]) -> None:
        self._eyes = {name: _Eye(bus, clocks, compute, rgbd(name)) for name in cameras}
        self._first = cameras[0]
        self._endpoints = Endpoints(bus, clocks.monotonic, (endpoint(NEXT_PICTURE, self._on_question),))

    def step(self) -> bool:
        """Take questions, then pictures, then answer."""
        more = self._endpoints.step()
        for eye in self._eyes.values():
            eye.step()
        return more

    def close(self) -> None:
        """Tell whoever still waits that there is none."""
        for eye in self._eyes.values():
            eye.answer(b"")
        self._endpoints.close()

    def _on_question(self, call: Call[AskView]) -> bytes | None:
        eye = self._eyes.get(call.document.camera or self._first)
        if eye is None:
            return b""
        eye.asked.append(call)
        return None


class _Eye:
    """One camera, and who waits for its next picture."""

    def __init__(self, bus: Bus, clocks: Clocks, compute: Compute, key: str) -> None:
        self._bus, self._clocks, self._compute, self._key = bus, clocks, compute, key
        self.asked: list[Call[AskView]] = []
        self._waiting: list[Call[AskView]] = []
        self._inbox: Heard[RgbdHeader] | None = None
        self._job: Job[bytes] | None = None
        self._until = 0.0

    def step(self) -> None:
        asked, self.asked = self.asked, []
        if not asked and not self._waiting:
            return
        now = robot_seconds(self._clocks)
        if not self._waiting:
            self._until = now + PICTURE_AFTER
            self._inbox = Heard(self._bus, self._key, header_of, depth=1)
        self._waiting += asked
        if self._inbox is not None and (pictures := self._inbox.take()):
            self._hush()
            self._job = self._compute.submit(to_jpeg, pictures[-1][2], cost=0.0)
            self._until = now + WORK_AFTER
        if self._job is not None and self._job.done():
            self.answer(self._job.result())
        elif now > self._until:
            self.answer(b"")

    def answer(self, jpeg: bytes) -> None:
        self._hush()
        waiting, self._waiting, self._job = self._waiting, [], None
        for call in waiting:
            call.reply(jpeg)

    def _hush(self) -> None:
        if self._inbox is not None:
            self._inbox.close()
            self._inbox = None


def to_jpeg(payload: bytes) -> bytes:
    """Return the colours of an RGB-D payload that has been checked as JPEG."""
    colour = decode(payload).colour
    height, width = colour.shape[:2]
    if width > WIDEST:
        size = (WIDEST, max(1, round(height * WIDEST / width)))
        colour = cv2.resize(colour, size, interpolation=cv2.INTER_AREA)
    good, written = cv2.imencode(
        ".jpg", cv2.cvtColor(colour, cv2.COLOR_RGB2BGR), (cv2.IMWRITE_JPEG_QUALITY, QUALITY)
    )
    return written.tobytes() if good else b""
