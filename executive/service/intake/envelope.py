"""What every request may say beside its kind's own fields: when, how urgent, what a restart means to it."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import Field

from tandem.skills.ports.message import Message

Utc = Annotated[float, Field(ge=0.0, le=1e11)]
"""Seconds since 1970."""


class Envelope(Message):
    """Fields of a request that the executive reads, whatever its kind."""

    priority: Annotated[int, Field(ge=-100, le=100)] = 0
    """The higher one is taken first; among equals the one that came first."""
    not_before: Annotated[Utc | None, Field(description="UTC seconds of the earliest start")] = None
    expires: Annotated[Utc | None, Field(description="UTC seconds of the latest start; EXPIRED after")] = None
    on_restart: Annotated[
        Literal["resume", "ask", "interrupt"] | None,
        Field(description="if it was under way when the executive ended; as the service is set unless given"),
    ] = None
    test_run: Annotated[bool, Field(description="whether nodes of its tree may be forced")] = False


FIELDS: Final = frozenset(Envelope.model_fields)
