"""One request, carried out from the terminal: sent, told, filmed, photographed and reported."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from pydantic import JsonValue
from rich.console import Console

from tandem.executive.cli.run_ending import complain
from tandem.executive.cli.sending import describe_problems
from tandem.executive.config.run_options import RunOptions
from tandem.executive.render.failure_words import result_lines
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.systems import RobotSystem, System
from tandem.executive.trials.demo import Caller, Together
from tandem.executive.trials.run_report import Recorder, write_report
from tandem.sim.demonstration import View
from tandem.sim.truth import Truth
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.tasks import TaskStatus

if TYPE_CHECKING:
    from tandem.executive.cli.film import Film

USUAL_VIEW: Final = View(eye=(0.9, -2.9, 2.2), target=(-1.6, 0.3, 0.5))
"""From the lab's south wall: depot, home and shelf."""


@dataclass(frozen=True)
class CarriedOut:
    """A request that was carried out: how it ended, and where the items truly were before and after."""

    status: TaskStatus
    caller: Caller
    recorder: Recorder
    before: dict[int, Pose]
    after: dict[int, Pose]
    truth: Truth


def carry_out(
    options: RunOptions, system: System, request: str, view: View | None, console: Console
) -> CarriedOut | None:
    """Send a request, and tell and film it to its end; None when it was rejected."""
    recorder = Recorder(system.bus, system.clocks)
    film = None if options.film is None else _film(system, view or USUAL_VIEW)
    also = recorder if film is None else Together((recorder, film))
    caller = Caller(system, lambda line: console.print(line, markup=False), also=also)
    before = caller.truth()
    console.print(f"request: {request}", markup=False)
    answer = caller.request(request)
    if not answer.accepted:
        complain(describe_problems(answer))
        return None
    status = caller.follow(answer.task, within=options.within)
    after = caller.truth()
    if film is not None and options.film is not None:
        _save(film, options.film, console)
    return CarriedOut(status, caller, recorder, _items(before), _items(after), after)


def _film(system: System, view: View) -> Film:
    from tandem.executive.cli.film import Film  # noqa: PLC0415 - OpenCV, which a host with the executive alone lacks

    return Film(system.bus, system.clocks, view)


def _save(film: Film, path: Path, console: Console) -> None:
    """Write a film; a task that was carried out is told to its end even where that fails."""
    try:
        film.write(path)
    except OSError as error:
        complain(f"no moving picture: {error}")
    else:
        console.print(f"moving picture: {path.resolve()}", markup=False)


def tell_end(ran: CarriedOut, console: Console) -> None:
    """Say how the task ended, and what it told at its end."""
    status = ran.status
    ended = status.state.value.lower() if status.failure is None else f"failed: {status.failure.message}"
    console.print("\n".join((f"task {status.task} {ended}", *result_lines(status))), markup=False)


def show_end(path: Path, caller: Caller, view: View | None, console: Console) -> Path | None:
    """Save a picture of the scene and say so; return its whole path, None when there is none."""
    picture = caller.photograph(view or USUAL_VIEW)
    if picture is None:
        complain("no picture: the camera did not answer")
        return None
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(picture)
    console.print(f"picture of the final scene: {path.resolve()}", markup=False)
    return path.resolve()


def _items(truth: Truth) -> dict[int, Pose]:
    return {
        int(body.name.removeprefix("item_")): body.pose
        for body in truth.bodies
        if body.name.startswith("item_")
    }


def write_report_of(
    options: RunOptions,
    recorder: Recorder,
    system: System,
    *,
    notes: dict[str, JsonValue],
    start: dict[int, Pose] | None = None,
    end: dict[int, Pose] | None = None,
) -> None:
    """Write the report of a run where ``--report`` asks for one.

    Args:
        options: of the run.
        recorder: what it has seen of the run.
        system: whose processes are told; of a robot's part of a system those of the whole.
        notes: what else is told, by name.
        start: where the items truly were before, map frame; None: not looked at.
        end: where they truly were after.
    """
    if options.report is None:
        return
    whole = system.whole if isinstance(system, RobotSystem) else system
    processes = whole.pids() if isinstance(whole, ProcessSystem) else {}
    report = recorder.report(
        scenario=options.scenario,
        seed=options.seed,
        lockstep=options.lockstep,
        start=start,
        end=end,
        processes=processes,
        notes=notes,
    )
    write_report(options.report, report)
