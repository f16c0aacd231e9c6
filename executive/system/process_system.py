"""A whole system of processes over zenoh, started here and watched."""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack, suppress
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Final, Self

from tandem.executive.config.process_settings import REFUSED, UNKEPT
from tandem.executive.config.run_options import RunOptions
from tandem.executive.security.identity import Identity
from tandem.executive.system.births import Births
from tandem.executive.system.crews import Crew, crews_of
from tandem.executive.system.free_endpoint import EndpointError, TakenError, require_vacant
from tandem.executive.system.hung_processes import HUNG_AFTER, SELDOM_SILENT
from tandem.executive.system.processes import RESTARTED, Death, Supervisor
from tandem.executive.system.roles.observer import NAME as OBSERVER
from tandem.executive.system.roles.recorder import NAME as RECORDER
from tandem.executive.system.roles.registry import plugged
from tandem.executive.system.roles.web import NAME as WEB
from tandem.executive.system.settings_of_processes import SettingsOfProcesses
from tandem.executive.system.systems import (
    LedgerFailure,
    RefusedError,
    RobotSystem,
    SystemFailure,
    wait_for,
)
from tandem.executive.telemetry.log_files import UserLog
from tandem.executive.telemetry.log_reading import FOLDER as LOGS
from tandem.executive.telemetry.relay import LogRelay
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP_STATE, Latest, Nothing
from tandem.skills.ports.tasks import TASK_INFO
from tandem.skills.ports.world import ROBOT_POSE
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.loop import CALM
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus

READY_WITHIN: Final = 60.0
"""Host seconds that processes have for their start."""
POSES_WITHIN: Final = 2.0
"""Host seconds for which robots may be asked where they are, before the system is ready all the same."""
TELL_POSE: Final = {"base", "skills"}
"""Roles that tell it."""
WITHOUT: Final[Mapping[str, str]] = MappingProxyType(
    {
        OBSERVER: "are no metrics and traces of it",
        WEB: "is no page",
        RECORDER: "are no black boxes",
    }
)
"""Roles that only look on, and what there is no more when one of them has died too often."""
PLUGGED_READY_WITHIN: Final = 20.0
"""Host seconds that those of plug-ins have more; ours take about 5 on a busy machine."""


