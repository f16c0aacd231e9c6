"""The nodes of the reflex."""

from __future__ import annotations

from skills.kinematics.hulls import RobotHulls
from skills.ports.bus import Bus
from skills.ports.hardware import RobotDescription
from skills.ports.node import Node
from skills.ports.site import Site
from skills.reflex.node import CrossingReflex
from skills.reflex.watch import ArmsWatch


def nodes(bus: Bus, description: RobotDescription, site: Site, hulls: RobotHulls) -> tuple[Node, ...]:
    """Return the arms crossing control, or nothing for a robot whose arms need none."""
    how = description.arms_crossing
    if how is None:
        return ()
    return (CrossingReflex(bus, ArmsWatch(hulls, description, how, site)),)
