"""The cliff reflex: a base that comes to where the floor ends stands at once, and backs off a little."""

from __future__ import annotations

import logging
import math
from typing import Final

from tandem.skills.base.cliffs import Cliffs, Gap
from tandem.skills.base.macros import Macros
from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.base.whereabouts import base_in_map
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message, Positive
from tandem.skills.ports.reflex import BASE
from tandem.skills.ports.reflex_setting import Excess
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.reflexes import Act, ReflexType

log = logging.getLogger(__name__)

NAME: Final = "cliff"
PATIENCE: Final = 3.0
"""Times as long as the way back takes at its speed, after which something holds the base."""
STOPPED: Final = 0.15
"""Metres that the base may have gone on before it stood."""


BLIND: Final = (
    ", also after the base has gone back: clean the sensor, put the base elsewhere, or switch the reflex off"
)


class CliffParameters(Message):
    """Bounds in metres by which the floor is lower than it should be, and the way back."""

    drop: Excess = Excess(fires=0.03, releases=0.02)
    """A door sill of 2 cm is no edge; wheels of 35 mm climb out of what is 3 cm deep hardly."""
    clear: Positive = 0.06
    """Metres that the footprint keeps from the edge when the wheels are given back: a plan wants 3 cm."""
    speed: Positive = 0.10
    """m/s of the way back, where nothing may look."""


class CliffReflex:
    """Fires when the floor below a sensor is too low while a goal, or another reflex, has the wheels.

    It goes back once for each time that a sensor loses the floor. One that sees none where the base has just
    been is dirty, broken, or over a floor that is too dark for it; or the base is between two edges. Nothing
    looks behind the base, so it stands then, goal after goal, until the sensor sees a floor.
    """

    def __init__(self, at: BaseSurroundings, parameters: CliffParameters) -> None:
        assert at.cliffs is not None, "only robots with cliff sensors have it"
        self._at, self._how = at, parameters
        self._cliffs: Cliffs = at.cliffs
        self._acted = False
        self._blind: set[str] = set()
        """Sensors that saw no floor after the base had gone back for them."""

    def look(self, *, holds: bool) -> Failure | None:
        """Return where the floor ends."""
        pipeline, gaps = self._at.board.pipeline, self._gaps(holds=holds)
        self._blind.intersection_update(gap.sensor for gap in self._gaps(holds=True))
        if holds and self._acted:  # the wheels are given back: whoever drives on is stopped again
            return None
        if not gaps or not (pipeline.holder or pipeline.override):
            return None
        gap = gaps[0]
        here = base_in_map(self._at.localiser)
        return Failure(
            kind=FailureKind.BASE_BLOCKED,
            message=f"the floor ends: below {gap.sensor} it is at least {gap.drop:.2f} m lower"
            + (BLIND if gap.sensor in self._blind else ""),
            where=f"reflex/{NAME}",
            evidence={"sensor": gap.sensor, "drop_m": round(gap.drop, 3), "x_m": here.x, "y_m": here.y},
        )

    def act(self) -> Act:
        """Stand at once, then go back until the footprint is clear of the edge."""
        macros = self._at.macros(NAME, self._how.speed)
        self._acted = False
        seen = self._gaps(holds=True)
        edges = self._remember(seen, macros)
        macros.wheels.halt()
        for _ in macros.brake():
            yield macros.doing
        seen += self._gaps(holds=True)
        if not seen or self._blind.issuperset(gap.sensor for gap in seen):
            self._acted = True
            return
        edges += self._remember(self._gaps(holds=True), macros)
        away = self._at.description.footprint_radius + self._how.clear
        until = robot_seconds(self._at.clocks) + PATIENCE * (away + STOPPED) / self._how.speed

        def done() -> bool:
            near = min(macros.distance(*edge) for edge in edges)
            return near > away or robot_seconds(self._at.clocks) > until

        # Away from the sensor that sees it: one before the axle sends the base back.
        for _ in macros.set_wheel_speed(-math.copysign(self._how.speed, seen[0].x), 0.0, done):
            yield macros.doing
        for _ in macros.brake():
            yield macros.doing
        self._blind.update(gap.sensor for gap in self._gaps(holds=True))
        if self._blind:
            log.warning("no floor below %s where the base has just been: it stands", ", ".join(self._blind))
        self._acted = True

    def _gaps(self, *, holds: bool) -> list[Gap]:
        """Return where the floor is too low, the lowest first."""
        return [gap for gap in self._cliffs.gaps if self._how.drop.above(gap.drop, holds=holds)]

    def _remember(self, gaps: list[Gap], macros: Macros) -> list[tuple[float, float]]:
        return [self._cliffs.remember(gap, macros.pose) for gap in gaps]

    def close(self) -> None:
        """Nothing to leave: the monitor has the subscription."""


def _needs(robot: RobotDescription) -> str:
    return "" if robot.cliff_sensors and robot.drive is not None else "a cliff sensor and a drive"


REFLEX: Final = ReflexType(
    name=NAME,
    about="stops the base where the floor ends, and backs off a little",
    protects="the robot, and who is below, from a fall down stairs or over an edge",
    resources=(BASE,),
    rank=95,
    parameters=CliffParameters,
    needs=_needs,
    make=CliffReflex,
)
