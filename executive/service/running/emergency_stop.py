"""The executive's hand on the hardware's stop: asked for again until the hardware says that it is set."""

from __future__ import annotations

from typing import Final

from pydantic import ValidationError

from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.hardware import Stop
from tandem.skills.ports.keys import STOP

AGAIN_AFTER: Final = 0.1
"""Host seconds between two tries."""
GIVE_UP_AFTER: Final = 3.0
"""Host seconds without a confirmation."""


class EmergencyStop:
    """Sets ``hw/stop``. An operator releases it.

    Args:
        bus: where the hardware is.
        clocks: host time, for asking again.
    """

    def __init__(self, bus: Bus, clocks: Clocks) -> None:
        self.confirmed = False
        self._bus, self._clocks = bus, clocks
        self._reason = ""
        self._pending: Pending | None = None
        self._first = self._last = 0.0

    def set(self, reason: str) -> None:
        """Ask for the stop; call ``step`` until it returns True."""
        self.confirmed = False
        self._reason = reason
        self._first = self._clocks.monotonic()
        self._ask()

    def step(self) -> bool:
        """Return whether the stop is confirmed, or was asked for in vain for long enough."""
        answer = None if self._pending is None else self._pending.poll()
        if answer is not None:
            try:
                self.confirmed = STOP.decode_answer(answer).stopped
            except ValidationError:
                self.confirmed = False
        now = self._clocks.monotonic()
        if self.confirmed or now - self._first > GIVE_UP_AFTER:
            return True
        if (self._pending is None or self._pending.done()) and now - self._last > AGAIN_AFTER:
            self._ask()
        return False

    def _ask(self) -> None:
        self._last = self._clocks.monotonic()
        self._pending = STOP.query(self._bus, Stop(by="executive", reason=self._reason), timeout=1.0)
