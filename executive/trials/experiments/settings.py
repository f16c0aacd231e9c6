"""What an experiment is asked for (two-arm thesis, 5.2), and where its things may stand."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final, Literal

from tandem.skills.ports.message import Message

Kind = Literal["uncoordinated", "crossing", "coordinated"]
Method = Literal["apf_rrtconnect", "rrtconnect", "rrtconnect_replan"]
Series = Literal["field", "grasp"]
LEFT, RIGHT, CARTON = 29, 42, 0
FARTHEST: Final = 0.15
LEAST: Final = 0.10
"""Metres by which a thing is moved: at least this, at most that."""


class Options(Message):
    """How the runs of one experiment are made."""

    kind: Kind
    method: Method = "apf_rrtconnect"
    sequential: bool = False
    mode: Literal["faithful", "eager"] = "eager"
    series: Series = "field"
    seed: int = 1


class Region(Message):
    """Where an item's centre may stand (m in the map), and how far it may be turned from facing the robot."""

    item: int
    x: tuple[float, float]
    y: tuple[float, float]
    turn: float
    """Radians to either side."""


def _cubes(
    left: tuple[float, float], right: tuple[float, float], x: tuple[float, float]
) -> tuple[Region, ...]:
    return (
        Region(item=LEFT, x=x, y=left, turn=0.6),
        Region(item=RIGHT, x=x, y=right, turn=0.6),
    )


REGIONS: Final = MappingProxyType(
    {
        "uncoordinated": _cubes((0.10, 0.36), (-0.36, -0.10), (0.50, 0.74)),
        # 29 on the robot's right, 42 on its left: as far across as each arm reaches from any side.
        "crossing": _cubes((-0.10, -0.07), (0.07, 0.10), (0.50, 0.63)),
        # Two fists that press straight inwards reach both sides of the carton here, and hardly elsewhere.
        "coordinated": (Region(item=CARTON, x=(0.56, 0.59), y=(-0.08, 0.08), turn=0.03),),
    }
)
"""All of a region can be reached, whichever way the item is turned: tried on the robot's kinematics."""
POSITIONS: Final[tuple[tuple[tuple[float, float], tuple[float, float]], ...]] = (
    ((0.60, 0.22), (0.60, -0.22)),
    ((0.68, 0.30), (0.55, -0.16)),
    ((0.54, 0.14), (0.70, -0.28)),
)
"""x and y of the left and of the right cube in the uncoordinated experiment's positions 1, 2 and 3."""
AROUND: Final = 0.01
"""Metres by which a run's own start differs from its position."""
