"""Where requests come in: checked, written down, and answered once they are on disk."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from executive.ledger.port import LedgerError
from executive.requests import Asked, Refused, read_request
from executive.task_book import TaskBook
from skills.ports.bus import Bus
from skills.ports.message import Message
from skills.ports.site import Site
from skills.ports.tasks import REQUEST, TASK_ANSWERS, Problem, TaskAnswer
from trees.task import TaskType

AT_ONCE: Final = 64
"""Documents that one step reads and one commit makes durable; the rest waits for the next."""

_LOG = logging.getLogger(__name__)
_Reply = Callable[[bytes], None]


@dataclass(eq=False)
class _Document:
    payload: bytes
    reply: _Reply | None
    """None when it was put: then the answer is on ``task/answers`` only."""


class Intake:
    """Reads ``task/request``.

    Args:
        bus: where clients are.
        book: takes what is right.
        kinds: of tasks, by name.
        site: what is known beforehand.
    """

    def __init__(self, bus: Bus, book: TaskBook, kinds: Mapping[str, TaskType[Message]], site: Site) -> None:
        self._bus, self._book, self._kinds, self._site = bus, book, kinds, site
        self._puts, self._asks = bus.subscribe(REQUEST), bus.serve(REQUEST, limit=1 << 20)
        self._unread: list[_Document] = []

    @property
    def unread(self) -> bool:
        """Whether documents wait for the next step."""
        return bool(self._unread)

    def step(self) -> tuple[str, ...]:
        """Consider what came, commit once, then answer all; return the ids of what was accepted."""
        self._unread += [_Document(sample.payload, None) for sample in self._puts.drain()]
        self._unread += [_Document(request.payload, request.reply) for request in self._asks.drain()]
        now, self._unread = self._unread[:AT_ONCE], self._unread[AT_ONCE:]
        if not now:
            return ()
        answers = self._kept([self._consider(document.payload) for document in now])
        for document, answer in zip(now, answers, strict=True):
            if document.reply is not None:
                document.reply(answer.model_dump_json().encode())
            TASK_ANSWERS.publish(self._bus, answer)
        return tuple(dict.fromkeys(answer.task for answer in answers if answer.accepted))

    def close(self) -> None:
        """Take nothing any more."""
        self._puts.close()
        self._asks.close()

    def read(self, payload: bytes) -> Asked | Refused:
        """Check one document; a check that raises costs its request, not the service."""
        try:
            return read_request(payload, self._kinds, self._site)
        except Exception as error:  # noqa: BLE001 - as said
            _LOG.exception("a request's check raised")
            text = f"a request that can be checked; its check raised {type(error).__name__}"
            return Refused((Problem(path="(the document)", expected=text),))

    def _consider(self, payload: bytes) -> TaskAnswer:
        asked = self.read(payload)
        if isinstance(asked, Refused):
            return TaskAnswer(accepted=False, problems=asked.problems, client_id=asked.client_id)
        try:
            return self._book.accept(asked)
        except LedgerError as error:
            _LOG.exception("a request could not be written down")
            return _not_kept(asked.client_id, error)

    def _kept(self, answers: list[TaskAnswer]) -> list[TaskAnswer]:
        """Return what may be told once all is on disk, or that it could not be put there."""
        try:
            self._book.keep()
        except LedgerError as error:
            _LOG.exception("requests could not be written down")
            return [_not_kept(each.client_id, error) if each.accepted else each for each in answers]
        return [self._or_not(each) for each in answers]

    def _or_not(self, answer: TaskAnswer) -> TaskAnswer:
        """Return the answer, unless a later request's error took it back out of the ledger."""
        if not answer.accepted or self._book.find(answer.task) is not None:
            return answer
        return _not_kept(answer.client_id, LedgerError("another request of the same moment failed"))


def _not_kept(client_id: str, error: LedgerError) -> TaskAnswer:
    problem = Problem(
        path="(the document)",
        expected="a disk that it can be written to; ask again later",
        found=str(error),
        code="NOT_KEPT",
    )
    return TaskAnswer(accepted=False, problems=(problem,), client_id=client_id)
