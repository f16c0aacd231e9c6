"""Callbacks of zenoh that run in the thread that receives.

By default the Python binding gives each subscriber, queryable and query a thread of its own: the executive
has 40, and each message wakes one of them before it wakes the loop. Ours only enqueue, so the thread that
receives does it itself.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from zenoh.handlers import Callback

Item = TypeVar("Item")


def direct(take: Callable[[Item], None], end: Callable[[], None] | None = None) -> Callback[Item]:
    """Return a callback without a thread of its own.

    Args:
        take: called with each message; it must return at once, and never wait for the loop's thread.
        end: called when no more will come.
    """
    called: Callable[[Item], Any] = take
    return Callback(called, end, indirect=False)
