"""The nodes of the process that needs both arms at once: zones, reflex, coordination, two hands."""

from __future__ import annotations

from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from skills.ports.compute import Compute
from skills.ports.hardware import RobotDescription
from skills.ports.node import Node
from skills.ports.site import Site


def nodes(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    site: Site,
    compute: Compute,
    *,
    seed: int = 0,
    charge: bool = False,
) -> tuple[Node, ...]:
    """Return the nodes, in the order in which they are stepped: who tells first, who listens next."""
    del bus, clocks, description, site, compute, seed, charge
    return ()
