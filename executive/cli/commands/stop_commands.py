"""``tandem stop`` and ``tandem release``: the hardware's stop, which needs no executive."""

from __future__ import annotations

import getpass
import socket
from typing import TYPE_CHECKING, Annotated, TypeVar

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.skills.ports.hardware import StopState
    from tandem.skills.ports.keys import Service
    from tandem.skills.ports.message import Message

M = TypeVar("M", bound="Message")
By = Annotated[str, typer.Option("--by", metavar="NAME", help="Your name. Default: user@host.")]
Reason = Annotated[
    str,
    typer.Option("--reason", metavar="TEXT", help="Reason, shown to everyone who finds the robot stopped."),
]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("stop")(connects(stop))
    app.command("release")(connects(release))


def stop(*, reason: Reason = "tandem stop", by: By = "", as_json: Json = False, bus: BusOptions) -> None:
    """Stop the robot at once until `tandem release`. Works without an executive."""
    from tandem.skills.ports.keys import STOP  # noqa: PLC0415

    state = _ask(bus, STOP, by, reason)
    if not state.stopped:
        raise CommandError("the hardware answered, but the stop is NOT set", ExitCode.TASK_FAILED)
    _tell(
        f"stopped: {_told(state)}; run `tandem release` to let the robot move again", state, as_json=as_json
    )


def release(
    *, reason: Reason = "tandem release", by: By = "", as_json: Json = False, bus: BusOptions
) -> None:
    """Release the stop. The robot may move again, and a waiting task continues."""
    from tandem.skills.ports.keys import STOP_RELEASE  # noqa: PLC0415

    state = _ask(bus, STOP_RELEASE, by, reason)
    if state.stopped:
        raise CommandError(f"the stop is still set: {_told(state)}", ExitCode.TASK_FAILED)
    _tell("released: the robot may move again", state, as_json=as_json)


def _tell(words: str, state: StopState, *, as_json: bool) -> None:
    if as_json:
        from tandem.executive.cli.shapes import print_json  # noqa: PLC0415

        print_json(state)
    else:
        typer.echo(words)


def _ask(bus: BusOptions, service: Service[M, StopState], by: str, reason: str) -> StopState:
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415

    with Connection(bus) as connection:
        words = {"by": by or person(connection.options), "reason": reason}
        fields = {name: words[name] for name in service.asked.model_fields if name in words}
        return connection.ask(service, service.asked.model_validate(fields), of="hardware")


def person(bus: BusOptions) -> str:
    """Return who asks, in words for people: the holder of the key, or the user and the host."""
    if bus.holder:
        return bus.holder
    try:
        user = getpass.getuser()
    except (KeyError, OSError):  # a user without a name, as in a container
        user = "somebody"
    return f"{user}@{socket.gethostname()}"


def _told(state: StopState) -> str:
    who = f"by {state.by or 'somebody'}"
    return f"{who}: {state.reason}" if state.reason else who
