"""The camera's pictures: it renders only while somebody listens, so listen only while one is wanted.

A camera that begins when it is listened to takes its first picture at once, and the next a period later:
whoever listens too soon waits a whole period for one that counts.
"""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

from tandem.skills.perception.session import LookError, Session
from tandem.skills.ports.actions.perception import LookFeedback
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.image import header_of
from tandem.skills.ports.keys import rgbd
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.skill import Command, Slice

SILENT_AFTER: Final = 3.0
"""Robot seconds without a fresh picture."""


class Camera:
    """The subscription to a camera of one run."""

    def __init__(self, bus: Bus, name: str) -> None:
        """Don't listen yet; ``name`` is the camera's."""
        self._bus, self._key = bus, rgbd(name)
        self._inbox: Heard[RgbdHeader] | None = None
        self._fresh: list[tuple[RgbdHeader, bytes]] = []

    def close(self) -> None:
        """Stop listening."""
        if self._inbox is not None:
            self._inbox.close()
            self._inbox = None

    def picture(
        self, session: Session, after: RobotTime
    ) -> Generator[LookFeedback | Slice, Command, tuple[RgbdHeader, bytes]]:
        """Return the next picture not taken before ``after``, as header and payload.

        While the run is paused, nobody listens, nor before ``after``.

        Raises:
            LookError: CAMERA_SILENT when none comes.
        """
        self._fresh.clear()
        session.on_pause = self.close
        if self._inbox is None:
            yield from session.until(lambda: after.is_after(session.stamp) is not True, SILENT_AFTER)
        if not (yield from session.until(lambda: self._arrived(after), SILENT_AFTER)):
            raise LookError(
                FailureKind.CAMERA_SILENT, f"no picture within {SILENT_AFTER} s", waited_s=SILENT_AFTER
            )
        return self._fresh[0]

    def _arrived(self, after: RobotTime) -> bool:
        for _, header, payload in self._listen().take():
            if after.is_after(header.stamp) is False:  # one of another boot is not of this run
                self._fresh.append((header, payload))
        return bool(self._fresh)

    def _listen(self) -> Heard[RgbdHeader]:
        if self._inbox is None:
            self._inbox = Heard(self._bus, self._key, header_of, depth=2)
        return self._inbox
