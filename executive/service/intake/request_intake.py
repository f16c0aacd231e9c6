"""Where requests come in: checked, written down, and answered once they are on disk."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from pydantic import JsonValue

from tandem.executive.ledger.port import LedgerError
from tandem.executive.service.intake.client_gateway import with_sender
from tandem.executive.service.intake.client_limits import Bounds
from tandem.executive.service.intake.request_parser import Asked, Refused, check_request, read_request
from tandem.executive.service.tasks.task_book import TaskBook
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import AnyDocument, Call, endpoint
from tandem.skills.ports.keys import Service
from tandem.skills.ports.limits import Limits
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import WHOLE, Problem
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import REQUEST, TASK_ANSWERS, TaskAnswer, by_client
from tandem.trees.task import TaskType

AT_ONCE: Final = 64
"""Documents that one step reads and one commit makes durable; the rest waits for the next."""

_LOG = logging.getLogger(__name__)


@dataclass(frozen=True)
class _Document:
    fields: dict[str, JsonValue]
    reply: Callable[[bytes], None]


class Intake:
    """Takes what is queried or put on ``task/request``, by anybody and by named clients.

    Args:
        bus: where clients are.
        clocks: host time for rates.
        book: takes what is right.
        kinds: of tasks, by name.
        site: what is known beforehand.
        robot: says what is known of the robot; None while nothing is.
        begin: begins what can begin at once; what it writes is on disk with what was accepted.
        bounds: what one client may ask for.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        book: TaskBook,
        kinds: Mapping[str, TaskType[Message]],
        site: Site,
        *,
        robot: Callable[[], RobotDescription | None],
        begin: Callable[[], None],
        bounds: Bounds,
    ) -> None:
        self._bus, self._book, self._kinds, self._site = bus, book, kinds, site
        self._robot, self._begin = robot, begin
        limits = Limits(per_step=AT_ONCE // 2, rate=bounds.rate, burst=bounds.burst)
        service = Service(REQUEST, AnyDocument, TaskAnswer, limits=limits)
        self._endpoints = Endpoints(
            bus,
            clocks.monotonic,
            [
                endpoint(service, self._hear, refuse=self._refuse, puts=True, at=key)
                for key in (REQUEST, by_client("*", REQUEST))
            ],
        )
        self._now: list[_Document] = []

    @property
    def unread(self) -> bool:
        """Whether documents wait for the next step."""
        return self._endpoints.waiting

    def step(self) -> tuple[str, ...]:
        """Consider what came, commit once, then answer all; return the ids of what was accepted."""
        self._endpoints.step()
        now, self._now = self._now, []
        if not now:
            return ()
        answers = self._kept([self._consider(document.fields) for document in now])
        for document, answer in zip(now, answers, strict=True):
            document.reply(answer.model_dump_json().encode())
            TASK_ANSWERS.publish(self._bus, answer)
        return tuple(dict.fromkeys(answer.task for answer in answers if answer.accepted))

    def close(self) -> None:
        """Take nothing any more."""
        self._endpoints.close()

    def _hear(self, call: Call[AnyDocument]) -> None:
        document = with_sender(call.fields, call.name)
        if isinstance(document, Problem):
            call.reply(self._refuse((document,)).model_dump_json().encode())
        else:
            self._now.append(_Document(document, call.reply))

    def _refuse(self, problems: tuple[Problem, ...]) -> TaskAnswer:
        answer = TaskAnswer(accepted=False, problems=problems)
        TASK_ANSWERS.publish(self._bus, answer)
        return answer

    def read(self, payload: bytes) -> Asked | Refused:
        """Check a document that was taken before a restart."""
        return self._checked(lambda: read_request(payload, self._kinds, self._site))

    def _checked(self, check: Callable[[], Asked | Refused]) -> Asked | Refused:
        """Check one document; a check that raises costs its request, not the service."""
        try:
            return check()
        except Exception as error:  # noqa: BLE001 - as said
            _LOG.exception("checking a request raised")
            text = f"a request that can be checked; the check raised {_short(error)}"
            return Refused((Problem(path=WHOLE, expected=text),))

    def _consider(self, fields: dict[str, JsonValue]) -> TaskAnswer:
        asked = self._checked(lambda: check_request(fields, self._kinds, self._site, self._robot()))
        if isinstance(asked, Refused):
            return TaskAnswer(accepted=False, problems=asked.problems, client_id=asked.client_id)
        try:
            return self._book.accept(asked)
        except LedgerError as error:
            _LOG.exception("could not store a request")
            return _not_kept(asked.client_id, error)

    def _kept(self, answers: list[TaskAnswer]) -> list[TaskAnswer]:
        """Return what may be told once all is on disk, or that it could not be put there."""
        try:
            self._begin()
            self._book.keep()
        except LedgerError as error:
            self._book.drop_fresh()
            _LOG.exception("could not store requests")
            return [_not_kept(each.client_id, error) if each.accepted else each for each in answers]
        return [self._or_not(each) for each in answers]

    def _or_not(self, answer: TaskAnswer) -> TaskAnswer:
        """Return the answer, unless a later request's error took it back out of the ledger."""
        if not answer.accepted or self._book.find(answer.task) is not None:
            return answer
        return _not_kept(answer.client_id, LedgerError("another request in the same batch failed"))


def _not_kept(client_id: str, error: LedgerError) -> TaskAnswer:
    problem = Problem(
        path=WHOLE,
        expected="a writable disk; try again later",
        found=str(error),
        code="NOT_KEPT",
    )
    return TaskAnswer(accepted=False, problems=(problem,), client_id=client_id)


def _short(error: Exception) -> str:
    """Return what was raised, as one line for a client; the log has all of it."""
    said = " ".join(str(error).split())[:200]
    return f"{type(error).__name__}{f': {said}' if said else ''}; see the executive's log for the traceback"
