"""What ``tandem demo``, ``run`` and ``up`` do: put a whole system together, run it, and end it."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Final, NoReturn

from rich.console import Console

from tandem.executive.cli.carrying_out import (
    USUAL_VIEW,
    carry_out,
    show_end,
    tell_end,
    write_report_of,
)
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.lockstep_run import lockstep_of
from tandem.executive.cli.run_ending import complain, ended
from tandem.executive.cli.sending import describe_problems
from tandem.executive.cli.shapes import Ran, print_json
from tandem.executive.cli.task_lines import TaskLines
from tandem.executive.config.data_folder import DataFolderError, require_writable
from tandem.executive.config.fault_file import check_faults
from tandem.executive.config.run_options import DEFAULT_ROBOT, RunOptions
from tandem.executive.ledger.port import LedgerError, LedgerLockedError
from tandem.executive.system import startup_notice as taking_up
from tandem.executive.system.births import Births
from tandem.executive.system.crews import data_of
from tandem.executive.system.declared_reflexes import check_reflexes
from tandem.executive.system.first_request import hint
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.systems import (
    LedgerFailure,
    LockstepSystem,
    RefusedError,
    System,
)
from tandem.executive.trials.demo import Caller, succeeded
from tandem.executive.trials.run_report import Recorder
from tandem.executive.trials.truly import judged
from tandem.sim.demonstration import Beside, Demonstration
from tandem.sim.scenario import Scenario, read_scenario
from tandem.sim.scene import build_scene
from tandem.skills.ports.site import Site
from tandem.skills.ports.sources import DocumentError
from tandem.skills.site import load
from tandem.skills.testing.faulty_bus import BusFaults

USUAL: Final = Demonstration(request={"task": "fetch", "item": 29, "to": "depot"}, view=USUAL_VIEW)
"""What a scenario is shown with that says nothing of it."""
PICTURE: Final = Path("tandem-demo.png")


def run_demo(options: RunOptions) -> ExitCode:
    """Show a scenario and end; OK only when the task succeeded, and in truth as well."""

    def work(console: Console) -> ExitCode:
        scenario, site, bus_faults = _checked(options)
        demo = scenario.demo or USUAL
        robot = demo.robot or _asked_robot(options, scenario)
        with _system(options, scenario, bus_faults, console) as system:
            for each in demo.beside:
                _ask_beside(system.of(each.robot), each, console)
            asked: System = system.of(robot) if robot else system
            return _show(options, asked, site, demo, robot=robot, console=console)

    return ended(work)


def run_once(options: RunOptions) -> ExitCode:
    """Carry out the request of the options and end; OK only when the task has succeeded."""

    def work(console: Console) -> ExitCode:
        scenario, _, bus_faults = _checked(options)
        robot = _asked_robot(options, scenario)
        with _system(options, scenario, bus_faults, console) as system:
            asked: System = system.of(robot) if robot else system
            view = (scenario.demo or USUAL).view
            ran = carry_out(options, asked, options.request, view, console)
            if ran is None:
                return ExitCode.BAD_INPUT
            taken = None if options.picture is None else show_end(options.picture, ran.caller, view, console)
            tell_end(ran, console)
            write_report_of(options, ran.recorder, system, notes={}, start=ran.before, end=ran.after)
        if options.as_json:  # once all has ended well
            print_json(Ran(status=ran.status, picture="" if taken is None else str(taken)))
        return ExitCode.OK if succeeded(ran.status) else ExitCode.TASK_FAILED

    return ended(work, aside=options.as_json)


def run_up(options: RunOptions, births: Births | None = None) -> ExitCode:
    """Start router, stand-in, skills and executive, and watch them until Ctrl-C.

    ``births``: a nursery that has begun to load.
    """

    def work(console: Console) -> ExitCode:
        scenario, site, bus_faults = _checked(options)
        robots = scenario.robots_on_the_bus
        taken_up = _taken_up(options, robots)
        with _system(options, scenario, bus_faults, console, first=taken_up, births=births) as system:
            _say_ready(options, scenario, site, console)
            _watch(options, system, _task_lines(system, robots, console))

    return ended(work)


def _say_ready(options: RunOptions, scenario: Scenario, site: Site, console: Console) -> None:
    """Say where the system is, and what to type in another terminal."""
    buses = tuple(replace(options.bus, robot=name) for name in scenario.robots_on_the_bus) or (options.bus,)
    everyone = " and ".join(bus.prefix for bus in buses)
    console.print(f"ready: {options.scenario} on {everyone} at {options.bus.endpoint}")
    asked = replace(options, bus=buses[0])
    console.print(f"in another terminal: {hint(asked, scenario, site)}", markup=False)
    for line in _pages(options, scenario.robots_on_the_bus):
        console.print(line, markup=False)
    if options.record is not None:
        console.print(f"recording into {options.record}", markup=False)
    console.print("press Ctrl-C to stop")


def _pages(options: RunOptions, robots: Sequence[str]) -> Iterator[str]:
    """Say where the page is, or that of each of several robots."""
    if not options.web:
        return
    from tandem.executive.web.options import addresses_of, shown_at  # noqa: PLC0415 - the extra is there

    for robot, (host, port) in addresses_of(options.web, robots or ("",)).items():
        yield f"the page{robot and f' of {robot}'}: {shown_at(host, port)}"


def _watch(
    options: RunOptions, system: LockstepSystem | ProcessSystem, tasks: Sequence[TaskLines]
) -> NoReturn:
    """Tell what becomes of tasks until Ctrl-C; with ``--report``, record it too.

    Without one nothing is recorded: weeks of it would fill the memory.
    """
    recorder = None if options.report is None else Recorder(system.bus, system.clocks)
    if recorder is None and isinstance(system, ProcessSystem):
        system.ignore_clocks()
    try:
        while True:
            system.advance()
            for each in tasks:
                each.step()
            if recorder is not None:
                recorder.step()
    finally:
        if recorder is not None:
            write_report_of(options, recorder, system, notes={})


def _task_lines(system: System, robots: Sequence[str], console: Console) -> tuple[TaskLines, ...]:
    """Say what becomes of the tasks of each robot; of several with the robot's name before the line."""

    def say(robot: str, line: str) -> None:
        console.print(f"{robot}: {line}" if robot else line, markup=False)

    if not isinstance(system, ProcessSystem) or not robots:
        return (TaskLines(system.bus, partial(say, "")),)
    return tuple(TaskLines(system.of(robot).bus, partial(say, robot)) for robot in robots)


