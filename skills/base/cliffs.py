"""Where the floor ends, as cliff sensors tell, and which of them can't be trusted."""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray, points_in
from tandem.skills.base.ranger import SLOWLY, Ranger
from tandem.skills.base.wheels import stopping_speed
from tandem.skills.geometry.chain import Chain
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.keys import CLIFFS, Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription

log = logging.getLogger(__name__)

KEPT_FOR: Final = 45.0
"""Robot seconds for which plans keep away from an edge: as long as other things that are not seen any more.
Then a robot that saw a dark floor may try again, and one that saw a stair stops there again."""


@dataclass(frozen=True)
class Gap:
    """Less floor than there should be below a sensor: how many metres lower, and where in the base (m)."""

    sensor: str
    drop: float
    x: float
    y: float


@dataclass(frozen=True)
class _Down:
    ranger: Ranger
    floor: float
    """Metres that it reads over an even floor: how high it is."""


class Cliffs:
    """Hears the cliff sensors; a ``Node``.

    Args:
        bus: where they tell.
        clocks: robot time.
        description: the sensors and their frames.
        moving: says whether the base moves.
    """

    name: Final = "base/cliffs"

    def __init__(
        self, bus: Bus, clocks: Clocks, description: RobotDescription, moving: Callable[[], bool]
    ) -> None:
        self._clocks, self._moving = clocks, moving
        self._resting = description.resting_period or 0.0
        self._told = Latest(bus, CLIFFS)
        self._sensors = tuple(_down(description, index) for index in range(len(description.cliff_sensors)))
        self._fastest = min(
            stopping_speed(each.lead, description.driven.hardest, each.period)
            for each in description.cliff_sensors
        )
        self._deaf = tuple(each.name for each in description.cliff_sensors)
        self._edges: list[tuple[float, float, float]] = []

    def step(self) -> bool:
        """Hear what has come; nothing is published."""
        for told in self._told.take():
            for each in self._sensors:
                each.ranger.hear(told.of(each.ranger.sensor.name), told.stamp, moving=self._moving())
        now, resting = self._clocks.robot(), 0.0 if self._moving() else self._resting
        deaf = tuple(each.ranger.sensor.name for each in self._sensors if each.ranger.is_deaf(now, resting))
        if deaf != self._deaf and deaf:
            log.warning("cliff sensors that are silent or stuck: %s", ", ".join(deaf))
        elif deaf != self._deaf:
            log.info("all cliff sensors tell how far the floor is")
        self._deaf = deaf
        return False

    def close(self) -> None:
        """End the subscription."""
        self._told.close()

    @property
    def deaf(self) -> tuple[str, ...]:
        """The cliff sensors that are silent, or stuck at one distance."""
        return self._deaf

    def speed(self, wished: float) -> float:
        """Return how fast (m/s) the base may go ahead: so that it stops before its support is over the edge.

        Slowly while one of them is deaf.
        """
        return min(wished, self._fastest, SLOWLY) if self._deaf else min(wished, self._fastest)

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """How far the floor is lower below each sensor that can be trusted, the lowest first."""
        gaps = [
            Gap(each.ranger.sensor.name, each.ranger.said - each.floor, at.x, at.y)
            for each in self._sensors
            if each.ranger.said is not None and each.ranger.sensor.name not in self._deaf
            for at in (each.ranger.in_base,)
        ]
        return tuple(sorted(gaps, key=lambda gap: -gap.drop))

    def remember(self, gap: Gap, base_in_map: FloorPose) -> tuple[float, float]:
        """Have plans keep away from where a gap is for a while; return that place in map (m)."""
        ((x, y),) = points_in(base_in_map, np.array([[gap.x, gap.y]])).tolist()
        self._edges.append((x, y, robot_seconds(self._clocks)))
        return x, y

    def edges(self) -> FloatArray:
        """Return the edges that are remembered, in map (m), shape (n, 2)."""
        now = robot_seconds(self._clocks)
        self._edges = [each for each in self._edges if now - each[2] < KEPT_FOR]
        return np.array([each[:2] for each in self._edges]).reshape(-1, 2)


def _down(description: RobotDescription, index: int) -> _Down:
    sensor = description.cliff_sensors[index]
    mount = Chain.from_urdf(description.urdf, description.base_frame, sensor.frame).pose({})
    x, y, height = mount.position
    return _Down(Ranger(sensor, FloorPose(x=x, y=y, yaw=0.0)), height)
