"""Times of day: seconds since 1970 on the wire, ISO 8601 for people, and both where a person may write one.

A message is dumped with seconds; with ``context=ISO`` its times of day are in ISO 8601. Either is read.
"""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Annotated, Final

from pydantic import (
    BeforeValidator,
    Field,
    SerializationInfo,
    WithJsonSchema,
    WrapSerializer,
)

ISO: Final = "iso"
"""Context in which a message is dumped for people."""
LATEST: Final = 1e11
"""Seconds: beyond the year 5000 nobody means a time of day."""
EXPECTED: Final = "UTC seconds, or ISO 8601 with a zone such as 2026-11-24T08:30:00Z"


def iso(utc: float) -> str:
    """Return UTC seconds as ISO 8601, to the millisecond where they are not whole; beyond 9999 the number."""
    try:
        moment = datetime.fromtimestamp(round(utc, 3), UTC)
    except (ValueError, OverflowError, OSError):
        return f"{utc:.0f} s"
    precision = "milliseconds" if moment.microsecond else "seconds"
    return moment.isoformat(timespec=precision).replace("+00:00", "Z")


def seconds_of(text: str) -> float:
    """Return ISO 8601 with a zone as UTC seconds.

    Raises:
        ValueError: for anything else.
    """
    try:
        moment = datetime.fromisoformat(text)
    except ValueError:
        raise ValueError(EXPECTED) from None
    if moment.tzinfo is None:
        raise ValueError(EXPECTED)
    return moment.timestamp()


def _read(value: object) -> object:
    return seconds_of(value) if isinstance(value, str) else value


def _read_said(value: object) -> object:
    """Read a text within the bounds of ``Utc``, told as dates to whoever wrote a date."""
    if not isinstance(value, str):
        return value
    seconds = seconds_of(value)
    if not 0.0 <= seconds <= LATEST:
        raise ValueError(f"a time from {iso(0.0)} to {iso(LATEST)}")
    return seconds


def _write(value: float, write: object, info: SerializationInfo) -> float | str:  # noqa: ARG001
    return iso(value) if info.context == ISO else value


UtcSeconds = Annotated[float, BeforeValidator(_read), WrapSerializer(_write)]
"""A time of day that we tell."""
Utc = Annotated[
    float,
    BeforeValidator(_read_said),
    Field(ge=0.0, le=LATEST),
    WrapSerializer(_write),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "number", "minimum": 0.0, "maximum": LATEST},
                {"type": "string", "format": "date-time"},
            ]
        }
    ),
]
"""A time of day that a client says."""
