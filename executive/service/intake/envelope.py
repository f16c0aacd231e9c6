"""What every request may say beside its kind's own fields: when, how urgent, what a restart means to it."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import Field

from tandem.skills.ports.message import PLAIN_TEXT, Message
from tandem.skills.ports.utc import Utc

MOST_LABELS: Final = 16
"""Of one request, chosen: each is told with every status of its task."""
Word = Annotated[str, Field(max_length=64, pattern=PLAIN_TEXT)]


class Envelope(Message):
    """Fields of a request that the executive reads, whatever its kind."""

    priority: Annotated[
        int, Field(ge=-100, le=100, description="the higher one starts first; of equals, the older one")
    ] = 0
    not_before: Annotated[
        Utc | None, Field(description="earliest start, in ISO 8601 with a zone or UTC seconds")
    ] = None
    expires: Annotated[Utc | None, Field(description="latest start, likewise; EXPIRED after that")] = None
    on_restart: Annotated[
        Literal["resume", "ask", "interrupt"] | None,
        Field(description="what to do if the executive ends while it runs; default: as the service is set"),
    ] = None
    test_run: Annotated[bool, Field(description="whether nodes of the tree may be forced")] = False
    labels: Annotated[
        dict[Word, Word],
        Field(
            max_length=MOST_LABELS,
            description="words of the client's own, kept with the request",
        ),
    ] = Field(default_factory=dict)
    retry_of: Annotated[Word, Field(description="id of the task that this request repeats")] = ""


FIELDS: Final = frozenset(Envelope.model_fields)
