"""An endpoint: a service of the table of keys and the handler that answers it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Generic, TypeVar, cast

from pydantic import JsonValue

from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem

Asked = TypeVar("Asked", bound=Message)
Answered = TypeVar("Answered", bound=Message)
Problems = tuple[Problem, ...]


class Refusal(Message):
    """Why a query was not answered; sent as an error reply."""

    reason: str
    problems: tuple[Problem, ...] = ()


class AnyDocument(Message):
    """Stands for a document whose model depends on what is in it: ``Call.fields`` has it."""


@dataclass(eq=False)
class Call(Generic[Asked]):
    """One query that passed every check."""

    document: Asked
    fields: Mapping[str, JsonValue]
    """The document as it was sent."""
    key: str
    """The concrete key that is asked."""
    name: str
    """What stands in the key for the ``*`` of the endpoint's; empty without one."""
    reply: Callable[[bytes], None]
    """Answers it, at any later time."""


Reply = Message | bytes | None
"""A handler's answer; ``None`` ends the query without one, or leaves it to ``Call.reply``."""


@dataclass(frozen=True)
class Endpoint:
    """What ``skills.ports.serving`` serves. Made by ``endpoint`` or ``answering``, which check the types."""

    service: Service[Message, Message]
    take: Callable[[Call[Message]], Reply]
    refuse: Callable[[Problems], Message] | None
    unread: Callable[[], Message] | None
    keys: Callable[[], Iterable[str]]
    puts: bool
    key: str


def endpoint(
    service: Service[Asked, Answered],
    take: Callable[[Call[Asked]], Answered | bytes | None],
    *,
    refuse: Callable[[Problems], Answered] | None = None,
    unread: Callable[[], Asked] | None = None,
    keys: Callable[[], Iterable[str]] = tuple,
    puts: bool = False,
    at: str = "",
) -> Endpoint:
    """Return a service with its handler.

    Args:
        service: what is declared of it.
        take: the handler. It is called with nothing but what passed every check.
        refuse: makes the answer to a document that did not. Without it a reply model with ``accepted`` and
            ``reason`` refuses with them, and any other with a ``Refusal``.
        unread: for the one command that must not fail for its document: what an unreadable one is taken for.
        keys: at a key with a ``*``: the keys that there are now, for whoever asks with a wildcard.
        puts: take what is put on the key, too; the answer then goes nowhere.
        at: serve it at another key of the same shape, such as a named client's.
    """
    return Endpoint(
        cast("Service[Message, Message]", service),
        cast("Callable[[Call[Message]], Reply]", take),
        refuse,
        unread,
        keys,
        puts,
        at or service.key,
    )


def answering(
    service: Service[Asked, Answered], answer: Callable[[Asked], Answered | bytes | None]
) -> Endpoint:
    """Return an endpoint whose handler needs the document only."""
    return endpoint(service, lambda call: answer(call.document))
