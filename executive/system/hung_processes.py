"""Which processes hang for so long that they had better be killed and started again."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Final

HUNG_AFTER: Final = 10.0
"""Host seconds without a beat after which a process is killed: far beyond what a loop computes in a turn."""
SELDOM_SILENT: Final = 1.3
"""Host seconds without a beat after which a process is silent to a supervisor, which hears beats twice a
second: two of them may be lost or late. It counts towards ``HUNG_AFTER``."""
STALLED: Final = 0.5
"""Host seconds between two looks from which on it is the looker who stood: nobody is blamed for that time."""


@dataclass(eq=False)
class Hung:
    """Adds up silences; call ``look`` often.

    Args:
        monotonic: the host's monotonic clock, in seconds.
        after: host seconds for which a process must be silent.
    """

    monotonic: Callable[[], float]
    after: float = HUNG_AFTER - SELDOM_SILENT
    _silent_for: dict[str, float] = field(default_factory=dict)
    _looked_at: float = float("-inf")

    def look(self, announced: Iterable[str], awake: Iterable[str]) -> tuple[str, ...]:
        """Return who has been announced and silent for too long; each is told once, and begins anew."""
        now = self.monotonic()
        passed, self._looked_at = now - self._looked_at, now
        if passed > STALLED:
            passed = 0.0
        silent = set(announced) - set(awake)
        self._silent_for = {name: self._silent_for.get(name, 0.0) + passed for name in sorted(silent)}
        found = tuple(name for name, seconds in self._silent_for.items() if seconds > self.after)
        for name in found:
            del self._silent_for[name]
        return found
