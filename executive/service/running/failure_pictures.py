"""What went wrong in a task, with the camera's picture of each such moment."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Final

from tandem.skills.ports.actions.perception import PICTURE
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import answering
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Nothing, Service
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.tasks import TASK_PICTURE, AskPicture, Attempt
from tandem.trees.context import TreeContext

STORED_PICTURE: Final = Service(TASK_PICTURE, AskPicture, Nothing, reads=True)
"""Answered with a JPEG."""
KEPT_OF_A_TASK: Final = 8
"""Pictures of one task: one that fails often leaves room for others."""
KEPT: Final = 64
"""Pictures in memory, of all tasks; the oldest go."""
TOLD: Final = 32
"""Attempts that are told, the newest."""
PICTURE_WITHIN: Final = 3.0
"""Host seconds that the camera has."""


class Album:
    """The pictures, served on ``task/picture``.

    Args:
        bus: where clients are.
        clocks: host time for rates.
    """

    def __init__(self, bus: Bus, clocks: Clocks) -> None:
        self._endpoints = Endpoints(bus, clocks.monotonic, (answering(STORED_PICTURE, self._find),))
        self._pictures: deque[tuple[str, str, bytes]] = deque()

    def step(self) -> bool:
        """Answer who asked, with nothing where there is no such picture; return whether more wait."""
        return self._endpoints.step()

    def keep(self, task: str, number: str, picture: bytes) -> None:
        """Keep a picture; the oldest of the task, and of all, make room."""
        self._pictures.append((task, number, picture))
        of_task = [each for each in self._pictures if each[0] == task]
        for old in of_task[:-KEPT_OF_A_TASK]:
            self._pictures.remove(old)
        while len(self._pictures) > KEPT:
            self._pictures.popleft()

    def has(self, task: str, number: str) -> bool:
        """Say whether the picture is there (still)."""
        return any((of, each) == (task, number) for of, each, _ in self._pictures)

    def close(self) -> None:
        """Stop serving."""
        self._endpoints.close()

    def _find(self, asked: AskPicture) -> bytes:
        wanted = (asked.task, asked.picture)
        return next((picture for *at, picture in self._pictures if tuple(at) == wanted), b"")


@dataclass(eq=False)
class _Shot:
    """A picture that was asked for, and the failures of whose moment it is."""

    number: str
    pending: Pending
    asked_at: float
    failures: list[Failure]


@dataclass(eq=False)
class Tries:
    """Watches one task's attempts, and asks for a picture at each new one. Never waits.

    Args:
        bus: where the camera's skill is.
        clocks: host time, for a camera that does not answer.
        context: has the attempts.
        album: keeps the pictures.
    """

    bus: Bus
    clocks: Clocks
    context: TreeContext
    album: Album
    tried: tuple[Attempt, ...] = ()
    """As they are told."""
    _seen: list[Attempt] = field(default_factory=list)
    _failures: list[Failure] = field(default_factory=list)
    _numbers: list[tuple[Failure, str]] = field(default_factory=list)
    _shot: _Shot | None = None
    _shots: int = 0

    @property
    def pending(self) -> bool:
        """Whether a picture is under way."""
        return self._shot is not None

    def step(self) -> bool:
        """Look for new attempts and pictures; return whether ``tried`` has changed."""
        arrived = self._take_picture()
        now = self.context.failures.attempts
        same = len(now) == len(self._seen) and all(a is b for a, b in zip(now, self._seen, strict=True))
        if same and not arrived:
            return False
        if not same:
            self._note_new(now)
        self._seen = list(now)
        self.tried = tuple(self._with_picture(attempt) for attempt in now[-TOLD:])
        return True

    def _note_new(self, attempts: list[Attempt]) -> None:
        # An attempt is told anew when its recovery is known; its failure stays the same object.
        known = self._failures
        new = [each.failure for each in attempts if not any(each.failure is old for old in known)]
        self._failures = [each.failure for each in attempts]
        if new and self._shot is not None:
            self._shot.failures += new
        elif new:
            self._shots += 1
            pending = self.bus.query(PICTURE, b"", timeout=PICTURE_WITHIN)
            self._shot = _Shot(str(self._shots), pending, self.clocks.monotonic(), new)

    def _take_picture(self) -> bool:
        shot = self._shot
        if shot is None:
            return False
        picture = shot.pending.poll()
        late = self.clocks.monotonic() - shot.asked_at > PICTURE_WITHIN
        if picture is None and not shot.pending.done() and not late:
            return False
        self._shot = None
        if not picture:
            return False
        self.album.keep(self.context.task, shot.number, picture)
        self._numbers += [(failure, shot.number) for failure in shot.failures]
        self._numbers = self._numbers[-TOLD:]
        return True

    def _with_picture(self, attempt: Attempt) -> Attempt:
        number = next((number for failure, number in self._numbers if failure is attempt.failure), "")
        if not number or not self.album.has(self.context.task, number):
            return attempt
        return attempt.model_copy(update={"picture": number})
