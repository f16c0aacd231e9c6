"""The base's guard: what must hold while it drives, and stops it when it holds no more."""

from __future__ import annotations

from typing import Final

from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import BASE
from tandem.skills.reflexes import Act, ReflexType

NAME: Final = "base_guard"


class BaseGuardParameters(Message):
    """Nothing to set."""


class BaseGuardReflex:
    """Fires when the guard would refuse to let the base move, while a goal has the wheels."""

    def __init__(self, at: BaseSurroundings, parameters: BaseGuardParameters) -> None:  # noqa: ARG002
        self._at = at

    def look(self, *, holds: bool) -> Failure | None:
        """Return the first reason not to move."""
        board = self._at.board
        if holds or not board.holder:
            return None
        return self._at.guard.refusal(f"reflex/{NAME}", anywhere=board.anywhere)

    def act(self) -> Act:
        """Brake."""
        return self._at.brake(NAME)

    def close(self) -> None:
        """Nothing to leave: the guard has the subscriptions."""


REFLEX: Final = ReflexType(
    name=NAME,
    about="brakes the base when the stop is set, a sensor is silent, an arm is stretched out, or it is lost",
    protects="people and furniture from a base that drives blind, lost or with an arm stretched out",
    resources=(BASE,),
    rank=80,
    parameters=BaseGuardParameters,
    needs=lambda robot: "" if robot.drive is not None else "a drive",
    make=BaseGuardReflex,
)
