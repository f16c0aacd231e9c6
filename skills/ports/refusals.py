"""What a process has refused of what it heard, told so that somebody counts it: key ``refused``."""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.hearing import KINDS, Ear, Reason
from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import MOST, Message

Count = Annotated[int, Field(ge=1, le=MOST)]


class Refused(Message):
    """Messages of one key that were refused for one reason, since the process started."""

    key: str
    reason: Reason
    count: Count


class Refusals(Message):
    """All that a process has refused; said when it has become more, at most once a second, and every 10 s."""

    process: str
    refused: Annotated[tuple[Refused, ...], Field(max_length=KINDS + len(Reason))]


REFUSALS: Final = Topic("refused", Refusals)
CHANGED_EVERY: Final = 1.0
"""Host seconds between two messages while more is refused: a flood of wrong ones makes no flood of these."""
REPEATED_EVERY: Final = 10.0
"""Host seconds between two messages that say the same, for whoever has come since."""


class RefusalTeller:
    """Says when it is time to tell, and what.

    Args:
        ear: counts.
    """

    def __init__(self, ear: Ear) -> None:
        self._ear = ear
        self._told, self._told_at = 0, float("-inf")

    def due(self, process: str, now: float) -> Refusals | None:
        """Return what is to be told, or None; ``now`` is the host's monotonic clock, in seconds."""
        total = self._ear.total
        every = REPEATED_EVERY if total == self._told else CHANGED_EVERY
        if total == 0 or now - self._told_at < every:
            return None
        self._told, self._told_at = total, now
        refused = tuple(
            Refused(key=key, reason=reason, count=count)
            for (key, reason), count in sorted(self._ear.refused.items())
        )
        return Refusals(process=process, refused=refused)
