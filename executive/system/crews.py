"""Who works for which robot: each of several has processes of its own, under its own prefix."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final

from tandem.executive.config.run_options import RunOptions, default_data
from tandem.executive.system.hung_processes import SELDOM_SILENT, Hung
from tandem.executive.system.roles.observer import NAME as OBSERVER
from tandem.executive.system.roles.recorder import NAME as RECORDER
from tandem.executive.system.roles.registry import names
from tandem.executive.system.roles.skills import gathered
from tandem.executive.system.roles.web import NAME as WEB
from tandem.sim.scenario import Scenario
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import Latest
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.zenoh_bus import ZenohBus

ONCE: Final = ("router", "hardware")
"""Roles that are played once for all robots."""


@dataclass(eq=False)
class Crew:
    """The processes of one robot, and its bus as the supervisor has it.

    Args:
        robot: its name in the scenario; empty where it is the only one.
        prefix: ``<site>/<robot>``.
        roles: what is played for it; the first crew has what is played once for all.
        data: folder of its ledger and of what its skills keep; None: the run's own.
        hung: says which of its processes hang.
    """

    robot: str
    prefix: str
    roles: tuple[str, ...]
    data: Path | None
    hung: Hung
    bus: ZenohBus | None = None
    clocks: ProcessClocks | None = None
    stop: Latest[StopState] | None = None
    given_up: set[str] = field(default_factory=set)

    def called(self, role: str) -> str:
        """Return what the process of a role is called, as in ``r2/base``."""
        return role if not self.robot or role in ONCE else f"{self.robot}/{role}"

    def holder(self, options: RunOptions) -> str:
        """Return in whose name its processes show keys: of several robots each has keys of its own name."""
        return self.robot or options.bus.holder

    def logs(self, options: RunOptions) -> Path | None:
        """Return the folder beside whose ledger the logs of all go, where its commands look for them."""
        usual = self.data is not None and self.robot and self.data.parent != options.data
        return self.data if usual else options.data

    def connected(self) -> ZenohBus:
        """Return its bus."""
        assert self.bus is not None, "start it first"
        return self.bus

    def missing(self, lineage: str) -> tuple[str, ...]:
        """Return the roles that no process of this lineage plays yet: settled as the only one, and ready."""
        alive = self.connected().alive()
        settled = {
            name.split("/")[1] for name in alive if name.startswith("role/") and f"/{lineage}." in name
        }
        return tuple(
            role
            for role in self.roles
            if role != "router"
            and role not in self.given_up
            and not (role in settled and f"process/{role}" in alive)
        )

    def listen(self, bus: ZenohBus, stop: Latest[StopState]) -> None:
        """Have its bus from now on."""
        self.bus, self.clocks, self.stop = bus, ProcessClocks(bus), stop


def data_of(options: RunOptions, robot: str) -> Path | None:
    """Return the folder of one of several robots: where its commands look, or inside the given one."""
    if options.data is not None and options.data == default_data(options.bus, os.environ):
        return default_data(replace(options.bus, robot=robot), os.environ)
    return None if options.data is None else options.data / robot


def roles_of(scenario: Scenario, left_out: Mapping[str, str] | None = None) -> tuple[str, ...]:
    """Return the roles that the scenario's (first) robot needs, and with ``left_out`` plug-ins' but these.

    Raises:
        RobotError: when there is no such robot.
    """
    return _roles_of(scenario.first.robot, left_out)


def _roles_of(robot: str, left_out: Mapping[str, str] | None) -> tuple[str, ...]:
    from tandem.sim.robots.registry import robot_model  # noqa: PLC0415 - loads numpy, which watchers do without

    return names(robot_model(robot).description, left_out)


def crews_of(
    scenario: Scenario, options: RunOptions, roles: tuple[str, ...] | None, hung_after: float
) -> tuple[Crew, ...]:
    """Return the crews of a scenario's robots, the first robot's first.

    Args:
        scenario: who is in it.
        options: prefix and data; which roles are started.
        roles: instead of what each robot needs.
        hung_after: host seconds without a beat after which a process hangs.

    Raises:
        RobotError: when there is no such robot.
    """
    chosen = roles or options.only
    observed: tuple[str, ...] = (OBSERVER,) if options.metrics or options.traces else ()
    page: tuple[str, ...] = (WEB,) if options.web else ()
    recorded = (RECORDER,) if options.black_box and not chosen else ()
    shared = gathered if options.processes == "few" else tuple[str, ...]
    if not scenario.robots_on_the_bus:
        needed = shared(chosen or roles_of(scenario, options.left_out))
        hung = Hung(time.monotonic, max(0.0, hung_after - SELDOM_SILENT))
        return (Crew("", options.bus.prefix, needed + recorded + observed + page, options.data, hung),)
    found: list[Crew] = []
    for name in scenario.robots_on_the_bus:
        needed = shared(chosen or _roles_of(scenario.robots_by_name[name], options.left_out))
        needed += recorded + observed
        own = needed + page if not found else tuple(role for role in needed if role not in ONCE)
        data = data_of(options, name)
        hung = Hung(time.monotonic, max(0.0, hung_after - SELDOM_SILENT))
        found.append(Crew(name, f"{options.bus.site}/{name}", own, data, hung))
    return tuple(found)
