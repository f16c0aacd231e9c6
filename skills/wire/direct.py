"""Callbacks of zenoh that run in the thread that receives.

By default the Python binding gives each subscriber, queryable and query a thread of its own: the executive
has 40, and each message wakes one of them before it wakes the loop. Ours only enqueue, so the thread that
receives does it itself.

That thread is none of Python's. For each call Python would make a thread state and throw it away afterwards,
with 16 KB of stack mapped and unmapped: much of what receiving a message costs. So the first call in a
thread keeps its state: it asks for the interpreter (``PyGILState_Ensure``) once more than it gives it back,
and the state lives as long as the thread. zenoh's threads live as long as the process.
"""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable
from typing import Final, TypeVar

from zenoh.handlers import Callback

Item = TypeVar("Item")

_KEPT: Final = threading.local()
"""Has ``state`` in threads whose state is kept. It is part of that state, and goes with it."""


def direct(take: Callable[[Item], None], end: Callable[[], None] | None = None) -> Callback[Item]:
    """Return a callback without a thread of its own.

    Args:
        take: called with each message; it must return at once, and never wait for the loop's thread.
        end: called when no more will come.
    """

    def taken(item: Item) -> None:
        if not hasattr(_KEPT, "state"):
            _KEPT.state = ctypes.pythonapi.PyGILState_Ensure()
        take(item)

    return Callback(taken, end, indirect=False)
