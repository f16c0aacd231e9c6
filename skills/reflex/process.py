"""The nodes of the reflex."""

from __future__ import annotations

from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.reflex.crossing_watch import ArmsWatch
from tandem.skills.reflex.node import CrossingReflex


def nodes(bus: Bus, description: RobotDescription, site: Site, hulls: RobotHulls) -> tuple[Node, ...]:
    """Return the arms crossing control, or nothing for a robot whose arms need none."""
    how = description.arms_crossing
    if how is None:
        return ()
    return (CrossingReflex(bus, ArmsWatch(hulls, description, how, site)),)
