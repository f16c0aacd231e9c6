"""Who may speak to the page's server: this page alone, at this server's own address, for who has logged in.

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
from starlette.requests import cookie_parser
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from tandem.executive.web.options import is_loopback
from tandem.executive.web.sessions import COOKIE, Sessions

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
"""The page takes code, styles and data from its own server alone; pictures may also be made in the page, and
its empty icon is a ``data:`` address. No other page may frame it."""
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
"""Of every answer. ``no-cache`` has the browser ask again, so that a new release's page is shown at once."""
LOOKS: Final = frozenset({"GET", "HEAD"})
FORBIDDEN: Final = 403
UNKNOWN: Final = 401
STRANGE: Final = 4401
"""Code with which a socket is closed whose opener has not logged in, or whose session has ended."""
NOT_IN: Final = "you are not logged in; `tandem keys link NAME --page ADDRESS` makes a log-in"
LOGIN: Final = "/api/login"
CLOSED_TO_STRANGERS: Final = ("/api/", "/mesh/", "/live")
"""What needs a session. The page itself says nothing of the robot."""
CLOSED: Final = 4403
"""Code with which a socket is closed that is not for its opener."""


class Gate:
    """An ASGI application before another.

    Args:
        app: the one behind.
        sessions: who has logged in; None: on this host nobody logs in.
    """

    def __init__(self, app: ASGIApp, sessions: Sessions | None = None) -> None:
        self._app, self._sessions = app, sessions

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Let it pass, or say why not."""
        if scope["type"] not in {"http", "websocket"}:
            await self._app(scope, receive, send)
            return
        headers, sessions = Headers(scope=scope), self._sessions
        origin = "" if sessions is None else sessions.origin
        why = refusal(scope["type"], scope.get("method", ""), headers, origin)
        if not why and sessions is not None and scope["path"].startswith(CLOSED_TO_STRANGERS):
            who = sessions.who(cookie_of(headers), uses=scope.get("method") not in LOOKS)
            if who is None and scope["path"] != LOGIN:
                await _turn_away(scope, receive, send)
                return
            scope["who"] = who
        if why and scope["type"] == "websocket":
            await receive()
            await send({"type": "websocket.close", "code": CLOSED, "reason": why})
        elif why:
            await JSONResponse({"error": why}, FORBIDDEN, HEADERS)(scope, receive, send)
        else:
            await self._app(scope, receive, _guarded(send, secure=bool(origin)))


def cookie_of(headers: Headers) -> str:
    """Return the session's secret; empty when there is none."""
    return cookie_parser(headers.get("cookie", "")).get(COOKIE, "")


async def _turn_away(scope: Scope, receive: Receive, send: Send) -> None:
    if scope["type"] == "websocket":
        await receive()
        await send({"type": "websocket.close", "code": STRANGE, "reason": NOT_IN})
    else:
        await JSONResponse({"error": NOT_IN, "login": True}, UNKNOWN, HEADERS)(scope, receive, send)


def refusal(kind: str, method: str, headers: Headers, origin: str = "") -> str:
    """Return why it may not pass; empty when it may.

    Args:
        kind: ``http`` or ``websocket``.
        method: of http.
        headers: as they came.
        origin: of a page that is served beyond this host; empty: it is this host's own.
    """
    host = headers.get("host", "")
    if origin and host != urlsplit(origin).netloc:
        return f"expected the page's own address, {origin}; found {host!r}"
    if not origin and not is_loopback(urlsplit(f"//{host}").hostname or ""):
        return f"expected this host's own address, such as http://127.0.0.1; found {host!r}"
    if kind == "http" and method in LOOKS:
        return ""
    expected, found = origin or f"http://{host}", headers.get("origin", "")
    if found != expected:
        return f"expected to be asked by the page at {expected}; found {found!r}"
    media = headers.get("content-type", "").partition(";")[0].strip()
    if kind == "http" and media != "application/json":
        return f"expected application/json; found {media!r}"
    return ""


def _guarded(send: Send, *, secure: bool) -> Send:
    async def sending(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(scope=message)
            for name, value in HEADERS.items():
                headers.setdefault(name, value)
            if secure:
                headers["Strict-Transport-Security"] = "max-age=31536000"
        await send(message)

    return sending
