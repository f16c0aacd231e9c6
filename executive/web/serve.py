"""The page's process: a web server on this host, until it is told to end."""

from __future__ import annotations

import asyncio
import gc
import socket
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import uvicorn
from starlette.types import ASGIApp

from tandem.executive.web.app import NO_PAGES, Pages, application
from tandem.executive.web.by_port import ByPort
from tandem.executive.web.options import AddressError, Secure, WebOptions, shown_at
from tandem.executive.web.robot import Robot
from tandem.executive.web.sessions import Sessions

LARGEST: Final = 64 * 1024
"""Bytes of what a page may say at once."""
LOOK_EVERY: Final = 0.2
"""Host seconds after which it is looked whether to end."""
BACKLOG: Final = 64
"""Connections that may wait to be accepted: two for each of the viewers there may be (``viewers.MOST``). With
fewer a page that loads while others do may have to try again."""


@dataclass(frozen=True)
class Listening:
    """A socket that listens, and the page's address."""

    socket: socket.socket
    address: str


@dataclass(frozen=True)
class Shown:
    """A robot, and where its page is served."""

    robot: Robot
    listening: Listening


def listen(options: WebOptions) -> Listening:
    """Return a listening socket.

    Raises:
        AddressError: when nothing can listen there.
    """
    family = socket.AF_INET6 if ":" in options.host else socket.AF_INET
    made = socket.socket(family, socket.SOCK_STREAM)
    made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        made.bind((options.host, options.port))
        made.listen(BACKLOG)
    except OSError as error:
        made.close()
        raise AddressError(
            f"the page can't be served at {options.host}:{options.port}: {error.strerror or error}; "
            "choose another port, or 0 for any that is free"
        ) from error
    return Listening(made, shown_at(options.host, made.getsockname()[1]))


def serve(shown: Sequence[Shown], secure: Secure | None = None, pages: Pages = NO_PAGES) -> None:
    """Serve a page for each robot until Ctrl-C or SIGTERM.

    Args:
        shown: whose pages they are, and where; with ``secure`` one.
        secure: over TLS, to who has logged in; None: on this host, to everybody.
        pages: addresses of the pages of robots that are not among them, by robot.
    """
    server = _made(shown, secure, pages)
    _set_aside(server)
    server.run(sockets=[each.listening.socket for each in shown])


def _set_aside(server: uvicorn.Server) -> None:
    """Load all that the server needs, and have no collection of garbage look at it again: one took 50 ms."""
    server.config.load()
    gc.collect()
    gc.freeze()


def _made(shown: Sequence[Shown], secure: Secure | None, pages: Pages = NO_PAGES) -> uvicorn.Server:
    sessions = None if secure is None else Sessions(secure.keys, secure.origin)
    every = {**pages, **{each.robot.options.robot: each.listening.address for each in shown}}
    apps = {}
    for each in shown:
        own = each.robot.options.robot
        others = {name: address for name, address in every.items() if name != own}
        port = each.listening.socket.getsockname()[1]
        apps[port] = application(each.robot, sessions=sessions, pages=others)
    return _server(ByPort(apps), secure)


def serve_until(
    shown: Sequence[Shown],
    stopped: Callable[[], bool],
    turn: Callable[[], None],
    secure: Secure | None = None,
    *,
    alone: bool = False,
) -> None:
    """Serve a page for each robot as a process of the first.

    Args:
        shown: whose pages they are, and where.
        stopped: says when to end.
        turn: called a few times a second, as long as the loop goes on.
        secure: over TLS, to who has logged in.
        alone: the process does nothing else.
    """
    server = _made(shown, secure)
    if alone:
        _set_aside(server)
    sockets = [each.listening.socket for each in shown]
    asyncio.run(_serving(server, sockets, stopped, turn))


async def _serving(
    server: uvicorn.Server,
    sockets: list[socket.socket],
    stopped: Callable[[], bool],
    turn: Callable[[], None],
) -> None:
    async with asyncio.TaskGroup() as group:
        serving = group.create_task(server._serve(sockets))  # noqa: SLF001 - leaves signals to us
        while not stopped() and not serving.done():
            turn()
            await asyncio.sleep(LOOK_EVERY)
        server.should_exit = True


def _server(app: ASGIApp, secure: Secure | None = None) -> uvicorn.Server:
    return uvicorn.Server(
        uvicorn.Config(
            app,
            log_config=None,
            access_log=False,
            ws="websockets-sansio",
            ws_max_size=LARGEST,
            ws_per_message_deflate=False,  # it never leaves this host
            ws_ping_interval=10.0,
            ws_ping_timeout=20.0,
            server_header=False,
            proxy_headers=False,  # whoever reaches the port could name another address in them
            ssl_certfile=None if secure is None else secure.certificate,
            ssl_keyfile=None if secure is None else secure.key,
            timeout_graceful_shutdown=1,
        )
    )
