"""The client of an executive: ``Client`` for programs that wait, ``AsyncClient`` for an asyncio loop."""

from __future__ import annotations

from tandem.executive.client.aio import AsyncClient
from tandem.executive.client.errors import (
    ClientError,
    DeclinedError,
    NotConnectedError,
    OtherVersionError,
    RefusedError,
    RejectedError,
    TaskFailedError,
    TimedOutError,
    UnknownTaskError,
)
from tandem.executive.client.sync import Client

__all__ = [
    "AsyncClient",
    "Client",
    "ClientError",
    "DeclinedError",
    "NotConnectedError",
    "OtherVersionError",
    "RefusedError",
    "RejectedError",
    "TaskFailedError",
    "TimedOutError",
    "UnknownTaskError",
]
