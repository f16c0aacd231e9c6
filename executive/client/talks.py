"""What a client says and hears, without waiting for it: both clients drive the same conversations.

A ``Talk`` is a generator: it yields how many seconds it may be left alone (a message may end the wait
sooner), and returns its result. ``Client`` waits in its own thread, ``AsyncClient`` lets the loop go on.

An answer may be lost (a link goes; zenoh tells nothing just after a peer has come). So a talk asks again,
the same document under the same id, until its patience ends (see ``asking``); the executive answers a
repeated request with the first one's task.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass
from typing import Final, TypeVar

from pydantic import ValidationError

from tandem.executive.client.asking import Asking
from tandem.executive.client.errors import DeclinedError, NotConnectedError, OtherVersionError
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.endpoint import Refusal
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message, read_leniently

T = TypeVar("T")
Sent = TypeVar("Sent", bound=Message)
Answered = TypeVar("Answered", bound=Message)
Talk = Generator[float, None, T]
"""Yields seconds that it may be left alone; returns its result."""

PATIENCE: Final = 2.5
"""Seconds of the host in which somebody must answer."""
LOST_AFTER: Final = 60.0
"""Seconds of silence after which following a task is given up. An executive is back within 1 s of a crash, a
whole simulated robot within about 20 s; on a busy machine it takes twice that."""


@dataclass(frozen=True)
class Talks:
    """Asks, and asks again.

    Args:
        bus: where the executive is.
        monotonic: seconds of the host's monotonic clock.
        where: the bus in words, for errors.
        patience: host seconds in which somebody must answer.
        lost_after: host seconds of silence that who follows a task bears.
    """

    bus: Bus
    monotonic: Callable[[], float]
    where: str
    patience: float = PATIENCE
    lost_after: float = LOST_AFTER

    def ask(self, service: Service[Sent, Answered], message: Sent) -> Talk[Answered]:
        """Return the answer of a service."""
        return (yield from self.answer(service.key, message.model_dump_json().encode(), service.answered))

    def answer(self, key: str, payload: bytes, model: type[Answered]) -> Talk[Answered]:
        """Return the answer to a document.

        Raises:
            NotConnectedError: when there is none in time.
            OtherVersionError: when it is not of the model.
        """
        document = yield from self.raw(key, payload)
        if document is None:
            raise NotConnectedError(self._nobody(key))
        try:
            return read_leniently(model, document)
        except ValidationError as error:
            raise OtherVersionError(
                f"{key}: the answer is from another version of tandem: {error.error_count()} fields differ"
            ) from error

    def raw(self, key: str, payload: bytes) -> Talk[bytes | None]:
        """Return what is answered as it is, None when nobody answers in time.

        Raises:
            DeclinedError: when it was refused each time, as for its rate.
        """
        asking = Asking(self.bus, key, payload, self.monotonic, self.patience)
        while (left := asking.left()) > 0.0:
            yield left
        if asking.answer is None and (refusal := asking.refusal()) is not None:
            raise DeclinedError(key, reason_of(refusal))
        return asking.answer

    def _nobody(self, key: str) -> str:
        there = ", ".join(sorted(name for name in self.bus.alive() if name.startswith("process/")))
        seen = f"connected are only {there}" if there else "none of its processes is connected"
        who = "hardware" if key.startswith("hw/") else "executive"
        return f"no {who} answers on {self.where}: {seen}; start the system with `tandem up`"


def reason_of(refusal: bytes) -> str:
    """Return in words why a question was refused."""
    try:
        return Refusal.model_validate_json(refusal).reason
    except ValidationError:
        return "the answer is an error that this program can't read"
