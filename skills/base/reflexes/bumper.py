"""The bumper: what the base touches on its way makes it brake."""

from __future__ import annotations

from typing import Final

from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.base.whereabouts import base_in_map
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import BASE
from tandem.skills.reflexes import Act, ReflexType

NAME: Final = "bumper"


class BumperParameters(Message):
    """Nothing to set."""


class BumperReflex:
    """Fires when a bumper is pressed that was not when the goal, or another reflex, got the wheels."""

    def __init__(self, at: BaseSurroundings, parameters: BumperParameters) -> None:  # noqa: ARG002
        self._at = at
        self._since = (-1, -1)
        self._before: tuple[str, ...] = ()

    def look(self, *, holds: bool) -> Failure | None:
        """Return what was touched, while a goal or another reflex has the wheels."""
        touching, pipeline = self._at.guard.touching, self._at.board.pipeline
        if holds or not (pipeline.holder or pipeline.override):
            return None
        since = (pipeline.claims, pipeline.mark())
        if since != self._since:
            # What pressed already when the motion began must not keep the base from leaving it.
            self._since, self._before = since, touching
        touched = [name for name in touching if name not in self._before]
        if not touched:
            return None
        here = base_in_map(self._at.localiser)
        return Failure(
            kind=FailureKind.BASE_BLOCKED,
            message="the base touched something",
            where=f"reflex/{NAME}",
            evidence={"bumper": touched[0], "x_m": here.x, "y_m": here.y},
        )

    def act(self) -> Act:
        """Brake."""
        return self._at.brake(NAME)

    def close(self) -> None:
        """Nothing to leave: the guard has the subscription."""


REFLEX: Final = ReflexType(
    name=NAME,
    about="brakes the base when it touches something that it did not touch when its motion began",
    protects="people and furniture from a base that goes on although it touches them",
    resources=(BASE,),
    rank=90,
    parameters=BumperParameters,
    needs=lambda robot: "" if robot.drive is not None else "a drive",
    make=BumperReflex,
)
