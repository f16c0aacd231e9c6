"""Serving: one mechanism for every key that answers queries, so that its promises hold at all of them.

A ``Service`` of the table of keys declares what an endpoint takes: its key, the request's model, whether it
is a question or a command, and its limits. An ``Endpoint`` adds the handler; ``Endpoints`` serves them:

- A *question* reads only. Any selector may ask it, each key answers for itself, and no document is needed.
- A *command* needs its exact key and a valid document with at least one field. No wildcard reaches it.
- Size, depth and rate are checked before a document is read. Names that stand twice, and what the model does
  not take, are answered with where and what was expected.
- A handler that raises costs one answer: the log gets the trace, the sender a refusal, and the loop goes on.
- A step handles a bounded number of queries and says whether more wait.
"""

from __future__ import annotations

import logging
import re
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from pydantic import ValidationError

from tandem.skills.ports.bus import Bus, Inbox, Request
from tandem.skills.ports.documents import parse
from tandem.skills.ports.endpoint import AnyDocument, Call, Endpoint, Problems, Refusal
from tandem.skills.ports.hearing import Reason
from tandem.skills.ports.limits import Rates
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import WHOLE, Problem, in_words, problems_of

TOLD: Final = 20.0
"""Refusals for its rate that a sender is told in a second; more end unanswered: an answer costs more than the
check."""
KEYS_AT_ONCE: Final = 100
"""Keys of a pattern that one wildcard query is answered under, as many as a page of a list has."""
NAME: Final = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,79}")
"""What may stand in a key for a ``*``: nothing that would need an escape wherever the name goes."""

_LOG = logging.getLogger(__name__)


class Endpoints:
    """Serves endpoints. Call ``step`` once in a step of their node.

    Args:
        bus: where the queries come from.
        monotonic: the host's monotonic clock in seconds, for rates (in lockstep: simulated seconds).
        served: all of them, in the order in which a step handles them.
        fatal: what a handler may raise to end the process, once its query has been refused.
    """

    def __init__(
        self,
        bus: Bus,
        monotonic: Callable[[], float],
        served: Sequence[Endpoint],
        *,
        fatal: tuple[type[Exception], ...] = (),
    ) -> None:
        self._served = [_Served(bus, monotonic, each, fatal) for each in served]

    @property
    def waiting(self) -> bool:
        """Whether queries wait for the next step."""
        return any(served.backlog for served in self._served)

    @property
    def refused(self) -> int:
        """Queries that were refused so far."""
        return sum(served.refused for served in self._served)

    def step(self) -> bool:
        """Handle what came, as much as one step may; return whether more wait."""
        more = False
        for served in self._served:
            more = served.step() or more
        return more

    def close(self) -> None:
        """Stop serving; what waits ends without an answer. Closing twice is allowed."""
        for served in self._served:
            served.close()


