"""The hardware, simulated. On a robot its driver plays this role, and no process of ours does."""

from __future__ import annotations

import uuid
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from typing import TYPE_CHECKING, Final

from tandem.executive.config.extras import SIM
from tandem.executive.security.rights import Rights
from tandem.executive.system.roles.role import Role, Stage, process_rights

if TYPE_CHECKING:
    from tandem.skills.wire.zenoh_bus import ZenohBus


RESTING_PERIOD: Final = 0.1
"""Robot seconds between two messages of clock and states while a robot rests. Skills call it silent after
0.3 s at the earliest, and trees are ticked as often."""


def _play(stage: Stage) -> None:
    from tandem.sim.pace import await_renderer, run_paced  # noqa: PLC0415
    from tandem.sim.scenario import load_scenario  # noqa: PLC0415
    from tandem.sim.station import Station, StationSettings  # noqa: PLC0415
    from tandem.skills.site import load  # noqa: PLC0415

    settings, bus = stage.settings, stage.bus
    how = StationSettings(
        boot=uuid.uuid4().hex[:8],
        seed=settings.seed,
        beside=True,
        waits=settings.speed is None,
        resting_period=None if settings.speed is None else RESTING_PERIOD,
        gui=settings.gui,
    )
    site = load(settings.site)
    scenario = load_scenario(settings.scenario, settings.site)
    if settings.faults is not None:
        from tandem.executive.config.fault_file import load_faults  # noqa: PLC0415

        scenario = scenario.with_faults(load_faults(settings.faults, site).faults)
    with ExitStack() as ends:
        buses, stopped = _buses(stage, scenario.robots_on_the_bus, ends)
        station = Station(buses or bus, site, scenario, how)
        ends.callback(station.close)
        stops = {scenario.first.name: settings.stop, **settings.stops}
        for name, stop in stops.items():
            if stop is not None and name in station.robots:
                station.robots[name].hardware.set_stop(stop)
        each = tuple(buses.values()) or (bus,)
        await_renderer(station, bus, stopped)
        for one in each:
            one.announce("process/hardware")
        run_paced(station, each, settings.speed, stopped)


def _buses(
    stage: Stage, robots: Sequence[str], ends: ExitStack
) -> tuple[dict[str, ZenohBus], Callable[[], bool]]:
    """Return a bus for each of several robots, all of which wake the first one's loop, and when to end.

    The process plays the hardware of each, and ends when another one plays that of any.
    """
    from tandem.executive.system.playing import claim_of, credentials_of  # noqa: PLC0415
    from tandem.skills.wire.presence import Presence  # noqa: PLC0415
    from tandem.skills.wire.zenoh_bus import ZenohBus  # noqa: PLC0415

    settings = stage.settings
    site, _, own = settings.prefix.partition("/")
    stopped, buses = stage.presence.watch(stage.stopped), {}
    for name in robots:
        if name == own:
            buses[name] = stage.bus
            continue
        buses[name] = ZenohBus(
            settings.endpoint,
            f"{site}/{name}",
            waker=stage.bus.waker,
            credentials=credentials_of(settings.model_copy(update={"holder": name}), ROLES[0]),
            silent_after=settings.silent_after,
            pictures=True,
        )
        ends.callback(buses[name].close)
        presence = Presence(buses[name], settings.role, claim_of(settings))
        presence.settle(stage.stopped)
        stopped = presence.watch(stopped)
    return buses, stopped


ROLES = (
    Role(
        name="hardware",
        starts=10,
        kind="hardware",
        extra=SIM,
        pictures=True,
        play=_play,
        rights=process_rights(
            Rights(
                tells=("hw/**", "sim/faults", "beat/**", "refused"),
                hears=("hw/**", "sim/**", "beat/**"),
                serves=("hw/**", "sim/**"),
            )
        ),
    ),
)
