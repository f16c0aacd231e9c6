"""What clients may ask of a task: cancel, pause, resume, step; each answered at once: taken, or why not."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from pydantic import ValidationError

from skills.ports.bus import Bus
from skills.ports.message import Message
from skills.ports.tasks import ControlAnswer, NameTask

Take = Callable[[str], ControlAnswer]
"""Given a task's id; returns the answer."""


class Verbs:
    """The desks of the verbs.

    Args:
        bus: where clients are.
        takes: who takes each verb, by its key.
    """

    def __init__(self, bus: Bus, takes: Mapping[str, Take]) -> None:
        self._desks = [(bus.serve(key), take) for key, take in takes.items()]

    def step(self) -> None:
        """Answer all who asked."""
        for desk, take in self._desks:
            for request in desk.drain():
                request.reply(_answer(request.payload, take).model_dump_json().encode())

    def close(self) -> None:
        """Stop serving."""
        for desk, _ in self._desks:
            desk.close()


def _answer(payload: bytes, take: Take) -> Message:
    try:
        named = NameTask.model_validate_json(payload)
    except ValidationError:
        return ControlAnswer(accepted=False, reason='a document {"task": "<id>"} was expected')
    return take(named.task)
