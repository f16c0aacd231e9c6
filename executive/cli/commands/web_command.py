"""``tandem web``: the page, beside a robot that runs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import connects
from tandem.executive.cli.commands.stop_commands import person
from tandem.executive.cli.errors import CommandError
from tandem.executive.config.extras import WEB, words_on
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.executive.web.robot import Robot

Address = Annotated[
    str,
    typer.Option(
        "--at",
        metavar="HOST:PORT",
        help="Address of the page, on this host only. Port 0: any that is free.",
    ),
]


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("web")(connects(web))


Record = Annotated[
    Path | None,
    typer.Option("--record", metavar="FILE", help="Show this record instead of a robot."),
]


def web(*, at: Address = "127.0.0.1:8447", record: Record = None, bus: BusOptions) -> None:
    """Serve the page: the robot, its tree, its tasks and the stop in a browser, until Ctrl-C."""
    lacks = words_on(WEB, "tandem web")
    if lacks:
        raise CommandError(lacks)
    if record is not None:
        show_record(record, at)
        return
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415 - as `--help` is quick
    from tandem.executive.web.options import AddressError, WebOptions, checked_address  # noqa: PLC0415
    from tandem.executive.web.serve import listen, serve  # noqa: PLC0415

    try:
        host, port = checked_address(at)
        with Connection(bus) as connection:  # says who is not there, or whose key is not
            named = connection.options
        listening = listen(WebOptions(named, host, port))
    except AddressError as error:
        raise CommandError(f"--at: {error}") from error
    typer.echo(f"the page of {named.prefix} is at {listening.address}\npress Ctrl-C to stop")
    serve(_robot(named), listening)


def show_record(record: Path, at: str) -> None:
    """Serve the page over a record, until Ctrl-C."""
    from tandem.executive.records.recording import open_recording  # noqa: PLC0415 - as `--help` is quick
    from tandem.executive.web.options import AddressError, WebOptions, checked_address  # noqa: PLC0415
    from tandem.executive.web.replay import Replay  # noqa: PLC0415
    from tandem.executive.web.serve import listen, serve  # noqa: PLC0415

    replay = Replay(open_recording(record))
    try:
        listening = listen(WebOptions(replay.options, *checked_address(at)))
    except AddressError as error:
        raise CommandError(f"--at: {error}") from error
    typer.echo(f"{record} is shown at {listening.address}\npress Ctrl-C to stop")
    serve(replay, listening)


def _robot(bus: BusOptions) -> Robot:
    from tandem.executive.security.identity import Identity  # noqa: PLC0415
    from tandem.executive.web.robot import RobotOnZenoh, Who  # noqa: PLC0415

    if bus.keys is None:
        return RobotOnZenoh(bus, Who(person(bus)), None)
    identity = Identity(bus.keys, bus.holder)
    who = Who(identity.name, identity.role(), identity.rights())
    return RobotOnZenoh(bus, who, identity)
