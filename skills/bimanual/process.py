"""The nodes of the process that needs both arms at once: zones, coordination, two hands."""

from __future__ import annotations

from tandem.skills.bimanual.coordinate import Coordinate
from tandem.skills.bimanual.coordinator import Coordinator
from tandem.skills.bimanual.hold import TwoArms
from tandem.skills.bimanual.two_hands import HoldWithTwo
from tandem.skills.bimanual.zones_node import ZonesBoard
from tandem.skills.kinematics.hulls import RobotHulls
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
    *,
    site: Site,
    compute: Compute,
    hulls: RobotHulls,
    charge: bool = False,
) -> tuple[Node, ...]:
    """Return the nodes, in the order in which they are stepped: who tells first, who listens next."""
    arms = TwoArms(bus, clocks, description, hulls)
    two_hands = ActionServer(bus, clocks, HoldWithTwo(bus, clocks, site, arms), charge=charge)
    made: list[Node] = [two_hands, arms, ZonesBoard(bus, clocks, description, compute)]
    how = description.arms_crossing
    if how is not None:
        coordinator = Coordinator(bus, description, how, hulls)
        made += [coordinator, ActionServer(bus, clocks, Coordinate(coordinator), charge=charge)]
    return tuple(made)
