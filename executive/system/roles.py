"""What each role is made of, and how a process plays it.

Each role imports its own libraries when it is played: the executive's process loads no numpy, the base's no
camera library. So the imports stand in the functions.
"""

from __future__ import annotations

import importlib
import logging
import os
import re
import socket
import time
import uuid
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.config.role_names import Role
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.hardware import RobotDescription
from tandem.skills.ports.keys import DESCRIPTION, Nothing
from tandem.skills.ports.lease import Claim
from tandem.skills.ports.node import Node
from tandem.skills.ports.site import Site
from tandem.skills.site import load

if TYPE_CHECKING:
    from tandem.executive.ledger.on_restart import OnRestart
    from tandem.executive.ledger.port import Ledger
    from tandem.skills.wire.credentials import Credentials
    from tandem.skills.wire.presence import Presence
    from tandem.skills.wire.zenoh_bus import ZenohBus

SKILL_ROLES: Final[tuple[Role, ...]] = (
    "keeper",
    "perception",
    "base",
    "bimanual",
    "arm_left",
    "arm_right",
)
"""In the order in which lockstep steps them: who tells first, who listens next."""
DESCRIPTION_WITHIN: Final = 30.0
"""Seconds in which the hardware must have told who it is."""

_LOG = logging.getLogger(__name__)


@dataclass(frozen=True)
class Surroundings:
    """What the nodes of a role are made with."""

    bus: Bus
    clocks: Clocks
    description: RobotDescription
    site: Site
    compute: Compute
    seed: int
    charge: bool = False
    """Whether computations cost their declared robot time (lockstep)."""
    journal: Path | None = None


def skill_nodes(role: Role, at: Surroundings) -> Sequence[Node]:
    """Return the nodes of a skill's role, in the order in which they are stepped."""
    at.bus.ear.know(at.description)
    return _BUILDERS[role](at)


