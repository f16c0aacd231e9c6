"""What the base's reflexes are made with, and how they brake."""

from __future__ import annotations

from dataclasses import dataclass

from tandem.skills.base.cliffs import Cliffs
from tandem.skills.base.guard import Guard
from tandem.skills.base.macros import Macros
from tandem.skills.base.status import BaseStatusBoard
from tandem.skills.base.surround import Surround
from tandem.skills.base.wheels import Wheels
from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.reflexes import Act


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
    cliffs: Cliffs | None = None
    """What cliff sensors see; None for a robot without any."""

    def wheels(self, reflex: str) -> Wheels:
        """Return the wheels as a reflex commands them, from the speeds that odometry tells."""
        pipeline = self.board.pipeline
        made = Wheels(self.bus, self.clocks, self.description.driven, lambda: pipeline.high(reflex))
        made.begin(self.localiser.odometry)
        return made

    def macros(self, reflex: str, speed: float) -> Macros:
        """Return the actions of the base, with the wheels as a reflex has them; ``speed``: m/s at most."""
        return Macros(self.clocks, self.localiser, self.wheels(reflex), lambda: speed)

    def brake(self, reflex: str) -> Act:
        """Brake within the drive's limits, until the base stands."""
        macros = self.macros(reflex, 0.0)
        for _ in macros.brake():
            yield macros.doing
