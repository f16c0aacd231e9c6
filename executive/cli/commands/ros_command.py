"""``tandem ros``: a robot out of ROS 2 topics, as the hardware of this robot's keys."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Annotated

import typer

from tandem.executive.cli.arguments import connects
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.logs import LogOptions
from tandem.executive.config.addresses import is_endpoint
from tandem.executive.config.extras import ROS, words_on
from tandem.executive.config.run_options import BusOptions


def add_to(app: typer.Typer) -> None:
    """Add the command."""
    app.command("ros")(connects(ros))


def ros(
    context: typer.Context,
    *,
    map_file: Annotated[
        Path, typer.Option("--map", metavar="FILE", help="YAML file that maps topics to parts of the robot.")
    ],
    router: Annotated[
        str,
        typer.Option(
            "--ros-connect",
            metavar="ENDPOINT",
            help="Endpoint of the router that ROS uses (rmw_zenohd). Default: the same as --connect.",
        ),
    ] = "",
    check: Annotated[
        bool, typer.Option("--check", help="Check the file and print what it maps; connect nowhere.")
    ] = False,
    bus: BusOptions,
) -> None:
    """Drive a ROS 2 robot over rmw_zenoh, as this robot's hardware, until Ctrl-C."""
    if lacks := words_on(ROS, "tandem ros"):
        raise CommandError(lacks)
    if router and not is_endpoint(router):
        raise CommandError(
            f"--ros-connect: expected an endpoint such as tcp/127.0.0.1:7447; found {router!r}"
        )
    from tandem.executive.system.roles.ros import read_map  # noqa: PLC0415
    from tandem.skills.ros.mapping import described  # noqa: PLC0415

    made, robot = read_map(map_file)
    lines = described(made, robot)
    typer.echo("\n".join(lines))
    if not check:
        _play(context.find_object(LogOptions) or LogOptions(), map_file, router, bus)


def _play(logs: LogOptions, map_file: Path, router: str, bus: BusOptions) -> None:
    import logging  # noqa: PLC0415

    from tandem.executive.cli.opening import owner_of  # noqa: PLC0415
    from tandem.executive.config.process_settings import RefusalError, WorkerSettings  # noqa: PLC0415
    from tandem.executive.system.playing import play  # noqa: PLC0415
    from tandem.executive.system.roles.ros import MAP, ROUTER  # noqa: PLC0415
    from tandem.executive.system.worker import SWITCH_INTERVAL, Ending  # noqa: PLC0415
    from tandem.executive.telemetry.logs import formatter  # noqa: PLC0415
    from tandem.skills.wire.zenoh_bus import BusError  # noqa: PLC0415

    if bus.keys is not None and not router:
        raise CommandError(
            f"{bus.endpoint}: with keys this router lets no ROS through; "
            "give ROS a router of its own, with --ros-connect tcp/HOST:PORT"
        )
    bus = owner_of(bus)
    settings = WorkerSettings(
        role="ros",
        arguments={MAP: str(map_file.absolute()), ROUTER: router},
        endpoint=bus.endpoint,
        prefix=bus.prefix,
        site="",
        verbose=logs.verbose,
        keys=None if bus.keys is None else str(bus.keys),
        holder=bus.holder,
    )
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(formatter(logs.format, settings.called))
    logging.basicConfig(level=logging.DEBUG if logs.verbose else logging.INFO, handlers=[handler])
    ending = Ending(parent=os.getppid())
    ending.listen()
    sys.setswitchinterval(SWITCH_INTERVAL)  # as any process of the system: a busy loop must hear
    typer.echo(f"{bus.prefix} at {bus.endpoint}: press Ctrl-C to stop")
    try:
        play(settings, ending, router_within=0.0)  # somebody waits for the answer: one try
    except BusError as error:
        raise CommandError(str(error), ExitCode.NOBODY_THERE) from error
    except RefusalError as error:
        raise CommandError(str(error), ExitCode.REFUSED) from error