def _keeper(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.world.process import nodes  # noqa: PLC0415

    return nodes(at.bus, at.clocks, at.site, at.journal, charge=at.charge)


def _perception(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.perception.process import nodes  # noqa: PLC0415

    return nodes(at.bus, at.clocks, at.description, at.site, at.compute, charge=at.charge)


def _base(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.base.process import build  # noqa: PLC0415

    return build(at.bus, at.clocks, at.description, at.site, charge=at.charge)


def _arm(side: str) -> Callable[[Surroundings], Sequence[Node]]:
    def build(at: Surroundings) -> Sequence[Node]:
        from tandem.skills.arm.process import nodes as arm_nodes  # noqa: PLC0415
        from tandem.skills.gripper.process import nodes as gripper_nodes  # noqa: PLC0415

        group = at.description.end_effector(side).group
        return [
            *arm_nodes(
                at.bus,
                at.clocks,
                at.description,
                [group],
                seed=at.seed,
                charge=at.charge,
                compute=at.compute,
            ),
            *gripper_nodes(at.bus, at.clocks, at.description, side, charge=at.charge),
        ]

    return build


def _bimanual(at: Surroundings) -> Sequence[Node]:
    from tandem.skills.bimanual.process import nodes  # noqa: PLC0415
    from tandem.skills.kinematics.described import load_hulls  # noqa: PLC0415
    from tandem.skills.reflex.process import nodes as reflexes  # noqa: PLC0415

    hulls = load_hulls(at.description, at.seed)
    return [
        *reflexes(at.bus, at.description, at.site, hulls),
        *nodes(
            at.bus,
            at.clocks,
            at.description,
            site=at.site,
            compute=at.compute,
            hulls=hulls,
            charge=at.charge,
        ),
    ]


_BUILDERS: Final = {
    "keeper": _keeper,
    "perception": _perception,
    "base": _base,
    "arm_left": _arm("left"),
    "arm_right": _arm("right"),
    "bimanual": _bimanual,
}


def executive_node(
    bus: Bus,
    clocks: Clocks,
    site: Site,
    *,
    start: str,
    host: str = "",
    ledger: Ledger | None = None,
    on_restart: OnRestart = "resume",
    died: str = "",
) -> Node:
    """Return the executive, with all tasks there are; ``start`` becomes a part of the tasks' ids.

    ``host`` names this start of the host, within which its monotonic clock goes on; ``died`` tells how the
    executive of before ended.

    Without a ``ledger`` it keeps what it must not forget in memory.
    """
    from importlib.metadata import version  # noqa: PLC0415

    from tandem.executive.service.executive import Executive, Policy  # noqa: PLC0415
    from tandem.trees.registry import discover  # noqa: PLC0415

    return Executive(
        bus,
        clocks,
        site,
        discover(),
        start=start,
        host=host,
        version=version("tandem-executive"),
        ledger=ledger,
        policy=Policy(on_restart=on_restart),
        died=died,
    )


def load_ahead(role: str) -> None:
    """Load what playing a role will need, so that its start takes no time for it later."""
    if role != "executive":
        return
    for module in _AHEAD:
        importlib.import_module(module)
    from tandem.trees.registry import discover  # noqa: PLC0415

    discover()


_AHEAD: Final = (
    "tandem.executive.ledger.sqlite",
    "tandem.executive.service.executive",
    "tandem.skills.wire.clocks",
    "tandem.skills.wire.lease_holder",
    "tandem.skills.wire.loop",
    "tandem.skills.wire.zenoh_bus",
)


def play(settings: WorkerSettings, stopped: Callable[[], bool]) -> None:
    """Play a role until ``stopped`` says so.

    Raises:
        RefusalError: when somebody else plays the role already, or the hardware does not tell who it is.
    """
    if settings.role == "router":
        _play_router(settings, stopped)
        return
    from tandem.skills.wire.presence import Presence, RivalError  # noqa: PLC0415
    from tandem.skills.wire.zenoh_bus import ZenohBus  # noqa: PLC0415

    bus = ZenohBus(
        settings.endpoint,
        settings.prefix,
        credentials=_credentials(settings),
        silent_after=settings.silent_after,
    )
    try:
        # Settled long before ``process/...`` says that the role is ready to be played.
        presence = Presence(bus, settings.role, claim_of(settings))
        presence.settle(stopped)
        if settings.role == "observer":
            _play_observer(settings, bus, presence.watch(stopped))
        elif settings.role == "hardware":
            _play_hardware(settings, bus, presence.watch(stopped))
        elif settings.role == "mock":
            _play_mock(settings, bus, presence.watch(stopped))
        else:
            _play_node(settings, bus, presence, stopped)
    except RivalError as rival:
        raise RefusalError(
            f"{rival}, for {settings.prefix} at {settings.endpoint}; end it first, or give this robot keys "
            f"of its own with --robot"
        ) from rival
    finally:
        bus.close()


def claim_of(settings: WorkerSettings) -> Claim:
    """Return what this process claims its role with."""
    host = re.sub(r"[^0-9A-Za-z_-]", "-", socket.gethostname())[:64] or "host"
    lineage = settings.lineage or uuid.uuid4().hex[:12]
    return Claim(lineage, settings.generation, os.getpid(), host)


def _credentials(settings: WorkerSettings) -> Credentials | None:
    if settings.keys is None:
        return None
    from tandem.executive.security.identity import Identity  # noqa: PLC0415

    return Identity(Path(settings.keys), settings.holder).process(settings.role)


def _play_router(settings: WorkerSettings, stopped: Callable[[], bool]) -> None:
    from tandem.executive.system.router import Router  # noqa: PLC0415
    from tandem.skills.wire.zenoh_bus import Waker  # noqa: PLC0415

    router, waker = Router(settings, _credentials(settings)), Waker()
    try:
        while not stopped():
            waker.wait(0.1)
            router.step()
    finally:
        router.close()


def _play_hardware(settings: WorkerSettings, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    from tandem.sim.pace import await_renderer, run_paced  # noqa: PLC0415
    from tandem.sim.scenario import load_scenario  # noqa: PLC0415
    from tandem.sim.station import Station, StationSettings  # noqa: PLC0415

    how = StationSettings(
        boot=uuid.uuid4().hex[:8],
        seed=settings.seed,
        beside=True,
        waits=settings.speed is None,
        gui=settings.gui,
    )
    scenario = load_scenario(settings.scenario)
    if settings.faults is not None:
        from tandem.executive.config.fault_file import load_faults  # noqa: PLC0415

        scenario = scenario.with_faults(load_faults(settings.faults).faults)
    station = Station(bus, load(settings.site), scenario, how)
    if settings.stop is not None:
        station.hardware.set_stop(settings.stop)
    try:
        await_renderer(station, bus, stopped)
        bus.announce("process/hardware")
        run_paced(station, bus, settings.speed, stopped)
    finally:
        station.close()


def _play_observer(settings: WorkerSettings, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    from tandem.executive.telemetry.process import observe  # noqa: PLC0415

    observe(settings, bus, stopped)


def _play_mock(settings: WorkerSettings, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    from tandem.executive.trials.campaigns.crash_world import TICK, LastingRobot  # noqa: PLC0415
    from tandem.skills.wire.clocks import ProcessClocks  # noqa: PLC0415

    assert settings.data is not None, "the mock keeps its truth in a folder"
    boot = uuid.uuid4().hex[:8]
    clocks = ProcessClocks(bus)
    robot = LastingRobot(bus, clocks, load(settings.site), Path(settings.data), boot)
    bus.announce("process/mock")
    more = False
    try:
        while not stopped():
            if not more:
                bus.waker.wait(TICK)
            clocks.refresh()
            more = robot.step()
    finally:
        robot.close()


def _play_node(
    settings: WorkerSettings, bus: ZenohBus, presence: Presence, stopped: Callable[[], bool]
) -> None:
    from tandem.skills.one_boot import OneBoot  # noqa: PLC0415
    from tandem.skills.wire.clocks import ProcessClocks  # noqa: PLC0415
    from tandem.skills.wire.lease_holder import LeaseHolder, Leasing  # noqa: PLC0415
    from tandem.skills.wire.loop import run  # noqa: PLC0415
    from tandem.skills.wire.workers import ProcessCompute  # noqa: PLC0415

    clocks = ProcessClocks(bus)
    site = load(settings.site)
    faulty, holder = _with_faults(settings, bus, clocks), LeaseHolder(bus, clocks, presence)
    if settings.role == "executive":
        holder.acquire(stopped)
        node = _executive(settings, faulty, clocks, site)
        run("executive", bus, clocks, [Leasing(holder, [node])], stopped)
        return
    if settings.data is not None:
        Path(settings.data).mkdir(parents=True, exist_ok=True)
    compute = ProcessCompute(bus.waker.wake)
    try:
        description = _ask_description(bus, stopped)

        def build(bus: Bus, description: RobotDescription) -> Sequence[Node]:
            at = Surroundings(
                bus=bus,
                clocks=clocks,
                description=description,
                site=site,
                compute=compute,
                seed=settings.seed,
                journal=None if settings.journal is None else Path(settings.journal),
            )
            nodes = skill_nodes(settings.role, at)
            _keep_goals(settings, nodes)
            return nodes

        holder.acquire(stopped)
        skills = OneBoot(settings.role, faulty, clocks, build, description)
        run(settings.role, bus, clocks, [Leasing(holder, [skills])], stopped)
    finally:
        compute.close()


def _keep_goals(settings: WorkerSettings, nodes: Sequence[Node]) -> None:
    """Have the action servers of a process journal the goals that they accept."""
    if settings.data is None:
        return
    from tandem.skills.goal_journal import GoalJournal  # noqa: PLC0415
    from tandem.skills.server import ActionServer  # noqa: PLC0415

    journal = GoalJournal(Path(settings.data) / f"{settings.role}.goals")
    for node in nodes:
        if isinstance(node, ActionServer):
            node.keep(journal)


def _executive(settings: WorkerSettings, bus: Bus, clocks: Clocks, site: Site) -> Node:
    from tandem.executive.ledger.sqlite import SqliteLedger  # noqa: PLC0415
    from tandem.executive.service.tasks.task_book import start_id  # noqa: PLC0415
    from tandem.executive.service.tasks.wall_clock import host_start  # noqa: PLC0415

    ledger: Ledger | None = None if settings.data is None else SqliteLedger(Path(settings.data))
    if settings.crash_at is not None or settings.crash_log is not None:
        from tandem.executive.trials.campaigns.crash_points import CrashBus, CrashLedger, CrashPoints  # noqa: PLC0415

        log = None if settings.crash_log is None else Path(settings.crash_log)
        points = CrashPoints(settings.crash_at or "", log)
        bus, ledger = CrashBus(bus, points), None if ledger is None else CrashLedger(ledger, points)
    start, host = start_id(), host_start()
    return executive_node(
        bus,
        clocks,
        site,
        start=start,
        host=host,
        ledger=ledger,
        on_restart=settings.on_restart,
        died=settings.died,
    )


def _with_faults(settings: WorkerSettings, bus: Bus, clocks: Clocks) -> Bus:
    """Return the bus, or a bad one around it when the faults' file says so."""
    if settings.faults is None:
        return bus
    from tandem.executive.config.fault_file import load_faults  # noqa: PLC0415
    from tandem.skills.testing.faulty_bus import FaultyBus  # noqa: PLC0415

    faults = load_faults(settings.faults).bus
    return bus if faults is None else FaultyBus(bus, clocks, f"{settings.seed}/{settings.role}", faults)


def _ask_description(bus: ZenohBus, stopped: Callable[[], bool]) -> RobotDescription:
    from tandem.skills.wire.zenoh_bus import wait_until  # noqa: PLC0415

    deadline = time.monotonic() + DESCRIPTION_WITHIN
    while not stopped() and time.monotonic() < deadline:
        answer = wait_until(bus, DESCRIPTION.query(bus, Nothing()), 2.0)
        if answer is not None:
            return DESCRIPTION.decode_answer(answer)
        bus.waker.wait(0.05)
    raise RefusalError(f"no robot told its description on hw/description within {DESCRIPTION_WITHIN:.0f} s")
