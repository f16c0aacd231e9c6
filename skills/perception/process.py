"""The nodes of the perception process."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from tandem.skills.perception.detectors import Detector
from tandem.skills.perception.jobs import warm_up
from tandem.skills.perception.look import Look
from tandem.skills.perception.mapper import Mapper
from tandem.skills.perception.snapshot import Snapshots
from tandem.skills.perception.track import Track
from tandem.skills.perception.turn_head import TurnHead
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.server import ActionServer


def nodes(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    compute: Compute,
    *,
    detectors: Mapping[str, Detector] | None = None,
    charge: bool = False,
    map_file: Path | None = None,
) -> tuple[Node, ...]:
    """Return the servers of the actions, the snapshots, and the mapper where the site wants one.

    ``compute`` reads pictures, with the ``detectors``; ``charge`` is the server's, for lockstep;
    ``map_file`` is where the map of occupied space is saved.

    The worker is started now: its first picture should not wait for OpenCV to load.
    """
    compute.submit(warm_up, 64, cost=0.0)
    mapper = None
    if site.occupancy is not None:
        mapper = Mapper(bus, clocks, description, site, site.occupancy, compute, map_file)
    look = Look(
        bus,
        clocks,
        description,
        site,
        compute,
        detectors=detectors,
        taken=None if mapper is None else mapper.offer,
    )
    track = Track(bus, clocks, description, site, compute, detectors=detectors)
    return (
        ActionServer(bus, clocks, look, charge=charge),
        ActionServer(bus, clocks, track, charge=charge),
        ActionServer(bus, clocks, TurnHead(bus, clocks, description), charge=charge),
        Snapshots(bus, clocks, compute, tuple(each.name for each in description.cameras)),
        *(() if mapper is None else (mapper,)),
    )
