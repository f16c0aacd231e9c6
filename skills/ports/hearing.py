"""What a process takes in from the bus: only messages that are what they say they are.

A message is checked where it enters, once for all who hear it: its document against the model, what it says
against the robot's description (``skills.ports.checks``), and its stamp against the last one. A wrong one is
dropped, counted, logged once a minute, and is silence to everybody else: whoever watches for silence acts.
"""

from __future__ import annotations

import logging
from collections import Counter
from enum import StrEnum
from typing import TYPE_CHECKING, Final, Generic, TypeVar

from pydantic import ValidationError

from tandem.skills.ports.checks import LARGEST, LONGEST, misfit, too_large
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.problems import in_words, problems_of

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from tandem.skills.ports.bus import Commons
    from tandem.skills.ports.robot_description import RobotDescription

M = TypeVar("M", bound=Message)
V = TypeVar("V")

ORDERED: Final = ("hw/", "world/")
"""How the keys begin whose stamps must not run backwards. The others are about many things; statuses of goals
have numbers of their own."""
MEASURED: Final = ("hw/", "world/", "skill/")
"""How the keys begin whose numbers are about the robot and its world. Tasks have times of day, too."""
OUTVOTED: Final = 3
"""Messages in a row that are older than the last one taken, and in order, after which it was that one whose
stamp was wrong: one message from the future must not end a stream."""
LOG_EVERY: Final = 60.0
"""Host seconds between two lines about messages of one key that are refused for one reason."""
KINDS: Final = 256
"""Keys and reasons that are counted one by one; those that somebody makes up beyond that count as one."""

log = logging.getLogger(__name__)


class Reason(StrEnum):
    """Why a message was refused."""

    MALFORMED = "malformed"
    """No such document, or one that contradicts itself: other lengths, numbers that are none or too large."""
    MISFIT = "misfit"
    """It does not fit the robot's description or its key: other joints, another arm's, another camera's."""
    OLDER = "older"
    """Its stamp lies before that of the last one, of the same boot."""
    FENCED = "fenced"
    """Its sender holds no lease, or has been replaced (``tandem.skills.ports.lease``)."""
    STRAY = "stray"
    """It came under no key of its own: put on a wildcard, or a deletion."""


class Ear:
    """What one process knows for checking what it hears, and what it has refused. Each bus has one.

    Args:
        monotonic: the host's monotonic clock, in seconds, for the log; None: each kind is logged once.
    """

    def __init__(self, monotonic: Callable[[], float] | None = None) -> None:
        self._monotonic = monotonic
        self._counts: Counter[tuple[str, Reason]] = Counter()
        self.total = 0
        """How many messages were refused since the start."""
        self._logged: dict[tuple[str, Reason], float] = {}
        self.description: RobotDescription | None = None
        self.last_read: dict[str, tuple[Callable[[bytes], Message], bytes, Message]] = {}
        """How the last message of a key was read, for the next one who hears it: several nodes of a process
        listen to the joints."""

    def know(self, description: RobotDescription) -> None:
        """Check against this robot from now on."""
        self.description = description
        self.last_read.clear()

    @property
    def refused(self) -> Mapping[tuple[str, Reason], int]:
        """How many messages were refused since the start, by key and reason."""
        return self._counts

    def keep(self, key: str, decode: Callable[[bytes], Message], payload: bytes, message: Message) -> None:
        """Note how a message that was checked was read."""
        self.last_read[key] = (decode, payload, message)
        if len(self.last_read) > KINDS:
            self.last_read.pop(next(iter(self.last_read)))

    def read(self, key: str, decode: Callable[[bytes], M], payload: bytes) -> M | None:
        """Return what a payload says, or None for one that is refused: whoever decodes does it here."""
        try:
            return self._checked(key, decode, payload)
        except Exception as error:  # noqa: BLE001 - whatever a stranger found: it costs its message, no process
            raised = f"the check raised {type(error).__name__}: {error}"
            self.refuse(key, Reason.MALFORMED, raised, error=error)
            return None

    def _checked(self, key: str, decode: Callable[[bytes], M], payload: bytes) -> M | None:
        try:
            message = decode(payload)
        except ValueError as error:
            self.refuse(key, Reason.MALFORMED, _first(error))
            return None
        if key.startswith(MEASURED) and too_large(message):
            text = f"a number is larger than {LARGEST:.0e}, or a time than {LONGEST:.0e} s"
            self.refuse(key, Reason.MALFORMED, text)
            return None
        wrong = misfit(message, key, self.description)
        if wrong:
            self.refuse(key, Reason.MISFIT, wrong)
            return None
        return message

    def count(self, key: str, reason: Reason, count: int = 1) -> tuple[str, Reason]:
        """Count messages that are not taken in, and return as what: for who logs the reason itself."""
        kind = (key, reason)
        if kind not in self._counts and len(self._counts) >= KINDS:
            kind = ("other", reason)
        self._counts[kind] += count
        self.total += count
        return kind

    def refuse(
        self, key: str, reason: Reason, text: str, count: int = 1, *, error: Exception | None = None
    ) -> None:
        """Count messages that are not taken in; ``text`` says what was wrong with them.

        ``error`` is one of ours: a check that raised. The log gets its trace.
        """
        kind = self.count(key, reason, count)
        now = 0.0 if self._monotonic is None else self._monotonic()
        last = self._logged.get(kind)
        if last is None or now - last >= LOG_EVERY:
            self._logged[kind] = now
            about = {"key": kind[0], "reason": str(reason), "why": text, "count": self._counts[kind]}
            log.warning("message refused", extra=about, exc_info=error)