class ProcessSystem:
    """Processes over zenoh, started here and watched. Use as a context.

    Args:
        options: scenario, seed, speed, endpoint.
        roles: which processes to start; those that the scenario's robot needs unless given.
        played_by: what plays a role, by the role's name, where a campaign has it played by code of its own.
        say: takes a line when a skill's process has died and is started again.
        hung_after: host seconds without a beat after which a process is killed and started again.
        first: lines to be said before anything starts, once it is clear that this system may.
        births: a nursery that has begun to load; one of its own unless given.

    Raises:
        ScenarioError: when the scenario is wrong.
    """

    def __init__(
        self,
        options: RunOptions,
        *,
        roles: tuple[str, ...] | None = None,
        played_by: Mapping[str, str] = MappingProxyType({}),
        say: Callable[[str], None] = lambda _: None,
        hung_after: float = HUNG_AFTER,
        first: Sequence[str] = (),
        births: Births | None = None,
    ) -> None:
        scenario = load_scenario(options.scenario, options.site)
        self._crews = crews_of(scenario, options, roles, hung_after)
        self._main = self._crews[0]
        self._options, self._say = options, say
        self._first, self._births = tuple(first), births
        plugged_in = tuple(plugged(options.left_out))
        self._plugged = frozenset(crew.called(role) for crew in self._crews for role in plugged_in)
        """Roles of other packages: the rest can do without."""
        self._ready = False
        self._folder = tempfile.TemporaryDirectory(prefix="tandem-")
        self._settings = SettingsOfProcesses(
            options,
            self._crews,
            site=scenario.site,
            folder=Path(self._folder.name),
            played_by=played_by,
        )
        # Beside the ledger, where `tandem logs` finds them, during the run and after it.
        self.supervisor = Supervisor(_log_folder(self._main.logs(options), Path(self._folder.name)))
        self._logs = ExitStack()
        self._relay = LogRelay(self.supervisor.logs, self._log_sinks(), options.log_format)

    @property
    def bus(self) -> ZenohBus:
        """An end of the (first) robot's bus, once started."""
        return self._main.connected()

    @property
    def clocks(self) -> ProcessClocks:
        """Robot time as heard, once started."""
        assert self._main.clocks is not None, "start it first"
        return self._main.clocks

    def ignore_clocks(self) -> None:
        """Hear no robot's clock from now on: who only watches processes need not wake for each tick."""
        for crew in self._crews:
            if crew.clocks is not None:
                crew.clocks.close()
                crew.clocks = None

    def of(self, robot: str) -> RobotSystem:
        """Return the same system as one of several robots has it.

        Raises:
            KeyError: naming the robots that have an executive.
        """
        for crew in self._crews:
            if crew.robot == robot and crew.clocks is not None:
                return RobotSystem(self, crew.connected(), crew.clocks)
        there = ", ".join(crew.robot for crew in self._crews)
        raise KeyError(f"no robot {robot!r} with an executive; there are {there}")

    def __enter__(self) -> Self:
        """Start all processes, and wait until the executive answers.

        Raises:
            SystemFailure: when a process ends or is not ready in time.
            RefusedError: when there is such a system already, or another program has its endpoint.
            EndpointError: when nothing can listen at the endpoint.
        """
        try:
            self._start()
        except BaseException:
            self.close()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        """End all."""
        self.close()

    def advance(self) -> None:
        """Wait for a message, at most 50 ms, and look after the processes."""
        self.bus.waker.wait(0.05)
        for crew in self._crews:
            if crew.clocks is not None:
                crew.clocks.refresh()
        self._look_after()

    def pids(self) -> dict[str, int]:
        """Return the processes' ids by role, of those that are there."""
        pids = {child.role: child.process.pid for child in self.supervisor.children}
        return {role: pid for role, pid in pids.items() if pid is not None}

    def close(self) -> None:
        """End all processes and remove what they left on disk."""
        for crew in self._crews:
            if crew.bus is not None:
                crew.bus.close()
                crew.bus = None
        self.supervisor.end()
        self._relay.step(last=True)
        self._logs.close()
        self._folder.cleanup()

    def _log_sinks(self) -> tuple[Callable[[str], None], ...]:
        sinks: list[Callable[[str], None]] = [_to_stderr] if self._options.verbose else []
        if self._options.log is not None:
            file = UserLog(self._options.log)
            self._logs.callback(file.close)
            sinks.append(file.write)
        return tuple(sinks)

    def _start(self) -> None:
        self.supervisor.folder.mkdir(parents=True, exist_ok=True)
        self.supervisor.warm(self._births)
        if "router" in self._main.roles:
            self._refuse_second_router()
        for line in self._first:
            self._say(line)
        if "router" in self._main.roles:
            self.supervisor.start(self._settings.of(self._main, "router"))
        for crew in self._crews:
            self._connect(crew)
        for crew in self._crews:
            for role in crew.roles:
                if role != "router":
                    self.supervisor.start(self._settings.of(crew, role))
        every = " and ".join(crew.prefix for crew in self._crews)
        self._await(
            lambda: self._plugged.issuperset(self._not_started()), f"not all processes of {every} started"
        )
        self._await_plugged()
        for crew in self._crews:
            if "executive" in crew.roles:
                answers = partial(self._executive_answers, crew)
                self._await(answers, f"the executive of {crew.prefix} did not answer")
                self.supervisor.keep_spare(crew.called("executive"))
        self._await_poses()
        self._ready = True

    def _await_poses(self) -> None:
        """Wait until all robots say where they are, or for a while: until then their tasks wait."""
        told = [Latest(c.connected(), ROBOT_POSE) for c in self._crews if TELL_POSE & {*c.roles}]
        deadline = time.monotonic() + POSES_WITHIN
        while any(each.refresh() is None for each in told) and time.monotonic() < deadline:
            self.advance()
        for each in told:
            each.close()

    def _not_started(self) -> tuple[str, ...]:
        """Return the processes that are not ready yet, as they are called."""
        ours = self.supervisor.lineage
        return tuple(crew.called(role) for crew in self._crews for role in crew.missing(ours))

    def _await_plugged(self) -> None:
        deadline = time.monotonic() + PLUGGED_READY_WITHIN
        while late := self._not_started():
            self.advance()
            if time.monotonic() > deadline:
                for role in late:
                    why = f"the {role} process of a plug-in was not ready within {PLUGGED_READY_WITHIN:.0f} s"
                    self._do_without(role, why)

    def _refuse_second_router(self) -> None:
        endpoint = self._options.bus.endpoint
        if self._listens_nobody():
            return  # nor does a router answer, and it need not be waited for
        try:
            self._open(0.3, self._main).close()
        except BusError:
            self._require_vacant()
            return
        raise RefusedError(
            f"a router already answers at {endpoint}: another system is running there; "
            f"stop it, or choose another endpoint with --connect tcp/127.0.0.1:7448"
        )

    def _listens_nobody(self) -> bool:
        ends = (self._options.bus.endpoint, *self._options.listen)
        with suppress(TakenError, EndpointError):
            return all(require_vacant(each) for each in ends)
        return False

    def _require_vacant(self) -> None:
        try:
            for endpoint in (self._options.bus.endpoint, *self._options.listen):
                require_vacant(endpoint)
        except TakenError as error:
            raise RefusedError(str(error)) from error

    def _connect(self, crew: Crew) -> None:
        deadline = time.monotonic() + READY_WITHIN
        while crew.bus is None:
            try:
                bus = self._open(0.5, crew)
                crew.listen(bus, Latest(bus, STOP_STATE))
                bus.awake()  # it listens from now on: one that hangs before the first look is missed, too
            except BusError:
                self._look_after()
                if time.monotonic() > deadline:
                    raise SystemFailure(f"no router at {self._options.bus.endpoint}") from None

    def _open(self, patience: float, crew: Crew) -> ZenohBus:
        bus = self._options.bus
        shown = (
            None if bus.keys is None else Identity(bus.keys, crew.holder(self._options)).part("supervisor")
        )
        waker = None if self._main.bus is None else self._main.bus.waker
        opened = ZenohBus(
            bus.endpoint,
            crew.prefix,
            patience=patience,
            waker=waker,
            credentials=shown,
            silent_after=SELDOM_SILENT,
            seldom=True,
        )
        opened.waker.calm = CALM
        return opened

    def _executive_answers(self, crew: Crew) -> bool:
        return wait_for(self, TASK_INFO.query(crew.connected(), Nothing(), timeout=0.3), 0.5) is not None

    def _await(self, holds: Callable[[], bool], otherwise: str) -> None:
        deadline = time.monotonic() + READY_WITHIN
        while not holds():
            self.advance()
            if time.monotonic() > deadline:
                raise SystemFailure(f"{otherwise} within {READY_WITHIN:.0f} s")

    def _look_after(self) -> None:
        """Start skills again that have died; what died in the start, or too often, ends the system."""
        deaths, fatal = self.supervisor.deaths(), list[Death]()
        for death in deaths:
            if self._ready and self.supervisor.restart(death.role, *self._stops_of(death.role)):
                self._say(f"{death.head()}; restarted")
            elif death.role in self._plugged:
                self._do_without(
                    death.role, death.describe() if not self._ready else f"{death.head()} too often"
                )
            elif self._ready and (without := WITHOUT.get(death.role.rpartition("/")[2])):
                self.supervisor.give_up(death.role)
                self._say(f"{death.head()} too often; there {without} from now on")
            else:
                fatal.append(death)
        if fatal:
            raise _end_of(fatal)
        if self._ready:
            self._kill_hung()
        self._relay.step()
        self.supervisor.tidy()

    def _do_without(self, role: str, why: str) -> None:
        """Go on without a process of another package."""
        self.supervisor.give_up(role)
        for crew in self._crews:
            crew.given_up.update(each for each in crew.roles if crew.called(each) == role)
        self._say(f"{why}\nthe plug-in role {role} is off from now on")

    def _stops_of(self, role: str) -> tuple[StopState | None, dict[str, StopState]]:
        """Return the stops that restarted hardware begins with: the first robot's, and the others'."""
        if role != "hardware":
            return None, {}
        found = {crew.robot: None if crew.stop is None else crew.stop.refresh() for crew in self._crews}
        stopped = {robot: stop for robot, stop in found.items() if stop is not None and stop.stopped}
        return stopped.pop(self._main.robot, None), stopped

    def _kill_hung(self) -> None:
        """Kill who hangs for too long; the next look finds it dead, and starts it again.

        Not the hardware: what it simulates would begin anew, and a robot's own is not ours to kill.
        """
        for crew in self._crews:
            names = {
                f"process/{child.settings.role}": child
                for child in self.supervisor.children
                if child.kind in RESTARTED - {"hardware"} and child.settings.prefix == crew.prefix
            }
            bus = crew.connected()
            for name in crew.hung.look(names.keys() & bus.alive(), bus.awake()):
                self._say(f"the {names[name].role} process hangs; killing it")
                names[name].process.kill()


def _log_folder(data: Path | None, otherwise: Path) -> Path:
    """Return where the processes' logs go; what is wrong with ``data`` its owner says, in its own words."""
    if data is not None:
        with suppress(OSError):
            (data / LOGS).mkdir(parents=True, exist_ok=True)
            return data / LOGS
    return otherwise / LOGS


def _to_stderr(line: str) -> None:
    sys.stderr.write(f"{line}\n")
    sys.stderr.flush()


def _end_of(fatal: Sequence[Death]) -> Exception:
    """Return the error that says which processes ended, and whether one refused or can't keep its ledger."""
    words, codes = "\n".join(death.describe() for death in fatal), {death.code for death in fatal}
    if UNKEPT in codes:
        return LedgerFailure(words)
    return RefusedError(words) if REFUSED in codes else SystemFailure(words)