def _taken_up(options: RunOptions, robots: Sequence[str]) -> tuple[str, ...]:
    """Return what the executives will take up, in words.

    Raises:
        RefusedError: when another process has the ledger.
        LedgerFailure: when it can't be read.
    """
    if options.data is None:
        return ()
    try:
        ledgers = [(data_of(options, robot), f"{options.bus.site}/{robot}") for robot in robots]
        for folder in dict.fromkeys((options.data, *(each for each, _ in ledgers if each is not None))):
            require_writable(folder)
        if options.only and "executive" not in options.only:
            return ()
        return tuple(
            line
            for folder, robot in ledgers or [(options.data, options.bus.prefix)]
            if folder is not None
            for line in taking_up.lines(taking_up.open_tasks(folder, robot), options.on_restart)
        )
    except LedgerLockedError as error:
        raise RefusedError(str(error)) from error
    except (LedgerError, DataFolderError) as error:
        raise LedgerFailure(str(error)) from error


def _checked(options: RunOptions) -> tuple[Scenario, Site, BusFaults | None]:
    scenario, source = read_scenario(options.scenario, options.site)
    site = load(scenario.site)
    build_scene(site, scenario, source=source)
    check_reflexes(scenario, site, options.left_out)
    if options.faults is None:
        return scenario, site, None
    more = check_faults(options.faults, site, scenario.robots_by_name)
    return scenario.with_faults(more.faults), site, more.bus


def _asked_robot(options: RunOptions, scenario: Scenario) -> str:
    """Return which of a scenario's robots is asked: by ``--robot``, else the first; empty for the only one.

    Raises:
        DocumentError: when it has no executive.
    """
    robots = scenario.robots_on_the_bus
    if not robots or options.bus.robot == DEFAULT_ROBOT:
        return robots[0] if robots else ""
    if options.bus.robot not in robots:
        expected = f"expected --robot to name one of {', '.join(robots)}, found {options.bus.robot}"
        raise DocumentError(f"{options.scenario}: {expected}")
    return options.bus.robot


@contextmanager
def _system(
    options: RunOptions,
    scenario: Scenario,
    bus_faults: BusFaults | None,
    console: Console,
    *,
    first: tuple[str, ...] = (),
    births: Births | None = None,
) -> Iterator[LockstepSystem | ProcessSystem]:
    def say(line: str) -> None:
        console.print(line, style="yellow", markup=False)

    for each in options.broken:
        complain(str(each), "yellow")
    if options.lockstep:
        with lockstep_of(options, scenario, bus_faults) as lockstep:
            yield lockstep
        return

    with ProcessSystem(options, say=say, first=first, births=births) as processes:
        yield processes


def _ask_beside(system: System, beside: Beside, console: Console) -> None:
    """Have another robot begin what it does meanwhile.

    Raises:
        DocumentError: it refuses.
    """
    console.print(f"{beside.robot}: {json.dumps(beside.request)}", markup=False)
    answer = Caller(system, lambda _: None).request(dict(beside.request))
    if not answer.accepted:
        raise DocumentError(f"the demo's request to {beside.robot}: {describe_problems(answer)}")


def _show(
    options: RunOptions, system: System, site: Site, demo: Demonstration, *, robot: str, console: Console
) -> ExitCode:
    ran = carry_out(options, system, json.dumps(demo.request), demo.view, console)
    if ran is None:
        return ExitCode.BAD_INPUT
    found = judged(demo.request, ran.truth, site, robot)
    if options.picture is not None or demo.view is not None:
        show_end(options.picture or PICTURE, ran.caller, demo.view, console)
    tell_end(ran, console)
    console.print(f"ground truth: {found.words}", markup=False)
    write_report_of(options, ran.recorder, system, notes=dict(found.notes), start=ran.before, end=ran.after)
    return ExitCode.OK if found.good and succeeded(ran.status) else ExitCode.TASK_FAILED