class Entrance(Generic[M]):
    """The way in for the messages of one subscription.

    Args:
        ear: of the process.
        decode: reads a payload; ValueError when it is no message of these keys.
    """

    def __init__(self, ear: Ear, decode: Callable[[bytes], M]) -> None:
        self._ear, self._decode = ear, decode
        self._last: dict[str, RobotTime] = {}
        self._said: dict[str, bytes] = {}
        self._older: dict[str, list[RobotTime]] = {}

    def read(self, key: str, payload: bytes) -> M | None:
        """Return the message, or None for one that is refused for what it says, or that is said again.

        A state is said twice (``tandem.skills.ports.delivery``), for those who missed it the first time.
        """
        if self._said.get(key) == payload:
            return None
        before = self._ear.last_read.get(key)
        if before is not None and before[1] == payload and before[0] == self._decode:
            known: M = before[2]  # type: ignore[assignment] # what this decode made of it
            self._note_said(key, known, payload)
            return known
        message = self._ear.read(key, self._decode, payload)
        if message is not None:
            self._ear.keep(key, self._decode, payload, message)
            self._note_said(key, message, payload)
        return message

    def _note_said(self, key: str, message: M, payload: bytes) -> None:
        if key.startswith(ORDERED) and stamp_of(message) is not None:
            _keep(self._said, key, payload)

    def is_newer(self, key: str, message: M) -> bool:
        """Say whether the message is not older than the last one of its key; from then on it is the last."""
        stamp = stamp_of(message)
        if stamp is None:
            return True
        teller = teller_of(key, message)
        last = self._last.get(teller)
        if last is not None and last.is_after(stamp):
            row = self._older.setdefault(teller, [])  # of those in _last only
            if row and row[-1].is_after(stamp) is not False:
                row.clear()
            row.append(stamp)
            if len(row) < OUTVOTED:
                return False
        _keep(self._last, teller, stamp)
        self._older.pop(teller, None)
        return True

    def keeps_old(self, key: str, message: M) -> bool:
        """Say whether a message that is not newer is handed on all the same; else it is refused."""
        if not key.startswith(ORDERED):
            return True
        stamp = stamp_of(message)
        text = "" if stamp is None else f"the message of {stamp.seconds:.3f} s came after a later one"
        self._ear.refuse(key, Reason.OLDER, text)
        return False


class Heard(Generic[M]):
    """All messages of the keys of an expression, with their keys. ``Latest`` is for one topic.

    Args:
        bus: where they are told.
        expression: their keys.
        decode: reads a payload; ValueError when it is no message of these keys.
        depth: how many of each key are kept until they are taken; then the oldest go.
    """

    def __init__(
        self, bus: Commons, expression: str, decode: Callable[[bytes], M], *, depth: int = 256
    ) -> None:
        self._inbox = bus.subscribe(expression, depth=depth)
        self._entrance = Entrance(bus.ear, decode)

    def take(self) -> list[tuple[str, M, bytes]]:
        """Return key, message and payload of what has arrived since the last call, oldest first."""
        taken: list[tuple[str, M, bytes]] = []
        for sample in self._inbox.drain():
            message = self._entrance.read(sample.key, sample.payload)
            if message is None:
                continue
            if self._entrance.is_newer(sample.key, message) or self._entrance.keeps_old(sample.key, message):
                taken.append((sample.key, message, sample.payload))
        return taken

    def close(self) -> None:
        """End the subscription."""
        self._inbox.close()


def teller_of(key: str, message: Message) -> str:
    """Return who tells a message: sensors that share a key each have an order of their own.

    A slow sensor's stamps lie before those of a quick one, which measured later and told sooner.
    """
    sensor: object = getattr(message, "sensor", None)
    return f"{key}#{sensor}" if isinstance(sensor, str) else key


def stamp_of(message: Message) -> RobotTime | None:
    """Return a message's stamp, if it has one."""
    stamp: object = getattr(message, "stamp", None)
    return stamp if isinstance(stamp, RobotTime) else None


def _keep(known: dict[str, V], key: str, value: V) -> None:
    """Note it; of keys that somebody makes up, the oldest are forgotten."""
    known[key] = value
    if len(known) > KINDS:
        known.pop(next(iter(known)))


def _first(error: ValueError) -> str:
    """Return the first thing that is wrong, and where in the document."""
    return in_words(problems_of(error, most=1)) if isinstance(error, ValidationError) else str(error)
