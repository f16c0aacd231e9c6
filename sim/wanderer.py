"""A robot that nobody commands: it drives about at random, and turns away from what comes close.

A script on the hardware's side, an actor of the room like a person who walks there. It has no sensors: it is
told by the physics how far it is from the nearest of each thing, at whatever height that is.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.skills.geometry.poses import wrap, yaw_of
from tandem.skills.ports.hardware import BaseVelocity

if TYPE_CHECKING:
    import numpy as np

    from tandem.sim.body import RobotBody
    from tandem.sim.parts import BasePart
    from tandem.sim.world import World

SPEED: Final = (0.10, 0.28)
"""m/s: slowest and fastest; always below the 0.3 m/s of the paper's R1 (RoCS, section 7)."""
TURN: Final = 0.5
"""rad/s: the most that it turns of its own accord, to either side."""
AWAY: Final = 0.8
"""rad/s at which it turns away."""
KEEP: Final = 0.3
"""Metres around it in which nothing should be."""
AHEAD: Final = math.radians(75.0)
"""To either side of its heading: what is close there stops it, and it turns on the spot."""
LOOK_EVERY: Final = 0.1
"""Robot seconds between two looks: three to a dead-man's time."""
WHIM: Final = (1.0, 4.0)
"""Robot seconds after which it drives another way: least and most."""


class Wanderer:
    """Commands the wheels of one robot. Call ``step`` once a period, before the hardware's.

    Args:
        body: the robot.
        base: its wheels.
        world: what is in its way.
        rng: source of its whims; nothing else is random.
    """

    def __init__(self, body: RobotBody, base: BasePart, world: World, rng: np.random.Generator) -> None:
        self._body, self._base, self._world, self._rng = body, base, world, rng
        self._period = body.model.description.period
        self._until_look = self._until_whim = 0.0
        self._linear = self._angular = 0.0
        self._side = 0.0
        """The side to which it is turning away: 1 left, -1 right, 0 not at all."""

    def step(self) -> None:
        """Let a period pass; look, when it is time, and command the wheels."""
        self._until_look -= self._period
        self._until_whim -= self._period
        if self._until_look > 0.0:
            return
        self._until_look = LOOK_EVERY
        if self._until_whim <= 0.0:
            self._until_whim = float(self._rng.uniform(*WHIM))
            self._linear = float(self._rng.uniform(*SPEED))
            self._angular = float(self._rng.uniform(-TURN, TURN))
        linear, angular = self._avoiding(self.close())
        self._base.controller.command(BaseVelocity(linear=linear, angular=angular))

    def close(self) -> list[tuple[float, float]]:
        """Return what is closer than ``KEEP``: its bearing (rad, left of the heading) and distance (m)."""
        (x, y, _), orientation = self._body.base_pose()
        heading = yaw_of(orientation)
        others = set(self._world.names_with_robots()) - {self._body.body, self._world.floor}
        return [
            (wrap(math.atan2(at[1] - y, at[0] - x) - heading), distance)
            for other in sorted(others)
            for at, distance in self._body.physics.near(self._body.body, other, KEEP)
        ]

    def _avoiding(self, close: list[tuple[float, float]]) -> tuple[float, float]:
        if not any(abs(bearing) < AHEAD for bearing, _ in close):
            self._side = 0.0
            return self._linear, self._angular
        if not self._side:
            # Kept until the way is free: in a corner the nearest changes sides with every look.
            nearest = min(close, key=lambda each: each[1])[0]
            self._side = -1.0 if nearest > 0.0 else 1.0
        return 0.0, self._side * AWAY
