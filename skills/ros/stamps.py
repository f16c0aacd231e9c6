"""ROS time to robot time."""

from __future__ import annotations

from typing import Final

WINDOW: Final = 10.0
"""Seconds: two clocks that NTP keeps move apart by less than a millisecond within it."""
JUMP: Final = 1.0
"""Seconds by which a message is off before its clock may have been set anew."""
SURE: Final = 5
"""Messages in a row that must be off before that is believed: one wrong stamp must not age all others."""


class Stamps:
    """Translates the stamps of one topic.

    The message that came fastest within the last seconds says how far the sender's clock and the robot's are
    apart; what came slower is older by what it took longer. How long the fastest took is not seen.
    """

    def __init__(self) -> None:
        self._apart: float | None = None
        self._before: float | None = None
        self._begun = 0.0
        self._off = 0

    def robot_seconds(self, sent: float, now: float) -> float:
        """Return when a message was sent, in robot seconds, never after ``now``.

        Args:
            sent: its stamp, in ROS seconds; 0 when it has none: then it is of now.
            now: robot seconds at which it came.
        """
        if sent == 0.0:
            return now
        gap = now - sent
        known = self._known()
        if known is None or (abs(gap - known) > JUMP and self._off + 1 >= SURE):
            self._apart = self._before = gap
            self._begun, self._off = now, 0
            return now
        if abs(gap - known) > JUMP:
            self._off += 1
            return now if gap < known else min(now, sent + known)
        self._off = 0
        self._learn(gap, now)
        apart = self._known()
        assert apart is not None, "it has just been learned"
        return min(now, sent + apart)

    def _known(self) -> float | None:
        if self._apart is None or self._before is None:
            return self._apart
        return min(self._apart, self._before)

    def _learn(self, gap: float, now: float) -> None:
        assert self._apart is not None, "it has been asked for"
        if now - self._begun > WINDOW:
            self._before, self._apart, self._begun = self._apart, gap, now
        else:
            self._apart = min(self._apart, gap)


def periods_in(seconds: float, period: float) -> int:
    """Return how many whole periods have passed, not misled by how floats round."""
    return int(seconds / period + 1e-6)
