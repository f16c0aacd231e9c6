"""One viewer's socket: updates go out as they come, and at least one a second."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from typing import Final

from starlette.websockets import WebSocket, WebSocketDisconnect

from tandem.executive.web.viewers import Viewer

ENDED: Final = 4401
"""Code with which the socket of a session that has ended is closed."""
NOTHING: Final = "{}"
"""An update without news."""
ALIVE_EVERY: Final = 1.0
"""Host seconds after which something is said in any case, so that the page can tell silence from rest."""


async def serve_viewer(socket: WebSocket, viewer: Viewer, welcome: Callable[[], bool]) -> None:
    """Tell it until it leaves, or is not welcome any more."""
    telling = asyncio.create_task(_tell(socket, viewer, welcome))
    try:
        while True:
            await socket.receive_text()
    except WebSocketDisconnect:
        pass
    finally:
        telling.cancel()
        await asyncio.gather(telling, return_exceptions=True)


async def _tell(socket: WebSocket, viewer: Viewer, welcome: Callable[[], bool]) -> None:
    with suppress(WebSocketDisconnect, RuntimeError):  # starlette's words for a socket that is closed
        while True:
            try:
                text = await asyncio.wait_for(viewer.next(), ALIVE_EVERY)
            except TimeoutError:
                text = NOTHING
            if not welcome():
                await socket.close(ENDED, "the session has ended")
                return
            await socket.send_text(text)
