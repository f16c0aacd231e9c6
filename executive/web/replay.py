"""A record in place of a robot: the same page, with a moment that a viewer chooses, and without verbs.

All viewers of a replay see the same moment. It plays while somebody looks on.
"""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from typing import Annotated, Final

from pydantic import Field, JsonValue

from tandem.executive.client.aio import AsyncClient
from tandem.executive.config.run_options import BusOptions
from tandem.executive.records.player import Player
from tandem.executive.records.recording import Recording
from tandem.executive.security.rights import Rights
from tandem.executive.web.robot import REPLAY, Ears, Who
from tandem.executive.web.viewers import Update
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.keys import rgbd
from tandem.skills.ports.message import Message, RobotTime

LONGEST: Final = 0.25
"""Host seconds that pass in one turn at the most: a server that was stopped does not jump ahead."""
PICTURE_WITHIN: Final = 3.0
"""Robot seconds for which a picture shows what the camera saw."""
FASTEST: Final = 64.0
"""Times real time: the page offers up to 16, another client may ask for more. At this speed a turn of a
twentieth of a second takes in 3.2 s of the record; faster ones would show leaps."""


class Move(Message):
    """Where to go in a record, and how fast it plays; what is left out stays."""

    at: float | None = None
    """Robot seconds since the recorder began."""
    seconds: float | None = None
    """Instead of ``at``: the robot's own time, of the boot that is shown now."""
    speed: Annotated[float, Field(ge=0.0, le=FASTEST)] | None = None
    """Seconds of the record in a second; 0: it stands."""


class Replay:
    """A record that plays; implements ``Robot``.

    Args:
        record: closed with this.
        monotonic: seconds of the host.
    """

    def __init__(self, record: Recording, monotonic: Callable[[], float] = time.monotonic) -> None:
        self.record, self._monotonic = record, monotonic
        self.player = Player(record, monotonic)
        self.player.seek(record.span.begin)
        self._turned, self._told_at = monotonic(), float("-inf")
        self._moves = 0

    @property
    def options(self) -> BusOptions:
        """The record stands for the router."""
        facts = self.record.facts
        return BusOptions(str(self.record.path), facts.site, facts.robot)

    @property
    def who(self) -> Who:
        """Who may ask nothing of the past."""
        return Who("", REPLAY, Rights())

    async def client(self) -> AsyncClient:
        """Return a client that asks the record."""
        return _PastClient(self)

    async def listen(self) -> Ears:
        """Open an end at the moment that is shown; it is over with the next move."""
        moves = self._moves
        self._turned, self._told_at = self._monotonic(), float("-inf")
        fresh = True

        def turn() -> Update:
            nonlocal fresh
            if fresh:
                fresh = False
                self.player.say_known()
            return self._turn()

        return Ears(
            self.player.bus,
            lambda: None,
            commons=self.player.bus,
            age=lambda: self.player.at,
            turn=turn,
            over=lambda: self._moves != moves,
        )

    async def close(self) -> None:
        """Close the record."""
        self.record.close()

    def move(self, asked: Move) -> Update:
        """Go to another moment, or at another speed; return where it is."""
        at = asked.at if asked.seconds is None else self._at_of(asked.seconds)
        if asked.speed is not None:
            self.player.speed = asked.speed
        if at is not None:
            self.player.seek(at)
            self._moves += 1
        return self.where()

    def where(self) -> Update:
        """Return the moment, as it is told to the page."""
        span, cause = self.record.span, self.record.facts.cause
        told: dict[str, JsonValue] = {
            "at": round(self.player.at, 2),
            "speed": self.player.speed,
            "begin": span.begin,
            "end": span.end,
            "began": self.record.facts.began,
            "cause": None if cause is None else {"at": cause.at, "words": cause.words},
        }
        return {"replay": told}

    def picture(self, camera: str) -> bytes:
        """Return what a camera saw last, as JPEG; empty when there is none. Without a name: any camera."""
        at = self.player.at
        found = b""
        for each in self.record.pictures(at - PICTURE_WITHIN, at):
            if not camera or each.key == rgbd(camera):
                found = each.payload
        return found

    def _at_of(self, seconds: float) -> float | None:
        known = self.player.known()
        if known.stamp is None:
            return None
        later = RobotTime(boot=known.stamp.boot, seconds=seconds).since(known.stamp)
        return None if later is None else known.at + later

    def _turn(self) -> Update:
        now = self._monotonic()
        passed, self._turned = min(now - self._turned, LONGEST), now
        if self.player.speed and not self.player.ended:
            self.player.advance(passed)
        if now - self._told_at < LONGEST:
            return {}
        self._told_at = now
        return self.where()


class _PastLink:
    """A client's end: waiting lets the record answer."""

    def __init__(self, player: Player) -> None:
        self._player = player

    @property
    def bus(self) -> Bus:
        """Where it plays now."""
        return self._player.bus

    async def wait(self, seconds: float) -> None:
        """Answer."""
        del seconds
        self._player.step()
        await asyncio.sleep(0)

    async def close(self) -> None:
        """Do nothing: the record is another's."""


class _PastClient(AsyncClient):
    def __init__(self, replay: Replay) -> None:
        super().__init__(str(replay.record.path), link=_PastLink(replay.player), patience=0.5)
        self._replay = replay

    async def camera(self, name: str = "") -> bytes:
        return self._replay.picture(name)
