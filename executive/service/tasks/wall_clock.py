"""UTC that is judged against the ledger: a wall clock that jumps ends no task's time and prunes nothing.

The host's monotonic clock continues what the ledger last knew. While the wall clock is near that, it is
followed; when it jumps, the true time is somewhere between the two, and nothing is decided that depends on
which. A jump is believed once the clock has run steadily after it.
"""

from __future__ import annotations

import logging
from pathlib import Path
from typing import Final

from tandem.executive.ledger.port import Reading
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.utc import iso

NEAR: Final = 60.0
"""Seconds between the wall clock and the ledger's time within which it is followed: NTP slews by less, and a
crystal drifts by less than 10 s a day."""
SETTLES: Final = 600.0
"""Host seconds for which the wall clock must run steadily after a jump before it is believed: NTP that sets a
robot's clock after its boot does so once, well within that."""
FAR: Final = 30 * 86_400.0
"""Seconds between two starts of the host that are plausible as time switched off; a holiday is."""
DOUBT: Final = 7 * 86_400.0
"""Host seconds at work for which old tasks are not deleted after a jump of more than ``FAR``."""
_BOOT_ID: Final = Path("/proc/sys/kernel/random/boot_id")
"""Where Linux keeps a name that is new with each start."""

_LOG = logging.getLogger(__name__)


def host_start() -> str:
    """Return a name of this start of the host, within which monotonic times compare; empty if it has none."""
    try:
        return _BOOT_ID.read_text("ascii").strip()
    except OSError:
        return ""


class WallClock:
    """UTC seconds, and between which bounds the truth is.

    Args:
        clocks: wall clock and monotonic clock of the host.
        last: what the ledger last knew, if it is not new.
        host: names this start of the host (``host_start``); empty: not known.
    """

    def __init__(self, clocks: Clocks, last: Reading | None, host: str = "") -> None:
        self._clocks, self._host = clocks, host
        now = self._seen_at = clocks.monotonic()
        self._ahead = clocks.utc() - now  # of the monotonic clock
        self._doubt = 0.0
        self._jumped: float | None = None  # how far the wall clock is ahead of the monotonic one since a jump
        self._jumped_at = now
        if last is not None:
            self._go_on_from(last, now)

    def look(self) -> None:
        """Follow the wall clock, or note that it has jumped; call it in each step."""
        now = self._clocks.monotonic()
        ahead = self._clocks.utc() - now
        self._doubt = max(0.0, self._doubt - (now - self._seen_at))
        self._seen_at = now
        if abs(ahead - self._ahead) <= NEAR:
            self._ahead = ahead
            if self._jumped is not None:
                self._jumped = None
                _LOG.warning("the clock is back to normal: %s", iso(self.utc()))
        elif self._jumped is None or abs(ahead - self._jumped) > NEAR:
            self._jumped, self._jumped_at = ahead, now
            _LOG.warning("%s", self.trouble())
        elif now - self._jumped_at >= SETTLES:
            _LOG.warning(
                "the clock has run steadily for %.0f s and is trusted again: %s", SETTLES, iso(now + ahead)
            )
            self._doubt = DOUBT if abs(ahead - self._ahead) > FAR else self._doubt
            self._ahead, self._jumped = ahead, None

    def utc(self) -> float:
        """Return the best guess: the wall clock, or while it has jumped what the ledger's time has become."""
        return self._clocks.monotonic() + self._ahead

    @property
    def earliest(self) -> float:
        """UTC seconds before which it surely isn't."""
        return self._clocks.monotonic() + min(self._ahead, self._other())

    @property
    def latest(self) -> float:
        """UTC seconds after which it surely isn't."""
        return self._clocks.monotonic() + max(self._ahead, self._other())

    @property
    def tells_age(self) -> bool:
        """Whether old tasks may be forgotten by it."""
        return self._jumped is None and self._doubt == 0.0

    def trouble(self) -> str:
        """Return in words what is wrong with the clock, or nothing."""
        if self._jumped is not None:
            wall = self._clocks.monotonic() + self._jumped
            return (
                f"the host's clock says {iso(wall)}, the ledger says {iso(self.utc())}: tasks "
                f"with `expires` or `not_before` between the two wait until the clock is right or has run "
                f"steadily for {SETTLES:.0f} s; old tasks are not deleted"
            )
        if self._doubt > 0.0:
            return (
                "the host's clock is far from the ledger's last entry: old tasks are not deleted "
                f"for another {self._doubt / 3600.0:.0f} h of operation"
            )
        return ""

    def reading(self) -> Reading:
        """Return what the next start goes on from."""
        now = self._clocks.monotonic()
        return Reading(utc=now + self._ahead, host=self._host, monotonic=now, doubt=self._doubt)

    def _other(self) -> float:
        return self._ahead if self._jumped is None else self._jumped

    def _go_on_from(self, last: Reading, now: float) -> None:
        wall, self._doubt = self._clocks.utc(), last.doubt
        if last.host and last.host == self._host and now >= last.monotonic:
            known = last.utc + now - last.monotonic
            plausible = abs(wall - known) <= NEAR
        else:
            known = last.utc
            plausible = -NEAR <= wall - known <= FAR
        if plausible:
            return
        self._ahead, self._jumped = known - now, wall - now
        if abs(wall - known) > FAR:
            self._doubt = DOUBT
        _LOG.warning("%s", self.trouble())
