"""What the options of a whole system say, checked before anything is started."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, cast, get_args

import typer

from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.logs import LogOptions
from tandem.executive.config.addresses import METRICS_EXAMPLE, host_and_port
from tandem.executive.config.extras import RECORD, WEB, words_on
from tandem.executive.config.on_restart import OnRestart
from tandem.executive.config.run_options import FILMS, BusOptions, Processes

if TYPE_CHECKING:
    from tandem.sim.scenario import Scenario


def _one_of(texts: tuple[str, ...], text: str, option: str) -> str:
    """Return a word that an option takes."""
    if text not in texts:
        expected = f"{', '.join(texts[:-1])} or {texts[-1]}"
        raise typer.BadParameter(f"expected {expected}; found {text!r}", param_hint=option)
    return text


def processes_of(text: str) -> Processes:
    """Return how processes are spread, as ``--processes`` says."""
    return cast("Processes", _one_of(get_args(Processes), text, "--processes"))


def on_restart_of(text: str) -> OnRestart:
    """Return what becomes of a task that was running, as ``--on-restart`` says."""
    return cast("OnRestart", _one_of(get_args(OnRestart), text, "--on-restart"))


def speed_of(text: str) -> float | None:
    """Return simulated seconds per real second; None: as fast as it goes."""
    if text == "max":
        return None
    try:
        speed = float(text)
    except ValueError:
        speed = 0.0
    if not 0.01 <= speed <= 100.0:  # noqa: PLR2004 - beyond, nothing useful happens
        raise typer.BadParameter(f"expected a number from 0.01 to 100, or max; found {text!r}",
                                 param_hint="--speed")  # fmt: skip
    return speed


def require_window(*, gui: bool, lockstep: bool) -> None:
    """Raise CommandError when a window is asked for that can't be shown."""
    if not gui:
        return
    from tandem.executive.cli.display import require_display  # noqa: PLC0415

    if lockstep:
        raise CommandError("--gui: lockstep has no window; leave out --gui or --lockstep")
    require_display(os.environ)


def metrics_address(text: str) -> str:
    """Return the address of the metrics, or nothing; BadParameter for what is none."""
    if not text:
        return text
    try:
        host_and_port(text, example=METRICS_EXAMPLE)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="--metrics") from error
    return text


def page_address(text: str, bus: BusOptions, robots: Sequence[str] = ()) -> str:
    """Return the address of the (first robot's) page; CommandError where none can be served."""
    lacks = words_on(WEB, "up --web")
    if lacks:
        raise CommandError(lacks)
    if bus.keys is not None:
        raise CommandError(
            "up --web: where keys are used the page shows the key of a person; "
            f"leave out --web, and run `tandem web --keys {bus.keys} --as NAME` beside it"
        )
    from tandem.executive.web.options import AddressError, addresses_of  # noqa: PLC0415

    try:
        _, port = next(iter(addresses_of(text, robots or (bus.robot,)).values()))
    except AddressError as error:
        raise CommandError(f"--web-at: {error}") from error
    if port == 0:
        raise CommandError("--web-at: expected a port other than 0, so that it can be told")
    return text


def folder_of_run(folder: Path | None, *, lockstep: bool) -> Path | None:
    """Return where a run in lockstep is recorded, or None."""
    if folder is None:
        return None
    if not lockstep:
        advice = "add --lockstep, or use `tandem up --record`"
        raise CommandError(f"--record-to: only a run in lockstep is recorded here; {advice}")
    return folder_of_recordings(folder, folder, ())


def folder_of_recordings(folder: Path | None, data: Path, roles: Sequence[str]) -> Path:
    """Return the folder of the recordings, which is made; CommandError when that fails."""
    from tandem.executive.records.boxes import FOLDER  # noqa: PLC0415
    from tandem.executive.system.roles.recorder import NAME  # noqa: PLC0415

    lacks = words_on(RECORD, "a recording")
    if lacks:
        raise CommandError(lacks)
    if roles and NAME not in roles:
        raise CommandError(f"up --record: expected {NAME} among the roles of --only; found {','.join(roles)}")
    chosen = folder or data / FOLDER
    try:
        chosen.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise CommandError(f"--record-to {chosen}: {error.strerror}") from error
    return chosen


def traces_address(text: str) -> str:
    """Return where traces go, or nothing; BadParameter for what is no URL."""
    if text and not text.startswith(("http://", "https://")):
        raise typer.BadParameter(
            f"expected a URL such as http://127.0.0.1:4318; found {text!r}", param_hint="--traces"
        )
    return text


def checked_film(file: Path | None) -> Path | None:
    """Return where a moving picture goes; CommandError when its ending is none of one."""
    if file is not None and file.suffix not in FILMS:
        raise CommandError(f"--film: expected a name that ends in {', '.join(FILMS)}, found {file.name}")
    return file


def checked_scenario(name_or_path: str, site: str, faults: Path | None) -> Scenario:
    """Return it when all is right; CommandError names the file, the path in it and what was expected."""
    from tandem.executive.cli.commands.scenario_commands import checked, checked_faults  # noqa: PLC0415

    scenario = checked(name_or_path, site)
    if faults is not None:
        checked_faults(faults, scenario)
    return scenario


def logs_of(context: typer.Context) -> LogOptions:
    """Return the options of the log, which stand before the command."""
    found = context.find_object(LogOptions)
    return found or LogOptions()
