"""``tandem hardware check``: whether a driver keeps the hardware's contract, before anything relies on it."""

from __future__ import annotations

import os
import secrets
import socket
import sys
import time
from typing import TYPE_CHECKING, Annotated

import typer

from tandem.executive.cli.arguments import Json, connects
from tandem.executive.cli.confirming import confirm
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.config.run_options import BusOptions

if TYPE_CHECKING:
    from collections.abc import Iterator

    from tandem.executive.cli.connection import Connection
    from tandem.executive.cli.shapes import ClauseFound
    from tandem.executive.conformance.bench import Bench
    from tandem.executive.conformance.clause import Clause, Finding

STEP: float = 0.01
"""Host seconds between two looks at what has come, at the most."""
WARNING: str = (
    "--moving drives the base, turns each joint by up to 3 degrees and moves the grippers. "
    "Keep 0.5 m around the robot free, hands empty, and the emergency stop within reach."
)


def add_to(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(help="Check a robot's driver.", no_args_is_help=True)
    group.command("check")(connects(check))
    app.add_typer(group, name="hardware")


def check(
    *,
    moving: Annotated[
        bool, typer.Option("--moving", help="Also try the clauses that move something.")
    ] = False,
    yes: Annotated[bool, typer.Option("--yes", help="Move without asking first.")] = False,
    list_only: Annotated[
        bool, typer.Option("--list", help="Print the clauses, and connect nowhere.")
    ] = False,
    seconds: Annotated[
        float,
        typer.Option(
            "--seconds", min=1.1, max=60.0, help="Robot seconds of listening before the first clause."
        ),
    ] = 2.5,
    as_json: Json = False,
    bus: BusOptions,
) -> None:
    """Check a robot's driver against the hardware contract. Exits 1 if a clause fails."""
    from tandem.executive.conformance.suite import SUITE  # noqa: PLC0415

    if list_only:
        _list(SUITE, as_json=as_json)
        return
    if moving and not yes:
        confirm(WARNING, "Go on?")
    wanted = [each for each in SUITE if moving or not each.moving]
    found: list[Finding] = []
    for finding in _findings(wanted, bus, seconds, moving=moving):
        found.append(finding)
        if not as_json:
            _tell(finding)
    failed = sum(each.state == "failed" for each in found)
    if as_json:
        _print(tuple(_shape(each.clause, each) for each in found))
    else:
        skipped = sum(each.state == "skipped" for each in found)
        rest = "" if moving else "; --moving tries those that move something"
        typer.echo(f"{len(found) - failed - skipped} ok, {failed} failed, {skipped} skipped{rest}")
    raise typer.Exit(ExitCode.TASK_FAILED if failed else ExitCode.OK)


def _findings(
    wanted: list[Clause], options: BusOptions, seconds: float, *, moving: bool
) -> Iterator[Finding]:
    from tandem.executive.cli.connection import Connection  # noqa: PLC0415
    from tandem.executive.conformance.bench import Bench  # noqa: PLC0415
    from tandem.executive.conformance.running import run  # noqa: PLC0415
    from tandem.skills.ports.lease import Claim  # noqa: PLC0415

    with Connection(options) as connection:
        claim = Claim(secrets.token_hex(8), 1, os.getpid(), socket.gethostname().replace(".", "-")[:64])
        bench = Bench(connection.bus, time.monotonic, claim, connection.allows)
        _require_hardware(connection, bench)
        if moving:
            _require_alone(connection, bench)
        yield from run(wanted, bench, lambda: connection.bus.waker.wait(STEP), listened=seconds)


def _require_hardware(connection: Connection, bench: Bench) -> None:
    from tandem.skills.ports.keys import DESCRIPTION  # noqa: PLC0415

    answer = connection.raw(DESCRIPTION.key, b"{}")
    bench.step()
    if answer is None and not bench.recording.keys:
        raise CommandError(connection.nobody("hardware"), ExitCode.NOBODY_THERE)


def _require_alone(connection: Connection, bench: Bench) -> None:
    end = time.monotonic() + 1.5  # the table of leases is told once a second
    while time.monotonic() < end:
        connection.bus.waker.wait(STEP)
        bench.step()
    if others := bench.others():
        raise CommandError(
            f"{', '.join(others)} command this robot: end them before --moving moves it", ExitCode.REFUSED
        )


def _list(clauses: tuple[Clause, ...], *, as_json: bool) -> None:
    if as_json:
        _print(tuple(_shape(each) for each in clauses))
        return
    for each in clauses:
        moves = " (moves)" if each.moving else ""
        typer.echo(f"{each.name}{moves}: {each.requires} docs/{each.where}")


def _tell(finding: Finding) -> None:
    name = finding.clause.name
    if finding.state == "failed":
        typer.echo(f"FAILED   {name}: expected {finding.expected}; found {finding.found}")
    else:
        typer.echo(f"{finding.state:<8} {name}{': ' if finding.why else ''}{finding.why}")
    sys.stdout.flush()


def _shape(clause: Clause, finding: Finding | None = None) -> ClauseFound:
    from tandem.executive.cli.shapes import ClauseFound  # noqa: PLC0415

    return ClauseFound(
        name=clause.name,
        requires=clause.requires,
        where=f"docs/{clause.where}",
        moving=clause.moving,
        state="" if finding is None else str(finding.state),
        expected="" if finding is None else finding.expected,
        found="" if finding is None else finding.found,
        why="" if finding is None else finding.why,
    )


def _print(clauses: tuple[ClauseFound, ...]) -> None:
    from tandem.executive.cli.shapes import HardwareChecked, print_json  # noqa: PLC0415

    print_json(HardwareChecked(clauses=clauses))
