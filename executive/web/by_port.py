"""Several pages of one process: each robot's has its own port, so that nothing of one reaches another."""

from __future__ import annotations

from collections.abc import AsyncIterator, Mapping
from contextlib import AsyncExitStack, asynccontextmanager

from starlette.applications import Starlette
from starlette.types import Receive, Scope, Send


class ByPort:
    """An ASGI application that passes on what comes to the application of the port to which it came.

    Args:
        apps: by port; they begin and end together.
    """

    def __init__(self, apps: Mapping[int, Starlette]) -> None:
        self._apps = apps

        @asynccontextmanager
        async def living(_: Starlette) -> AsyncIterator[None]:
            async with AsyncExitStack() as stack:
                for app in apps.values():
                    await stack.enter_async_context(app.router.lifespan_context(app))
                yield

        self._life = Starlette(lifespan=living)

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass it on: the port is that of the socket, whatever host and port are named in the headers."""
        app = self._life if scope["type"] == "lifespan" else self._apps[scope["server"][1]]
        await app(scope, receive, send)