@dataclass(eq=False)
class _Served:
    """One endpoint at its desk."""

    bus: Bus
    monotonic: Callable[[], float]
    endpoint: Endpoint
    fatal: tuple[type[Exception], ...]
    backlog: deque[Request] = field(default_factory=deque)
    refused: int = 0

    def __post_init__(self) -> None:
        service, limits = self.endpoint.service, self.endpoint.service.limits
        self.service, self.limits = service, limits
        self._desk = self.bus.serve(self.endpoint.key, limit=limits.bytes)
        self._inbox: Inbox | None = self.bus.subscribe(self.endpoint.key) if self.endpoint.puts else None
        self._rates = Rates(limits.rate, limits.burst, self.monotonic)
        self._told = Rates(TOLD, TOLD, self.monotonic)
        self._has_verdict = {"accepted", "reason"} <= service.answered.model_fields.keys()

    def step(self) -> bool:
        """Handle as many as one step may; return whether more wait.

        The desk keeps the others, and drops what it has no room for.
        """
        if not self.backlog:
            puts = () if self._inbox is None else self._inbox.drain()
            if puts:
                # One on a wildcard reaches its subscribers under the wildcard's name: that is no exact key.
                self.backlog.extend(_Put(each.key, each.payload) for each in puts if "*" not in each.key)
            self.backlog.extend(self._desk.drain())
            if not self.backlog:
                return False
        for _ in range(min(self.limits.per_step, len(self.backlog))):
            request = self.backlog.popleft()
            if request.selector == request.key:
                self._take(request)
            else:
                self._discover(request)
        return bool(self.backlog)

    def close(self) -> None:
        """Stop serving."""
        self._desk.close()
        if self._inbox is not None:
            self._inbox.close()
        while self.backlog:
            self.backlog.popleft().end()

    def _take(self, request: Request) -> None:
        """Check all that there is to check, and call the handler."""
        name = self._name(request.key)
        if name is None:
            wanted = "a name of letters, digits, dots, dashes and underscores in the key"
            self._refuse(request, (Problem(path=WHOLE, expected=wanted, found=ascii(request.key)[:80]),))
            return
        wait = self._rates.take(name)
        if wait > 0.0:
            self._too_many(request, name, wait)
            return
        try:
            call = self._read(request, request.key, name)
            if isinstance(call, tuple):
                self._refuse(request, call)
                return
            answer = self._answer(call)
        except Exception as error:
            _LOG.exception("%s: the handler raised", request.key)
            raised = f"a handler that works; it raised {type(error).__name__}, and the log has the trace"
            self._refuse(request, (Problem(path=WHOLE, expected=raised),))
            if isinstance(error, self.fatal):
                raise
        else:
            if answer is not None:
                request.reply(answer)

    def _discover(self, request: Request) -> None:
        """Answer a wildcard under each key that may be read so; the others are not there for it."""
        answers: dict[str, bytes] = {}
        if self.service.reads and not self.service.exact:
            keys = (request.key,) if request.key else self.endpoint.keys()
            for key in [each for each in keys if request.covers(each)][:KEYS_AT_ONCE]:
                answer = self._told_of(request, key)
                if answer is not None:
                    answers[key] = answer
        if answers:
            request.reply_each(answers)
        else:
            request.end()

    def _told_of(self, request: Request, key: str) -> bytes | None:
        """Return a question's answer; nothing where there is none, whyever."""
        try:
            call = self._read(request, key, self._name(key) or "")
            return None if isinstance(call, tuple) else self._answer(call)
        except Exception:  # noqa: BLE001 - nobody is told: a wildcard asks no endpoint in particular
            _LOG.exception("%s: the handler raised", key)
            return None

    def _name(self, key: str) -> str | None:
        """Return what stands in a key for the star of this endpoint's; None when it is no name."""
        parts = zip(self.endpoint.key.split("/"), key.split("/"), strict=False)
        names = [part for pattern, part in parts if pattern == "*"]
        if not all(NAME.fullmatch(name) for name in names):
            return None
        return names[0] if names else ""

    def _read(self, request: Request, key: str, name: str) -> Call[Message] | Problems:
        """Return the query with its document, or what is wrong with it."""
        call = self._document(request, key, name)
        unread = self.endpoint.unread
        if unread is None or not isinstance(call, tuple):
            return call
        _LOG.warning("%s: %s; it is taken all the same", key, in_words(call))
        return Call(unread(), {}, key, name, request.reply)

    def _document(self, request: Request, key: str, name: str) -> Call[Message] | Problems:
        limits, service = self.limits, self.service
        if request.size > limits.bytes:
            return _wrong(f"at most {limits.bytes} bytes", f"{request.size} bytes")
        payload = request.payload or (b"{}" if service.reads else b"")
        fields = parse(payload, limit=limits.bytes, depth=limits.depth)
        if isinstance(fields, tuple):
            return tuple(self._told_what(each) for each in fields)
        if not fields and not service.reads:
            return _wrong(f"at least one field of {self._shape}", "{}")
        try:
            # The JSON and not the fields: only so does the model read arrays as tuples and texts as enums.
            # Strictly: ``true`` is no width of 1 m, and "9" is no number.
            document = (
                AnyDocument()
                if service.asked is AnyDocument
                else service.asked.model_validate_json(payload, strict=True)
            )
        except ValidationError as error:
            return problems_of(error)
        return Call(document, fields, key, name, request.reply)

    @property
    def _shape(self) -> str:
        """The document that is expected, in words."""
        names = ", ".join(f'"{name}"' for name in self.service.asked.model_fields)
        return f"a JSON object with {names}" if names else "a JSON object"

    def _told_what(self, problem: Problem) -> Problem:
        """Say which fields a document has, to whoever sent none."""
        if problem.expected not in {"JSON", "a JSON object"} or self.service.asked is AnyDocument:
            return problem
        return problem.model_copy(update={"expected": self._shape})

    def _answer(self, call: Call[Message]) -> bytes | None:
        answer = self.endpoint.take(call)
        return answer.model_dump_json().encode() if isinstance(answer, Message) else answer

    def _refuse(self, request: Request, problems: Problems) -> None:
        self.refused += 1
        if isinstance(request, _Put):  # nobody waits for an answer that would say so
            self.bus.ear.refuse(request.key, Reason.MALFORMED, in_words(problems))
        if self.endpoint.refuse is not None:
            request.reply(self.endpoint.refuse(problems).model_dump_json().encode())
        elif self._has_verdict:
            fields = {"accepted": False, "reason": in_words(problems)}
            request.reply(self.service.answered.model_validate(fields).model_dump_json().encode())
        else:
            refusal = Refusal(reason=in_words(problems), problems=problems)
            request.refuse(refusal.model_dump_json().encode())

    def _too_many(self, request: Request, name: str, wait: float) -> None:
        if self._told.take(name) > 0.0:
            self.refused += 1
            request.end()
            return
        expected = f"at most {self.limits.rate:g} queries a second; ask again in {wait:.3f} s"
        self._refuse(request, (Problem(path=WHOLE, expected=expected, found="more"),))


@dataclass(eq=False)
class _Put:
    """Something that was put, as a query whose answer goes nowhere."""

    key: str
    payload: bytes

    @property
    def selector(self) -> str:
        return self.key

    @property
    def size(self) -> int:
        return len(self.payload)

    def covers(self, key: str) -> bool:
        return key == self.key

    def reply(self, payload: bytes) -> None: ...

    def reply_each(self, answers: Mapping[str, bytes]) -> None: ...

    def refuse(self, payload: bytes) -> None: ...

    def end(self) -> None: ...


def _wrong(expected: str, found: str) -> Problems:
    return (Problem(path=WHOLE, expected=expected, found=found),)
