"""Who goes on: each process's loop beats (``beats``) ten times a second, with the names that it announces.

zenoh notices a process that hangs, or a cable that is cut, after ten seconds. A hand would be far by then.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Final

BEAT_PERIOD: Final = 0.1
"""Host seconds between two beats."""
EARLY: Final = 0.03
"""Host seconds by which a beat may go before it is due: a loop that turns with the clock of a robot that
rests, ten times a second, would else beat every other turn."""
SILENT_AFTER: Final = 0.3
"""Host seconds without a beat after which a process is said not to go on: two beats may be lost or late."""
STALLED: Final = 0.18
"""Host seconds between two turns of one's own loop from which on it is oneself who has not listened. More
than a loop that nothing wakes waits (``loop.IDLE_WAIT``), less than what lies between a beat and silence."""


class Pulse:
    """The beats of others, and when one's own is due.

    Args:
        monotonic: the host's monotonic clock, in seconds.
        silent_after: see ``SILENT_AFTER``.
    """

    def __init__(self, monotonic: Callable[[], float], silent_after: float = SILENT_AFTER) -> None:
        self._monotonic, self._silent_after = monotonic, silent_after
        self._heard: dict[str, float] = {}
        self._beat_due = self._turned_at = float("-inf")
        self._listening_since = float("-inf")

    def listen(self) -> None:
        """Note that beats are heard from now on; who has not been heard yet is no sooner missed for that."""
        self._listening_since = self._monotonic()

    def turn(self) -> bool:
        """Note a turn of one's own loop; return whether a beat is due."""
        now = self._monotonic()
        if now - self._turned_at > STALLED:
            # Whatever was told meanwhile waits to be heard; nobody is silent for that.
            self._listening_since = now
        self._turned_at = now
        if now < self._beat_due - EARLY:
            return False
        self._beat_due = max(self._beat_due, now - EARLY) + BEAT_PERIOD
        return True

    def hear(self, names: Iterable[str]) -> None:
        """Note a beat of a process with these names."""
        now = self._monotonic()
        for name in names:
            self._heard[name] = now

    def forget(self, name: str) -> None:
        """Forget a name that is no longer announced: who takes it next begins anew."""
        self._heard.pop(name, None)

    def awake(self, announced: Iterable[str]) -> frozenset[str]:
        """Return those of the names whose process goes on; one that has never beaten is believed to."""
        since = self._monotonic() - self._silent_after
        if self._listening_since > since:
            return frozenset(announced)
        return frozenset(name for name in announced if self._heard.get(name, since) >= since)
