"""Who may speak to the page's server: this page alone, opened at this server's own address.

A page from elsewhere, open in the same browser, can send requests to a loopback address. So the host that is
named must be ours (a name that was turned to 127.0.0.1 is not), what changes something must come from our own
page, and a browser is told to load nothing from elsewhere.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from tandem.executive.web.options import is_loopback

POLICY: Final = "; ".join(  # noqa: FLY002 - one a line
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "connect-src 'self'",
        "img-src 'self' data: blob:",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    )
)
HEADERS: Final[Mapping[str, str]] = MappingProxyType(
    {
        "Content-Security-Policy": POLICY,
        "X-Content-Type-Options": "nosniff",
        "Referrer-Policy": "no-referrer",
        "Cross-Origin-Opener-Policy": "same-origin",
        "Cross-Origin-Resource-Policy": "same-origin",
        "Cache-Control": "no-cache",
    }
)
LOOKS: Final = frozenset({"GET", "HEAD"})
FORBIDDEN: Final = 403
CLOSED: Final = 4403
"""Code with which a socket is closed that is not for its opener."""


class Gate:
    """An ASGI application before another.

    Args:
        app: the one behind.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Let it pass, or say why not."""
        if scope["type"] not in {"http", "websocket"}:
            await self._app(scope, receive, send)
            return
        why = refusal(scope["type"], scope.get("method", ""), Headers(scope=scope))
        if why and scope["type"] == "websocket":
            await receive()
            await send({"type": "websocket.close", "code": CLOSED, "reason": why})
        elif why:
            await JSONResponse({"error": why}, FORBIDDEN, HEADERS)(scope, receive, send)
        else:
            await self._app(scope, receive, _guarded(send))


def refusal(kind: str, method: str, headers: Headers) -> str:
    """Return why it may not pass; empty when it may.

    Args:
        kind: ``http`` or ``websocket``.
        method: of http.
        headers: as they came.
    """
    host = headers.get("host", "")
    if not is_loopback(urlsplit(f"//{host}").hostname or ""):
        return f"expected this host's own address, such as http://127.0.0.1; found {host!r}"
    if kind == "http" and method in LOOKS:
        return ""
    origin = headers.get("origin", "")
    if origin != f"http://{host}":
        return f"expected to be asked by the page at http://{host}; found {origin!r}"
    media = headers.get("content-type", "").partition(";")[0].strip()
    if kind == "http" and media != "application/json":
        return f"expected application/json; found {media!r}"
    return ""


def _guarded(send: Send) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in HEADERS.items():
                headers.setdefault(name, value)
        await send(message)

    return sending
