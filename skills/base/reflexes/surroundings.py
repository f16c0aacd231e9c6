"""What the base's reflexes are made with, and how they brake."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from tandem.skills.base.guard import Guard
from tandem.skills.base.macros import Macros
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.surround import Surround
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.hardware import RobotDescription
from tandem.skills.reflexes import Act

GIVE_UP: Final = 5.0
"""Robot seconds of braking after which a base that still moves is nobody's to stop."""


@dataclass(frozen=True)
class BaseSurroundings:
    """What a reflex of the base may look at, and command once it has the wheels."""

    bus: Bus
    clocks: Clocks
    description: RobotDescription
    localiser: Whereabouts
    guard: Guard
    board: BaseStatusBoard
    surround: Surround | None = None
    """What range sensors see; None for a robot without any."""

    def wheels(self, reflex: str) -> Wheels:
        """Return the wheels as a reflex commands them, from the speeds that odometry tells."""
        pipeline = self.board.pipeline
        made = Wheels(self.bus, self.clocks, self.description.driven, lambda: pipeline.high(reflex))
        odometry = self.localiser.odometry
        made.begin(*((0.0, 0.0) if odometry is None else (odometry.linear, odometry.angular)))
        return made

    def macros(self, reflex: str, speed: float) -> Macros:
        """Return the actions of the base, with the wheels as a reflex has them; ``speed``: m/s at most."""
        return Macros(self.clocks, self.localiser, self.wheels(reflex), lambda: speed)

    def brake(self, reflex: str) -> Act:
        """Brake within the drive's limits, until the base stands."""
        wheels, begun = self.wheels(reflex), robot_seconds(self.clocks)
        while True:
            wheels.send(0.0, 0.0)
            yield ("SetWheelSpeed",)
            stands = wheels.resting and not self.localiser.moving
            if stands or robot_seconds(self.clocks) - begun > GIVE_UP:
                return
