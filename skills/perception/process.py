"""The nodes of the perception process."""

from __future__ import annotations

from skills.perception.jobs import warm_up
from skills.perception.look import Look
from skills.perception.snapshot import Snapshots
from skills.perception.track import Track
from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from skills.ports.compute import Compute
from skills.ports.hardware import RobotDescription
from skills.ports.node import Node
from skills.ports.site import Site
from skills.server import ActionServer


def nodes(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    compute: Compute,
    *,
    charge: bool = False,
) -> tuple[Node, ...]:
    """Return the servers of look and track, and the snapshots.

    ``compute`` reads pictures; ``charge`` is the server's, for lockstep.

    The worker is started now: its first picture should not wait for OpenCV to load.
    """
    compute.submit(warm_up, 64, cost=0.0)
    look = Look(bus, clocks, description, site, compute)
    track = Track(bus, clocks, description, site, compute)
    return (
        ActionServer(bus, clocks, look, charge=charge),
        ActionServer(bus, clocks, track, charge=charge),
        Snapshots(bus, clocks, compute),
    )
