"""A command's end of the bus: asks, waits a little, and says who is not there and what to do."""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import replace
from types import TracebackType
from typing import Final, Self, TypeVar

from pydantic import JsonValue, ValidationError

from tandem.executive.cli.allowed import may_ask, refuse_unless_allowed
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.client.asking import Asking
from tandem.executive.client.talks import reason_of
from tandem.executive.config.run_options import BusOptions
from tandem.executive.ledger.sender import asked_by
from tandem.executive.security.holders import KeysError
from tandem.executive.security.identity import client_in
from tandem.skills.ports.keys import DESCRIPTION, Nothing, Service
from tandem.skills.ports.message import Message, read_leniently
from tandem.skills.ports.tasks import TASK_CANCEL, by_client
from tandem.skills.wire.zenoh_bus import BusError, HostError, ZenohBus

Sent = TypeVar("Sent", bound=Message)
Answered = TypeVar("Answered", bound=Message)

ANSWER_WITHIN: Final = 2.5
"""Seconds of the host in which somebody must answer; with the connection's own, below three."""
ROUTER_WITHIN: Final = 1.0
"""Seconds of the host in which the router must answer."""
NEIGHBOURS_WITHIN: Final = 0.5
"""Seconds of the host for which the router is asked who else is there: it has just answered."""


class Connection:
    """An open bus. Use as a context.

    Args:
        options: where the bus is, and whose keys are meant.
        within: host seconds in which the router, and then the process asked, must answer; ROUTER_WITHIN
            and ANSWER_WITHIN unless given.
    """

    def __init__(self, options: BusOptions, *, within: float | None = None) -> None:
        self._within = ANSWER_WITHIN if within is None else within
        patience = ROUTER_WITHIN if within is None else within
        try:
            self._identity = None if options.keys is None else client_in(options.keys, options.holder)
            self.options = options if self._identity is None else replace(options, holder=self._identity.name)
            shown = None if self._identity is None else self._identity.client()
            self.bus = ZenohBus(options.endpoint, options.prefix, patience=patience, credentials=shown)
        except KeysError as error:
            raise CommandError(str(error)) from error
        except HostError as error:
            raise CommandError(str(error)) from error
        except BusError as error:
            raise _no_router(options) from error

    def __enter__(self) -> Self:
        """Stay open until the context is left."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Close the session; a process that does not would hang at its end."""
        self.bus.close()

    def ask(self, service: Service[Sent, Answered], message: Sent, *, of: str = "executive") -> Answered:
        """Return what a service answers.

        Args:
            service: the key and its models.
            message: what is asked.
            of: who serves it, in words for an error.

        Raises:
            CommandError: NOBODY_THERE without an answer in time, REFUSED when the key does not allow it.
        """
        return self.answer(service.key, message.model_dump_json().encode(), service.answered, of=of)

    def answer(self, key: str, payload: bytes, model: type[Answered], *, of: str = "executive") -> Answered:
        """Return the answer to a document; asks again while nothing comes. Errors as ``ask``."""
        document = self.raw(key, payload)
        if document is None:
            raise CommandError(self.nobody(of), ExitCode.NOBODY_THERE)
        try:
            return read_leniently(model, document)
        except ValidationError as error:
            raise CommandError(
                f"{key}: the answer is from another version of tandem: {error.error_count()} fields differ",
                ExitCode.NOBODY_THERE,
            ) from error

    def own(self, key: str) -> str:
        """Return the key at which the holder of a key asks in its own name; without keys the key itself."""
        return key if self._identity is None else by_client(self._identity.name, key)

    def cancel_key(self) -> str:
        """Return where this client cancels: a requester its own tasks, everybody else any."""
        requester = self._identity is not None and self._identity.role() == "requester"
        return self.own(TASK_CANCEL.key) if requester else TASK_CANCEL.key

    def owns(self, request: Mapping[str, JsonValue]) -> bool:
        """Say whether this client may cancel what was asked for so: a requester its own, others any."""
        requester = self._identity is not None and self._identity.role() == "requester"
        return not requester or asked_by(request) == self.options.holder

    def require_right(self, key: str) -> None:
        """Raise REFUSED, with who may, when the key that is shown does not allow a question at this key."""
        if self._identity is not None:
            refuse_unless_allowed(self._identity, key)

    def allows(self, key: str) -> bool:
        """Say whether the key that is shown allows a question at this key."""
        return self._identity is None or may_ask(self._identity.rights(), key)

    def raw(self, key: str, payload: bytes) -> bytes | None:
        """Return what is answered as it is, or None when nobody answers in time.

        Raises:
            CommandError: REFUSED when the key that is shown does not allow the question, or whoever serves it
                has refused it each time.
        """
        self.require_right(key)
        asking = Asking(self.bus, key, payload, time.monotonic, self._within)
        while (left := asking.left()) > 0.0:
            self.bus.waker.wait(min(0.05, left))
        if asking.answer is None and (refusal := asking.refusal()) is not None:
            raise CommandError(f"{key} was refused: {reason_of(refusal)}", ExitCode.REFUSED)
        return asking.answer

    def robot_name(self) -> str | None:
        """Return the name that the robot's hardware tells, or None when no hardware answers."""
        document = self.raw(DESCRIPTION.key, Nothing().model_dump_json().encode())
        return None if document is None else DESCRIPTION.decode_answer(document).name

    def nobody(self, of: str) -> str:
        """Return that nobody answers, who is there, and what to do; ``of`` is whom, in words."""
        options = self.options
        there = ", ".join(sorted(name for name in self.bus.alive() if name.startswith("process/")))
        seen = f"connected are only {there}" if there else self._none_of_it()
        if there and self._identity is not None:
            seen = f"{there} are connected; perhaps the key of {self._identity.name} has been revoked"
        return (
            f"no {of} answers on {options.prefix} at {options.endpoint}: {seen}; "
            "start the system with `tandem up`, or name another robot with --site-key and --robot"
        )

    def _none_of_it(self) -> str:
        others = ", ".join(sorted(self.bus.neighbours(timeout=NEIGHBOURS_WITHIN)))
        also = f"; connected there: {others}" if others else ""
        return f"none of its processes is connected{also}"


def _no_router(options: BusOptions) -> CommandError:
    return CommandError(
        f"no router answers at {options.endpoint}: start the system with `tandem up`, "
        "or name its router with --connect",
        ExitCode.NOBODY_THERE,
    )
