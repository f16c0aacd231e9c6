"""When what two hands put down stands: its weight stays off the wrists."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

LEFT: Final = 0.4
"""Share of the load that is left on the wrists when the thing stands."""
STANDS_FOR: Final = 0.1
"""Robot seconds for which it must be off them: a thing that leans touches with one edge first, and rebounds.

Until then it is lowered on: a carton that was let go on one edge fell, and slid by 4 mm.
"""


@dataclass(eq=False)
class Landing:
    """One putting down.

    Args:
        load: newtons on the wrists while the thing is in the air.
    """

    load: float
    since: float | None = None

    def stands(self, load: float, now: float) -> bool:
        """Take in the newtons on the wrists at a moment (robot s); say whether the thing stands."""
        if load >= LEFT * self.load:
            self.since = None
            return False
        self.since = now if self.since is None else self.since
        return now - self.since >= STANDS_FOR
