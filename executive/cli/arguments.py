"""Options that several commands share. Every command that connects has the same set, by ``connects``."""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Final, get_type_hints

import typer

from tandem.executive.cli.errors import CommandError
from tandem.executive.config.addresses import is_endpoint
from tandem.executive.config.run_options import DEFAULT_ENDPOINT, DEFAULT_ROBOT, DEFAULT_SITE, BusOptions

PANEL: Final = "Connection"
"""Heading in the help under which the shared options stand."""
Connect = Annotated[
    str,
    typer.Option(
        "--connect",
        metavar="ENDPOINT",
        envvar="TANDEM_CONNECT",
        help="Endpoint of the router, e.g. tcp/127.0.0.1:7447.",
        rich_help_panel=PANEL,
    ),
]
SiteKey = Annotated[
    str,
    typer.Option(
        "--site-key", envvar="TANDEM_SITE", help="First part of every topic.", rich_help_panel=PANEL
    ),
]
Robot = Annotated[
    str,
    typer.Option("--robot", envvar="TANDEM_ROBOT", help="Second part of every topic.", rich_help_panel=PANEL),
]
Keys = Annotated[
    Path | None,
    typer.Option(
        "--keys",
        metavar="DIR",
        envvar="TANDEM_KEYS",
        help="Folder with TLS keys, for a router that uses TLS.",
        rich_help_panel=PANEL,
    ),
]
As = Annotated[
    str,
    typer.Option(
        "--as",
        metavar="NAME",
        envvar="TANDEM_AS",
        help="Name of the key to use. Optional if the folder holds only one.",
        rich_help_panel=PANEL,
    ),
]
OwnEndpoint = Annotated[
    str,
    typer.Option("--connect", metavar="ENDPOINT", help="Endpoint that this run's router listens on."),
]
"""Of a command that runs a system of its own. No environment variable sets it: TANDEM_CONNECT names a robot
at work."""
OwnSite = Annotated[str, typer.Option("--site-key", help="First part of every topic in this run.")]
OwnRobot = Annotated[str, typer.Option("--robot", help="Second part of every topic in this run.")]
Output = Annotated[
    Path | None, typer.Option("--output", "-o", help="Write to this file instead of standard output.")
]
Json = Annotated[
    bool, typer.Option("--json", help="Print JSON instead; docs/json.md has the shape of each command.")
]
SiteFile = Annotated[str, typer.Option("--site", metavar="NAME|FILE", help="Site to use: a name or a file.")]
OtherSite = Annotated[
    str,
    typer.Option("--site", metavar="NAME|FILE", help="Site to use instead of the scenario's."),
]


HELPS: Final = ("-h", "--help")
TLS: Final = "tls/"
"""How an endpoint with TLS begins."""
_PART: Final = re.compile(r"[A-Za-z0-9_.-]+")


def connects(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the options that say where the robot is; it receives them, checked, as ``bus``.

    Args:
        command: takes a keyword ``bus: BusOptions``, which no option of its own stands for.
    """

    @functools.wraps(command)
    def connecting(*given: object, **named: object) -> None:
        shared = {name: named.pop(name) for name in _SHARED}
        command(*given, **named, bus=_bus(**shared))

    hints = get_type_hints(command, include_extras=True)
    own = [
        each.replace(annotation=hints[each.name])
        for each in inspect.signature(command).parameters.values()
        if each.name != "bus"
    ]
    parameters = [*own, *shared_parameters()]
    give_parameters(connecting, parameters)
    return connecting


def give_parameters(command: Callable[..., None], parameters: Sequence[inspect.Parameter]) -> None:
    """Have typer see these parameters of a function, whatever it declares."""
    command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    command.__annotations__ = {each.name: each.annotation for each in parameters}


def shared_parameters() -> list[inspect.Parameter]:
    """Return the shared options as a function's parameters."""
    return [
        inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
        for name, (annotation, default) in _SHARED.items()
    ]


_SHARED: Final[dict[str, tuple[object, object]]] = {
    "connect": (Connect, DEFAULT_ENDPOINT),
    "site_key": (SiteKey, DEFAULT_SITE),
    "robot": (Robot, DEFAULT_ROBOT),
    "keys": (Keys, None),
    "holder": (As, ""),
}


def shared_options(words: Sequence[str], defaults: Mapping[str, object] | None = None) -> BusOptions:
    """Return where the robot is, out of the words of a command whose own options are not known yet.

    Args:
        words: of the command.
        defaults: of the project, by parameter.

    Raises:
        CommandError: as ``bus_options``.
    """

    def where(**_shared: object) -> None:
        """Take the shared options, and any others."""

    give_parameters(where, shared_parameters())
    app = typer.Typer(add_completion=False)
    app.command(context_settings={"ignore_unknown_options": True, "allow_extra_args": True})(where)
    context = typer.main.get_command(app).make_context(
        "where",
        [each for each in words if each not in HELPS],
        help_option_names=[],
        default_map=dict(defaults or {}),
    )
    return _bus(**{name: context.params[name] for name in _SHARED})


def of_context(params: Mapping[str, object]) -> BusOptions:
    """Return where the robot is, out of a context's parameters; what was not given is the default.

    Raises:
        CommandError: as ``bus_options``.
    """
    given = {name: params.get(name) for name in _SHARED}
    return _bus(**{name: _SHARED[name][1] if value is None else value for name, value in given.items()})


def _bus(*, connect: object, site_key: object, robot: object, keys: object, holder: object) -> BusOptions:
    folder = keys if isinstance(keys, Path) else None
    return bus_options(str(connect), str(site_key), str(robot), folder, str(holder))


def bus_options(
    connect: str, site_key: str, robot: str, keys: Path | None = None, holder: str = ""
) -> BusOptions:
    """Return them as one, checked.

    Raises:
        CommandError: for an endpoint that is none, for what is no part of a key, and for keys that don't fit.
    """
    if not is_endpoint(connect):
        raise CommandError(f"--connect: expected an endpoint such as {DEFAULT_ENDPOINT}; found {connect!r}")
    for option, value in (("--site-key", site_key), ("--robot", robot)):
        if _PART.fullmatch(value) is None:
            raise CommandError(
                f"{option}: expected one part of a topic: letters, digits, - _ . only; found {value!r}"
            )
    if holder and keys is None:
        raise CommandError("--as needs --keys, the folder that holds the key")
    if keys is not None and not connect.startswith(TLS):
        if connect != DEFAULT_ENDPOINT:
            raise CommandError(f"--keys needs an endpoint {TLS}HOST:PORT; found {connect!r}")
        connect = connect.replace("tcp/", TLS)
    if keys is None and connect.startswith(TLS):
        raise CommandError(f"--connect {connect}: TLS needs keys; give their folder with --keys")
    return BusOptions(endpoint=connect, site=site_key, robot=robot, keys=keys, holder=holder)
