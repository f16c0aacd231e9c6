"""The loop of a process whose node may act only while it holds its role's lease."""

from __future__ import annotations

from collections.abc import Callable

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.system.roles.role import Stage
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.node import Node
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.lease_holder import LeaseHolder, Leasing
from tandem.skills.wire.loop import run


def run_leased(
    stage: Stage, build: Callable[[Bus, Clocks], Node], *, calm: Callable[[], bool] = lambda: False
) -> None:
    """Settle the lease, build the node, and step it until the process is told to end.

    ``calm``: see ``loop.run``.

    Raises:
        RivalError: another process has the lease.
    """
    bus, clocks = stage.bus, ProcessClocks(stage.bus)
    holder = LeaseHolder(bus, clocks, stage.presence)
    faulty = _with_faults(stage.settings, bus, clocks)
    holder.acquire(stage.stopped)
    nodes = [Leasing(holder, [build(faulty, clocks)])]
    run(stage.settings.role, bus, clocks, nodes, stage.stopped, calm=calm)


def _with_faults(settings: WorkerSettings, bus: Bus, clocks: Clocks) -> Bus:
    """Return the bus, or a bad one around it when the faults' file says so."""
    if settings.faults is None:
        return bus
    from tandem.executive.config.fault_file import load_faults  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415
    from tandem.skills.testing.faulty_bus import FaultyBus  # noqa: PLC0415

    faults = load_faults(settings.faults, load(settings.site)).bus
    return bus if faults is None else FaultyBus(bus, clocks, f"{settings.seed}/{settings.role}", faults)
