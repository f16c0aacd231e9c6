"""What clients may ask of a task; each verb is answered at once: taken, or why not."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Generic, TypeVar

from pydantic import ValidationError

from skills.ports.bus import Bus, Desk
from skills.ports.keys import Service
from skills.ports.message import Message
from skills.ports.tasks import ControlAnswer

M = TypeVar("M", bound=Message)


@dataclass(frozen=True)
class Verb(Generic[M]):
    """A verb's service, and who takes it."""

    service: Service[M, ControlAnswer]
    take: Callable[[M], ControlAnswer]

    def answer(self, payload: bytes) -> ControlAnswer:
        """Read a document and take it."""
        model = self.service.asked
        try:
            asked = model.model_validate_json(payload)
        except ValidationError as error:
            fields = ", ".join(f'"{name}"' for name in model.model_fields)
            first = error.errors(include_url=False)[0]
            at = ".".join(str(part) for part in first["loc"]) or "the document"
            reason = f"a document with {fields} was expected; at {at}: {first['msg']}"
            return ControlAnswer(accepted=False, reason=reason)
        return self.take(asked)


class Verbs:
    """The desks of the verbs.

    Args:
        bus: where clients are.
        verbs: all of them.
        keep: has on disk what a verb has changed; called before it is answered.
    """

    def __init__(self, bus: Bus, verbs: Iterable[Verb[Message]], keep: Callable[[], None]) -> None:
        self._keep = keep
        self._desks: list[tuple[Desk, Verb[Message]]] = [
            (bus.serve(each.service.key), each) for each in verbs
        ]

    def step(self) -> None:
        """Answer all who asked."""
        for desk, verb in self._desks:
            for request in desk.drain():
                answer = verb.answer(request.payload)
                self._keep()
                request.reply(answer.model_dump_json().encode())

    def close(self) -> None:
        """Stop serving."""
        for desk, _ in self._desks:
            desk.close()
