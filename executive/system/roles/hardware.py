"""The hardware, simulated. On a robot its driver plays this role, and no process of ours does."""

from __future__ import annotations

import uuid

from tandem.executive.config.extras import SIM
from tandem.executive.security.rights import Rights
from tandem.executive.system.roles.role import Role, Stage, process_rights


def _play(stage: Stage) -> None:
    from tandem.sim.pace import await_renderer, run_paced  # noqa: PLC0415
    from tandem.sim.scenario import load_scenario  # noqa: PLC0415
    from tandem.sim.station import Station, StationSettings  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415

    settings, bus = stage.settings, stage.bus
    stopped = stage.presence.watch(stage.stopped)
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


ROLES = (
    Role(
        name="hardware",
        starts=10,
        kind="hardware",
        extra=SIM,
        play=_play,
        rights=process_rights(
            Rights(
                tells=("hw/**", "sim/faults", "beat", "refused"),
                hears=("hw/**", "sim/**", "beat"),
                serves=("hw/**", "sim/**"),
            )
        ),
    ),
)
