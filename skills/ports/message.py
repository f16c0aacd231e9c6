"""What every message is: frozen, strict about its fields, free of NaN and infinity."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from typing import Annotated, Final, TypeVar

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

Vector3 = tuple[float, float, float]
"""x, y, z in metres (or N, rad/s, ... as the field says)."""

Quaternion = tuple[float, float, float, float]
"""x, y, z, w; of unit length."""

MAX_REQUEST_BYTES: Final = 64 * 1024
"""What a client's document may weigh at the most."""
MOST: Final = 2**53 - 1
"""The largest whole number that JSON carries everywhere (RFC 8259, section 6); SQLite and numpy hold it."""
Count = Annotated[int, Field(ge=0, le=MOST)]
"""A whole number of a message: every one has bounds, and these unless it says others."""
Whole = Annotated[int, Field(ge=-MOST, le=MOST)]
"""Likewise, of either sign."""
Positive = Annotated[float, Field(gt=0.0)]
PartName = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]{0,31}$")]
"""A part of the robot, as its description names it; it becomes a part of keys."""
HandName = PartName
"""A hand, such as ``left``."""
_ODD: Final = r"\x00-\x1f\x7f-\x9f\u00ad\u200b\u200e\u200f\u2028-\u202e\u2060-\u2064\u2066-\u2069\ufeff"
PLAIN_TEXT: Final = rf"^[^{_ODD}]*$"
"""Text without control characters, line breaks, and what is unseen or reorders the text around it: a pattern.

An id with an override such as U+202E, or with a space of no width, is shown as another one (Unicode Technical
Report 36, 2.6). The two joiners (U+200C, U+200D) may stand in it: words of Persian and Hindi need them.
"""
_ODD_CHARACTER: Final = re.compile(f"[{_ODD}]")


def plain(text: str) -> str:
    """Return a text with what is not plain in it escaped as JSON does: it goes to screens and logs."""
    return _ODD_CHARACTER.sub(lambda odd: f"\\u{ord(odd[0]):04x}", text)


PlainText = Annotated[str, AfterValidator(plain)]
"""What somebody else has written and people read, where refusing it would be worse than changing it."""


class Message(BaseModel):
    """Base of all that crosses the bus or stands in a file."""

    # Strings are not cached: pydantic would keep up to 16,384 of those below 64 bytes that it ever read, and
    # each task brings some forty ids of goals, which never come again. That is 1.7 MB in each process that
    # hears of goals, filled over the first thousand tasks (``python -m benchmarks.read_strings``), and it
    # makes no reading quicker.
    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, cache_strings="none")


def repeated(names: Iterable[str]) -> list[str]:
    """Return the names that are there more than once, sorted."""
    return sorted(name for name, times in Counter(names).items() if times > 1)


M = TypeVar("M", bound=Message)


def read_leniently(model: type[M], document: bytes) -> M:
    """Return what a process of another version told, without the fields that this version does not know.

    Messages to clients gain fields from release to release, and a client is seldom as new as the robot. What
    is asked of a robot is read strictly: there an unknown field is a mistake that somebody wants to hear of.

    Raises:
        ValidationError: pydantic's, when it is no such message.
    """
    return model.model_validate_json(document, extra="ignore")


class RobotTime(Message):
    """A time on the robot's clock.

    ``boot`` names the start of the hardware that counts the seconds. Two moments of different boots can't be
    compared: what asks for it gets None, and ``<`` and ``-`` don't exist. ``seconds`` alone is for telling
    people and for the wire; reckoning with it outside of this class is an error
    (``tests/architecture/test_robot_time.py``). Timers read ``skills.ports.clocks.robot_seconds`` instead.
    """

    boot: str
    seconds: float

    def since(self, earlier: RobotTime) -> float | None:
        """Return the seconds that this is after ``earlier`` (negative: before), or None: another boot."""
        return self.seconds - earlier.seconds if self.boot == earlier.boot else None

    def is_after(self, other: RobotTime) -> bool | None:
        """Say whether this is later than the other, or None: another boot."""
        return self.seconds > other.seconds if self.boot == other.boot else None

    def is_fresh(self, now: RobotTime, within: float) -> bool:
        """Say whether this lies at most so many seconds before ``now``; what is of another boot does not."""
        return self.boot == now.boot and now.seconds - self.seconds <= within

    def plus(self, seconds: float) -> RobotTime:
        """Return the moment so many seconds later, of the same boot."""
        return RobotTime(boot=self.boot, seconds=self.seconds + seconds)


class RobotTimer:
    """Counts robot seconds on over boots, out of stamps: a timer's reading, which never falls.

    What passes between the last stamp of one boot and the first of the next is not counted. Readings are for
    taking differences of, and say nothing about stamps.

    Args:
        start: the reading at the first stamp; that stamp's own seconds unless given.
    """

    def __init__(self, start: float | None = None) -> None:
        self._reading = start
        self._origin: RobotTime | None = None
        self._at_origin = 0.0

    @property
    def reading(self) -> float:
        """The last reading; 0.0 before the first stamp, unless it starts elsewhere."""
        return self._reading or 0.0

    def read(self, stamp: RobotTime) -> float:
        """Return the reading at a stamp; one from before the last, of the same boot, changes nothing."""
        passed = None if self._origin is None else stamp.since(self._origin)
        if passed is None:
            self._at_origin = stamp.seconds if self._reading is None else self._reading
            self._origin, passed = stamp, 0.0
        self._reading = max(self.reading, self._at_origin + passed)
        return self._reading
