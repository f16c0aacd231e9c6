"""Tells the workspace zones; they are found once, in a worker."""

from __future__ import annotations

from typing import Final

from tandem.skills.bimanual.zones import COST, ZonesAsk, ZonesFound, zones
from tandem.skills.ports.actions.bimanual import ZONES, Zones
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.compute import Compute, Job
from tandem.skills.ports.robot_description import RobotDescription

PERIOD: Final = 1.0
"""Robot seconds between two messages."""


class ZonesBoard:
    """Publishes ``world/zones`` for the torso at home; a ``Node``.

    Args:
        bus: where the trees are.
        clocks: robot time.
        description: the robot.
        compute: finds the zones.
    """

    name = "bimanual/zones"

    def __init__(self, bus: Bus, clocks: Clocks, description: RobotDescription, compute: Compute) -> None:
        self._bus, self._clocks, self._compute = bus, clocks, compute
        self._ask = ZonesAsk(description.model_dump_json())
        self._job: Job[ZonesFound] | None = None
        self._found: ZonesFound | None = None
        self._told_at = float("-inf")

    def step(self) -> bool:
        """Begin, wait, tell."""
        stamp, now = self._clocks.robot(), robot_seconds(self._clocks)
        if stamp is None:
            return False
        if self._job is None:
            self._job = self._compute.submit(zones, self._ask, cost=COST)
        if self._found is None and self._job.done():
            self._found = self._job.result()
        found = self._found
        if found is not None and now - self._told_at >= PERIOD - 1e-6:
            self._told_at = now
            ZONES.publish(
                self._bus,
                Zones(
                    stamp=stamp,
                    height=found.height,
                    torso=found.torso,
                    cell=found.cell,
                    y0=found.y0,
                    rows=found.rows,
                ),
            )
        return False

    def close(self) -> None:
        """Nothing to end: whoever gave the worker ends it."""
