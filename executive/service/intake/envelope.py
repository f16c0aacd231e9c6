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
    not_before: Annotated[Utc | None, Field(description="earliest start, UTC seconds")] = None
    expires: Annotated[Utc | None, Field(description="latest start, UTC seconds; EXPIRED after that")] = None
    on_restart: Annotated[
        Literal["resume", "ask", "interrupt"] | None,
        Field(description="what to do if the executive ends while it runs; default: as the service is set"),
    ] = None
    test_run: Annotated[bool, Field(description="whether nodes of the tree may be forced")] = False


FIELDS: Final = frozenset(Envelope.model_fields)
