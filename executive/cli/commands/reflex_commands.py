"""``tandem reflex``: which reflexes a robot has, what has its resources; switch a reflex on or off."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Annotated, Final

import typer
from pydantic import TypeAdapter, ValidationError

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.commands.stop_commands import By, person
from tandem.executive.cli.confirming import confirm
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from tandem.executive.cli.connection import Connection
    from tandem.executive.cli.shapes import Reflexes
    from tandem.skills.ports.reflex import PipelineState, ReflexState

LISTENS: Final = 1.3
"""Seconds of the host after the first word: each reflex and each resource tells once a robot second."""
SILENCE: Final = 5.0
"""Seconds of the host without a word after which nobody is there."""
Yes = Annotated[
    bool, typer.Option("--yes", help="Switch it off without a question, also if it protects somebody.")
]
Name = Annotated[str, typer.Argument(metavar="REFLEX", help="Its name; `tandem reflex list` has them.")]


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(
        help="List a robot's reflexes, and switch them on and off.",
        no_args_is_help=True,
    )
    group.command("list")(connects(list_reflexes))
    group.command("on")(connects(switch_on))
    group.command("off")(connects(switch_off))
    app.add_typer(group, name="reflex")


def list_reflexes(*, as_json: Json = False, bus: BusOptions) -> None:
    """List the robot's reflexes, highest rank first, and what has its resources now."""
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.cli.shapes import print_json  # noqa: PLC0415

    with Connection(bus) as connection:
        found = _hear(connection)
        if not found.reflexes and not found.pipelines:
            raise CommandError(connection.nobody("reflex or resource"), ExitCode.NOBODY_THERE)
    if as_json:
        print_json(found)
        return
    for pipeline in found.pipelines:
        typer.echo(has(pipeline))
    for reflex in found.reflexes:
        typer.echo(line(reflex))


def switch_on(name: Name, *, by: By = "", as_json: Json = False, bus: BusOptions) -> None:
    """Switch a reflex on. It stays on until its process starts anew: then it is as declared."""
    _switch(name, bus, by, on=True, as_json=as_json)


def switch_off(name: Name, *, yes: Yes = False, by: By = "", as_json: Json = False, bus: BusOptions) -> None:
    """Switch a reflex off: the robot no longer does what it is for. Ends when its process starts anew."""
    _switch(name, bus, by, on=False, as_json=as_json, asks=not yes)


def has(pipeline: PipelineState) -> str:
    """Return who has a resource, in a line."""
    doing = f" ({', '.join(pipeline.doing)})" if pipeline.doing else ""
    if pipeline.reflex:
        why = "" if pipeline.why is None else f": {pipeline.why.message}"
        return f"{pipeline.resource}: reflex {pipeline.reflex}{doing}{why}"
    return f"{pipeline.resource}: {pipeline.holder or 'free'}{doing}"


def line(reflex: ReflexState) -> str:
    """Return a reflex in a line."""
    state = ("on" if reflex.on else "off") + (f" by {reflex.by}" if reflex.by else "")
    fired = f"fired {reflex.fired} time{'' if reflex.fired == 1 else 's'}"
    takes = ", ".join(reflex.resources)
    return f"  {reflex.reflex}  {state}; rank {reflex.rank}; takes {takes}; {fired}; {reflex.about}"


def _ask_first(connection: Connection, name: str) -> None:
    """Ask whether to switch off what protects somebody, with the page's words."""
    from tandem.skills.ports.hearing import Heard  # noqa: PLC0415
    from tandem.skills.ports.reflex import before_off, reflex_state  # noqa: PLC0415

    topic = reflex_state(name)
    states = Heard(connection.bus, topic.key, topic.decode)
    end = time.monotonic() + SILENCE
    while not (told := states.take()) and (left := end - time.monotonic()) > 0.0:
        connection.bus.waker.wait(left)
    states.close()
    if not told:  # whom it protects is not known
        raise CommandError(
            f"{connection.nobody(_named(name))}; --yes switches it off unheard", ExitCode.NOBODY_THERE
        )
    if words := before_off(told[-1][1]):
        confirm(words, f"Switch {name} off all the same?")


def _named(name: str) -> str:
    return f"reflex {name!r} (`tandem reflex list`)"


def _hear(connection: Connection) -> Reflexes:
    from tandem.executive.cli.shapes import Reflexes  # noqa: PLC0415
    from tandem.skills.ports.hearing import Heard  # noqa: PLC0415
    from tandem.skills.ports.reflex import (  # noqa: PLC0415
        PipelineState,
        ReflexState,
        pipeline_state,
        reflex_state,
    )

    bus = connection.bus
    states = Heard(bus, reflex_state("*").key, ReflexState.model_validate_json)
    pipelines = Heard(bus, pipeline_state("*").key, PipelineState.model_validate_json)
    reflexes: dict[str, ReflexState] = {}
    resources: dict[str, PipelineState] = {}
    end, heard = time.monotonic() + SILENCE, False
    while (left := end - time.monotonic()) > 0.0:
        bus.waker.wait(left)
        reflexes |= {state.reflex: state for _, state, _ in states.take()}
        resources |= {state.resource: state for _, state, _ in pipelines.take()}
        if not heard and (reflexes or resources):
            end, heard = time.monotonic() + LISTENS, True
    return Reflexes(
        pipelines=tuple(resources[name] for name in sorted(resources)),
        reflexes=tuple(sorted(reflexes.values(), key=lambda each: (-each.rank, each.reflex))),
    )


def _switch(name: str, options: BusOptions, by: str, *, on: bool, as_json: bool, asks: bool = False) -> None:
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.cli.shapes import print_json  # noqa: PLC0415
    from tandem.skills.ports.reflex import ReflexSwitch, reflex_switch  # noqa: PLC0415
    from tandem.skills.ports.reflex_setting import ReflexName  # noqa: PLC0415

    try:
        TypeAdapter(ReflexName).validate_python(name)
    except ValidationError:
        raise CommandError(
            f"no reflex is called {name!r}: expected small letters, digits and _; "
            "`tandem reflex list` has those there are"
        ) from None
    with Connection(options) as connection:
        who, service = by or person(connection.options), reflex_switch(name)
        connection.require_right(service.key)
        if asks:
            _ask_first(connection, name)
        state = connection.ask(service, ReflexSwitch(on=on, by=who), of=_named(name))
    if state.on is not on:
        raise CommandError(
            f"reflex {name} answered, but is NOT {'on' if on else 'off'}", ExitCode.TASK_FAILED
        )
    if as_json:
        print_json(state)
    else:
        typer.echo(f"reflex {name} is {'on' if on else 'off'}, by {who}")
