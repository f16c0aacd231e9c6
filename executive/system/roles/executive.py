"""The executive: takes requests, runs one task's tree at a time, and keeps its ledger."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Final

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.security.rights import Rights
from tandem.executive.system.roles.role import Role, Stage, process_rights
from tandem.skills.ports.bus import Bus, Commons
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.node import Node
from tandem.skills.ports.plugins import UNTRIED
from tandem.skills.ports.site import Site

if TYPE_CHECKING:
    from tandem.executive.config.on_restart import OnRestart
    from tandem.executive.ledger.port import Ledger

_AHEAD: Final = (
    "tandem.executive.ledger.sqlite",
    "tandem.executive.service.executive",
    "tandem.skills.wire.clocks",
    "tandem.skills.wire.lease_holder",
    "tandem.skills.wire.loop",
    "tandem.skills.wire.zenoh_bus",
)


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
    left_out: Mapping[str, str] | None = UNTRIED,
    commons: Commons | None = None,
    robot: str = "",
) -> Node:
    """Return the executive with all kinds of tasks there are.

    Args:
        bus: where clients, skills and hardware are.
        clocks: robot time, host time, UTC.
        site: what is known beforehand.
        start: becomes a part of the tasks' ids.
        host: names this start of the host, within which its monotonic clock goes on.
        ledger: keeps what must not be forgotten; in memory unless given.
        on_restart: what becomes of a task that was under way.
        died: how the executive of before ended.
        left_out: plug-ins that are known not to load; None: all plug-ins are left out.
        commons: where the robots of the site tell where they are.
        robot: the robot's name among them.
    """
    from importlib.metadata import version  # noqa: PLC0415

    from tandem.executive.service.executive import Executive  # noqa: PLC0415
    from tandem.executive.service.policy import Policy  # noqa: PLC0415
    from tandem.trees.registry import discover, shipped  # noqa: PLC0415

    return Executive(
        bus,
        clocks,
        site,
        shipped() if left_out is None else discover(left_out),
        start=start,
        host=host,
        version=version("tandem-executive"),
        ledger=ledger,
        policy=Policy(on_restart=on_restart),
        died=died,
        commons=commons,
        robot=robot,
    )


def ledger_of(settings: WorkerSettings) -> Ledger | None:
    """Open the ledger in the process's folder of data, if it has one.

    Raises:
        LedgerError: it can't be opened.
    """
    from tandem.executive.ledger.sqlite import SqliteLedger  # noqa: PLC0415

    return None if settings.data is None else SqliteLedger(Path(settings.data), robot=settings.prefix)


def service_node(stage: Stage, bus: Bus, clocks: Clocks, ledger: Ledger | None) -> Node:
    """Return the executive of a process, over its bus and ledger."""
    from tandem.executive.service.tasks.task_book import start_id  # noqa: PLC0415
    from tandem.executive.service.tasks.wall_clock import host_start  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415

    settings = stage.settings
    return executive_node(
        bus,
        clocks,
        load(settings.site),
        start=start_id(),
        host=host_start(),
        ledger=ledger,
        on_restart=settings.on_restart,
        died=settings.died,
        left_out=settings.left_out,
        commons=stage.bus.commons(),
        robot=settings.prefix.rpartition("/")[2],
    )


def _play(stage: Stage) -> None:
    from tandem.executive.system.leased_loop import run_leased  # noqa: PLC0415

    def service(bus: Bus, clocks: Clocks) -> Node:
        return service_node(stage, bus, clocks, ledger_of(stage.settings))

    run_leased(stage, service, calm=lambda: True)


def _load_ahead() -> None:
    for module in _AHEAD:
        importlib.import_module(module)
    from tandem.trees.registry import shipped  # noqa: PLC0415

    shipped()  # a plug-in is loaded once the settings say which ones load


RIGHTS: Final = process_rights(
    Rights(
        tells=("task/**", "tree/**", "site/**", "sim/follow", "beat/**", "refused"),
        hears=("hw/**", "world/**", "skill/**", "task/**", "beat/**"),
        # Of the hardware it may ask who it is, and set the stop; it can't release it.
        asks=("hw/description", "hw/lease", "hw/stop", "skill/**", "world/**"),
        serves=("task/**", "tree/**", "site/**"),
        tells_site=("world/robots/{robot}",),
        hears_site=("world/robots/*",),
    )
)
ROLES = (Role(name="executive", starts=80, kind="executive", play=_play, rights=RIGHTS, ahead=_load_ahead),)
