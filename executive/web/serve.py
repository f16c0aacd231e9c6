"""The page's process: a web server on this host, until it is told to end."""

from __future__ import annotations

import asyncio
import gc
import socket
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import uvicorn
from starlette.types import ASGIApp

from tandem.executive.web.app import NO_PAGES, Pages, application
from tandem.executive.web.options import AddressError, Secure, WebOptions
from tandem.executive.web.robot import Robot
from tandem.executive.web.sessions import Sessions

LARGEST: Final = 64 * 1024
"""Bytes of what a page may say at once."""
LOOK_EVERY: Final = 0.2
"""Host seconds after which it is looked whether to end."""
BACKLOG: Final = 64


@dataclass(frozen=True)
class Listening:
    """A socket that listens, and the page's address."""

    socket: socket.socket
    address: str


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
    shown = f"[{options.host}]" if ":" in options.host else options.host
    return Listening(made, f"http://{shown}:{made.getsockname()[1]}/")


def serve(robot: Robot, listening: Listening, secure: Secure | None = None, pages: Pages = NO_PAGES) -> None:
    """Serve the page until Ctrl-C or SIGTERM.

    Args:
        robot: whose page it is.
        listening: where.
        secure: over TLS, to who has logged in; None: on this host, to everybody.
        pages: addresses of other robots' pages, by robot.
    """
    server = _made(robot, secure, pages)
    _set_aside(server)
    server.run(sockets=[listening.socket])


def _set_aside(server: uvicorn.Server) -> None:
    """Load all that the server needs, and have no collection of garbage look at it again: one took 50 ms."""
    server.config.load()
    gc.collect()
    gc.freeze()


def _made(robot: Robot, secure: Secure | None, pages: Pages = NO_PAGES) -> uvicorn.Server:
    sessions = None if secure is None else Sessions(secure.keys, secure.origin)
    return _server(application(robot, sessions=sessions, pages=pages), secure)


def serve_until(
    robot: Robot,
    listening: Listening,
    stopped: Callable[[], bool],
    turn: Callable[[], None],
    secure: Secure | None = None,
    *,
    alone: bool = False,
) -> None:
    """Serve the page as a process of the robot.

    Args:
        robot: whose page it is.
        listening: where.
        stopped: says when to end.
        turn: called a few times a second, as long as the loop goes on.
        secure: over TLS, to who has logged in.
        alone: the process does nothing else.
    """
    server = _made(robot, secure)
    if alone:
        _set_aside(server)
    asyncio.run(_serving(server, listening, stopped, turn))


async def _serving(
    server: uvicorn.Server, listening: Listening, stopped: Callable[[], bool], turn: Callable[[], None]
) -> None:
    async with asyncio.TaskGroup() as group:
        serving = group.create_task(server._serve([listening.socket]))  # noqa: SLF001 - leaves signals to us
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
