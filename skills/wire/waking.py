"""Wakes a program that lives in an asyncio loop, where ``Waker`` would block it."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from tandem.skills.wire.zenoh_ends import Waker


class LoopWaker(Waker):
    """A ``Waker`` whose wait is awaited; any number of coroutines may wait at once.

    Args:
        loop: where they wait.
    """

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        super().__init__()
        self._loop, self._rung = loop, asyncio.Event()

    def wake(self) -> None:
        """Let all waits return; may be called from any thread."""
        super().wake()
        with suppress(RuntimeError):  # a loop that has been closed has nobody left to wake
            self._loop.call_soon_threadsafe(self._ring)

    async def rung(self, timeout: float) -> None:  # noqa: ASYNC109 - the end of the time is no error here
        """Return when woken, at most after ``timeout`` seconds."""
        with suppress(TimeoutError):
            async with asyncio.timeout(timeout):
                await self._rung.wait()

    def _ring(self) -> None:
        # Each ringing has an event of its own: nobody can clear what another has not seen yet.
        rung, self._rung = self._rung, asyncio.Event()
        rung.set()
