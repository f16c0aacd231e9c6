"""``tandem web``: the page, beside a robot that runs."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import connects
from tandem.executive.cli.commands.stop_commands import person
from tandem.executive.cli.errors import CommandError
from tandem.executive.config.extras import WEB, words_on
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.executive.web.options import Secure
    from tandem.executive.web.robot import Robot

Address = Annotated[
    str,
    typer.Option(
        "--at",
        metavar="HOST:PORT",
        help="Address of the page. Beyond this host it takes --keys. Port 0: any that is free.",
    ),
]


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("web")(connects(web))


Record = Annotated[
    Path | None,
    typer.Option("--record", metavar="FILE", help="Show this record instead of a robot."),
]


Host = Annotated[
    str,
    typer.Option("--name", metavar="HOST", help="Name by which browsers reach it. Default: that of --at."),
]
Certificate = Annotated[
    Path | None,
    typer.Option(
        "--certificate", metavar="FILE", help="TLS certificate (PEM). Default: the router's in --keys."
    ),
]
PrivateKey = Annotated[
    Path | None, typer.Option("--private-key", metavar="FILE", help="Key of --certificate (PEM).")
]

Pages = Annotated[
    list[str] | None,
    typer.Option(
        "--page",
        metavar="ROBOT=ADDRESS",
        help="Address of another robot's page, for a link to it; repeat it for several.",
    ),
]

Also = Annotated[
    list[str] | None,
    typer.Option(
        "--also",
        metavar="ROBOT",
        help="Another robot of the site, whose page is served at the next port; repeat it for several.",
    ),
]


def web(
    *,
    at: Address = "127.0.0.1:8447",
    record: Record = None,
    name: Host = "",
    certificate: Certificate = None,
    private_key: PrivateKey = None,
    page: Pages = None,
    also: Also = None,
    bus: BusOptions,
) -> None:
    """Serve the page: the robot, its tree, its tasks and the stop in a browser, until Ctrl-C."""
    if record is not None:
        show_record(record, at)
        return
    _require_extra("tandem web")
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415 - as `--help` is quick
    from tandem.executive.web.options import (  # noqa: PLC0415
        AddressError,
        WebOptions,
        addresses_of,
        checked_address,
        checked_pages,
        is_loopback,
    )
    from tandem.executive.web.serve import Shown, listen, serve  # noqa: PLC0415

    try:
        pages = checked_pages(page or ())
    except AddressError as error:
        raise CommandError(f"--page: {error}") from error
    try:
        host, port = checked_address(at, secure=bus.keys is not None)
        secure, places = None, {bus.robot: (host, port)}
        if not is_loopback(host):
            if also:
                raise CommandError(
                    "--also: beyond this host one page has one address, for which its log-ins are; run "
                    "`tandem web` once for each robot, and name the other's address with --page"
                )
            secure = _secured(bus, name or host, port, certificate, private_key)
        else:
            places = addresses_of(at, tuple(dict.fromkeys((bus.robot, *(also or ())))))
        with Connection(bus) as connection:  # says who is not there, or whose key is not
            named = connection.options
        shown = [
            Shown(_robot(options), listen(WebOptions(options, *place)))
            for options, place in ((replace(named, robot=robot), place) for robot, place in places.items())
        ]
    except AddressError as error:
        raise CommandError(f"--at: {error}") from error
    for each in shown:
        address = each.listening.address if secure is None else f"{secure.origin}/"
        typer.echo(f"the page of {each.robot.options.prefix} is at {address}")
    typer.echo("press Ctrl-C to stop")
    if secure is not None:
        typer.echo(f"a log-in: tandem keys link NAME --page {secure.origin}")
    serve(shown, secure, pages)


def _require_extra(what: str) -> None:
    lacks = words_on(WEB, what)
    if lacks:
        raise CommandError(lacks)


def _secured(
    bus: BusOptions, name: str, port: int, certificate: Path | None, private_key: Path | None
) -> Secure:
    from tandem.executive.security.authority import hosts_of  # noqa: PLC0415 - loads a library
    from tandem.executive.security.holders import KeysError, read_holders  # noqa: PLC0415
    from tandem.executive.security.identity import robot_in  # noqa: PLC0415
    from tandem.executive.web.options import AddressError, Secure  # noqa: PLC0415

    assert bus.keys is not None
    if name in {"0.0.0.0", "::"}:  # noqa: S104 - compared, not bound
        raise AddressError(
            f"{name} is no address to open; say with --name by which name browsers reach the page"
        )
    if port == 0:
        raise AddressError("beyond this host the page needs a port that is known before; found 0")
    if (certificate is None) is not (private_key is None):
        raise AddressError("expected --certificate and --private-key together")
    try:
        read_holders(bus.keys)
        if certificate is None or private_key is None:
            files = robot_in(bus.keys).part("router")
            certificate, private_key = files.certificate, files.key
            known = sorted(hosts_of(certificate))
            if name not in known:
                raise AddressError(
                    f"{certificate} is for {', '.join(known)}, and not for {name}; make one with "
                    f"`tandem keys new --role robot NAME --host {name}`, or give --certificate"
                )
    except KeysError as error:
        raise CommandError(str(error)) from error
    for file in (certificate, private_key):
        if not file.is_file():
            raise AddressError(f"{file}: no such file")
    shown = f"[{name}]" if ":" in name else name
    return Secure(f"https://{shown}:{port}", certificate, private_key, bus.keys)


def show_record(record: Path, at: str, *, option: str = "--at") -> None:
    """Serve the page over a record, until Ctrl-C; ``option``: what says where."""
    _require_extra("the page over a record")
    from tandem.executive.records.recording import open_recording  # noqa: PLC0415 - as `--help` is quick
    from tandem.executive.web.options import AddressError, WebOptions, checked_address  # noqa: PLC0415
    from tandem.executive.web.replay import Replay  # noqa: PLC0415
    from tandem.executive.web.serve import Shown, listen, serve  # noqa: PLC0415

    replay = Replay(open_recording(record))
    try:
        listening = listen(WebOptions(replay.options, *checked_address(at)))
    except AddressError as error:
        raise CommandError(f"{option}: {error}") from error
    typer.echo(f"{record} is shown at {listening.address}\npress Ctrl-C to stop")
    serve([Shown(replay, listening)])


def _robot(bus: BusOptions) -> Robot:
    from tandem.executive.security.identity import Identity  # noqa: PLC0415
    from tandem.executive.web.robot import RobotOnZenoh, Who  # noqa: PLC0415

    if bus.keys is None:
        return RobotOnZenoh(bus, Who(person(bus)), None)
    identity = Identity(bus.keys, bus.holder)
    who = Who(identity.name, identity.role(), identity.rights())
    return RobotOnZenoh(bus, who, identity)
