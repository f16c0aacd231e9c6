"""How long something has lasted by the robot's clock, also when that clock stands still or starts anew."""

from __future__ import annotations

from tandem.skills.ports.clocks import Clocks


class Elapsed:
    """Counts from when it was made; call ``update`` in each step.

    A clock that starts anew (another boot id) counts on from the first time that it tells. ``standing`` tells
    for how long it has not moved, by the host's clock: nobody waits for ever for hardware that is gone.

    Args:
        clocks: robot time, and host time for when the robot's stands still.
    """

    def __init__(self, clocks: Clocks) -> None:
        self.robot = 0.0
        """Robot seconds."""
        self.standing = 0.0
        """Host seconds for which the robot's clock has not moved."""
        self._clocks = clocks
        self._last = clocks.robot()
        self._moved_at = clocks.monotonic()

    def update(self, *, counts: bool = True) -> None:
        """Take the time; what has passed since the last call is left out when it does not count."""
        now, host, last = self._clocks.robot(), self._clocks.monotonic(), self._last
        if now is not None and now != last:
            passed = None if last is None else now.since(last)
            self._last, self._moved_at = now, host
            if counts and passed is not None:
                self.robot += max(0.0, passed)
        self.standing = host - self._moved_at

    def beyond(self, robot: float, standing: float) -> bool:
        """Say whether more than ``robot`` robot seconds have passed, or the clock stood for ``standing``."""
        return self.robot > robot or self.standing > standing
