"""Approaching a place without a plan: the lowest reflex, for a base that is to act by reflexes alone.

It steers to where the place is now, in each cycle anew, and remembers nothing; whatever ranks above it takes
the wheels. It is off unless somebody switches it on, or declares it: RoCS paper, 2.2, has such robots as the
purely reactive ones.
"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.base.whereabouts import base_in_map
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message, Positive
from tandem.skills.ports.reflex import BASE
from tandem.skills.ports.reflex_setting import Threshold
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.reflexes import Act, ReflexType

NAME: Final = "approach"
STEER: Final = 1.5
"""rad/s for each radian off the way, as a goal that goes there steers."""


class ApproachParameters(Message):
    """A place in the map (m), and how the base gets there."""

    x: float = 0.0
    y: float = 0.0
    near: Threshold = Threshold(fires=0.12, releases=0.20)
    """Metres from the place: where the base is there, and from where on it sets out again."""
    speed: Positive = 0.40
    """m/s."""


class ApproachReflex:
    """Fires while the place is far, and the base may move."""

    def __init__(self, at: BaseSurroundings, parameters: ApproachParameters) -> None:
        self._at, self._how = at, parameters
        self._there = False

    def look(self, *, holds: bool) -> Failure | None:  # noqa: ARG002
        """Return how far it is, unless the base is there, or a goal has the wheels, or it may not move."""
        here = base_in_map(self._at.localiser)
        left = math.dist((here.x, here.y), (self._how.x, self._how.y))
        self._there = self._how.near.below(left, holds=self._there)
        if self._there or self._at.board.holder or self._at.guard.refusal(f"reflex/{NAME}") is not None:
            return None
        return Failure(
            kind=FailureKind.BASE_OFF_GOAL,
            message=f"its place is {left:.2f} m away",
            where=f"reflex/{NAME}",
            evidence={"left_m": round(left, 3)},
        )

    def act(self) -> Act:
        """Steer to the place until it is near, then brake."""
        macros = self._at.macros(NAME, self._how.speed)
        with macros.named("Approach"):
            while macros.distance(self._how.x, self._how.y) > self._how.near.fires and not self._there:
                if self._at.guard.refusal(f"reflex/{NAME}") is not None:
                    break
                bearing = macros.bearing(self._how.x, self._how.y)
                # Slower the more it has to turn, and not at all sideways or back.
                macros.wheels.send(self._how.speed * max(0.0, math.cos(bearing)), STEER * bearing)
                yield macros.doing
            for _ in macros.brake():
                yield macros.doing

    def close(self) -> None:
        """Nothing to leave: it has no subscription."""


def _needs(robot: RobotDescription) -> str:
    if robot.drive is None:
        return "a drive"
    return "" if robot.lasers or robot.pose_sensors else "a sensor of where it is"


REFLEX: Final = ReflexType(
    name=NAME,
    about="steers the base to a place without a plan, while no goal has the wheels",
    resources=(BASE,),
    rank=10,
    parameters=ApproachParameters,
    needs=_needs,
    make=ApproachReflex,
    armed=False,
)
