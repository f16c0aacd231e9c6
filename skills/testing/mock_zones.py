"""The workspace of a robot that isn't there: left, common and right, and nothing too near or too far."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.actions.bimanual import ZoneRow, Zones
from tandem.skills.ports.message import RobotTime

CELL: Final = 0.1
NEAREST: Final = 0.3
FARTHEST: Final = 0.9
"""Metres in the base: a square's edge, and x from and to. Coarser than those of ``bimanual.zones``: tests
need each letter once, not the whole table."""
ROW: Final = "RRRRCCCCCLLLL"
"""From the right hand's side, y = -0.6 m, to the left hand's, y = 0.6 m; both reach |y| <= 0.2 m."""


def mock_zones(stamp: RobotTime) -> Zones:
    """Return it at table height."""
    count = round((FARTHEST - NEAREST) / CELL) + 1
    rows = tuple(ZoneRow(x=round(NEAREST + k * CELL, 3), cells=ROW) for k in range(count))
    return Zones(stamp=stamp, height=0.71, torso=0.3, cell=CELL, y0=-0.6, rows=rows)
