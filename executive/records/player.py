"""Plays a record into a bus in memory: who listens there hears what was heard on the robot.

A view of the robot stands on ``Player.bus`` as it would on the robot's own:

    player = Player(open_recording(path))
    player.seek(player.record.span.begin)
    feed = Feed(player.bus, monotonic)
    player.advance(0.05)    # call it again and again; player.speed is how fast

**Forward**, a seek says the last message of each key once, not all that lie between. **Backward**, a listener
could not tell what was from what is yet to come: ``seek`` makes a new bus, and ``generation`` counts up. Make
new listeners then, on ``bus``. Queries are answered as the robot would have: see ``answers``.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from tandem.executive.records.answers import Answers
from tandem.executive.records.known import ALIVE, Known, names_task
from tandem.executive.records.recording import Recorded, Recording
from tandem.executive.records.tape import Tape
from tandem.skills.ports.tasks import TASK_STATUS
from tandem.skills.wire.memory import MemoryBus, MemoryHub


class Player:
    """A record that plays.

    Args:
        record: its owner closes it.
        monotonic: the host's monotonic clock in seconds, for limits of queries.
    """

    def __init__(self, record: Recording, monotonic: Callable[[], float] = lambda: 0.0) -> None:
        self.record, self._monotonic = record, monotonic
        self.speed = 1.0
        """Seconds of the record that pass in one of ``advance``; 0: it stands."""
        self.generation = 0
        """How many times the bus was replaced."""
        self._tape = Tape(record)
        self._begin_bus()

    @property
    def bus(self) -> MemoryBus:
        """Where it plays now. Nobody else publishes there."""
        return self._bus

    @property
    def at(self) -> float:
        """Where it is, in robot seconds since the recorder began."""
        return self.known().at

    @property
    def ended(self) -> bool:
        """Whether there is nothing more to play."""
        return self._tape.at >= self.record.span.end

    def known(self) -> Known:
        """Return what is known here."""
        return self._tape.known()

    def seek(self, at: float) -> bool:
        """Go to a moment within the record; return whether the bus is a new one.

        Args:
            at: robot seconds since the recorder began; outside of the span the nearest end of it.
        """
        at = self.record.span.clipped(at)
        if back := at < self._tape.at:
            self._begin_bus()
            self.generation += 1
        before = dict(self._tape.known().last)
        self._tape.go(at)
        for message in self._tape.known().last.values():
            if back or before.get(message.key) != message:
                self._say(message, task_too=True)
        return back

    def advance(self, seconds: float) -> int:
        """Play what was heard in so many seconds, times ``speed``; return how many messages that is."""
        if not math.isfinite(self._tape.at):
            self.seek(self.record.span.begin)
        return self.play(self._tape.at + max(0.0, seconds) * self.speed)

    def play(self, until: float) -> int:
        """Play every message up to a moment that is not before this one; return how many that is."""
        count = 0
        for message in self._tape.walk(self.record.span.clipped(until)):
            self._say(message)
            count += 1
        return count

    def say_known(self) -> None:
        """Say the last message of each key once more, to listeners that have just come."""
        for message in self._tape.known().last.values():
            self._say(message, task_too=True)

    def step(self) -> bool:
        """Answer the queries that wait; return whether more do."""
        return self._answers.step()

    def _begin_bus(self) -> None:
        self._hub = MemoryHub()
        self._bus = self._hub.endpoint()
        self._there: dict[str, MemoryBus] = {}
        self._answers = Answers(self._hub.endpoint(), self._monotonic, self.record.attachments, self.known)

    def _say(self, message: Recorded, *, task_too: bool = False) -> None:
        if message.key == ALIVE:
            self._announce()
        elif message.encoding != "jpeg":
            self._bus.publish(message.key, message.payload)
            if task_too and names_task(message.key):
                # Of task/status only the last is known: who listens there hears of each task all the same.
                self._bus.publish(TASK_STATUS.key, message.payload)

    def _announce(self) -> None:
        names = self._tape.known().alive()
        for name in self._there.keys() - names:
            self._there.pop(name).close()
        for name in sorted(names - self._there.keys()):
            self._there[name] = self._hub.endpoint()
            self._there[name].announce(name)
