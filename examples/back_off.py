"""Back off: a skill. It drives straight back, slowly, by its wheels alone.

A project names it in its ``pyproject.toml``::

    [project.entry-points."tandem.skills"]
    back_off = "my_robot_app.back_off:SKILL"

It imports nothing of Tandem but the public surface.
"""
# ruff: noqa: INP001 - an example: a file of its own

from __future__ import annotations

import math
from typing import Annotated, Final

from pydantic import Field

from tandem.api.skills import (
    BASE_VELOCITY,
    ODOMETRY,
    ActionType,
    BaseVelocity,
    Bus,
    Clocks,
    Command,
    Failure,
    FailureKind,
    Latest,
    Message,
    Odometry,
    Run,
    SkillType,
    canceled,
    failed,
    robot_seconds,
    succeeded,
)

SPEED: Final = 0.1
"""Metres a second."""
REST: Final = 0.005
"""Metres a second below which the base is at rest."""


class BackOffGoal(Message):
    """Drive straight back by ``distance`` metres."""

    distance: Annotated[float, Field(gt=0.0, le=0.5)]


class BackOffFeedback(Message):
    """Metres driven so far."""

    driven: float


class BackOffResult(Message):
    """Metres driven, by the wheels."""

    driven: float


BACK_OFF: Final = ActionType("base/back_off", BackOffGoal, BackOffFeedback, BackOffResult, timeout=15.0)


class BackOff:
    """The skill; an ``ActionServer`` makes it an action."""

    action = BACK_OFF
    period = 0.02

    def __init__(self, bus: Bus, clocks: Clocks) -> None:
        """Listen to the wheels."""
        self._bus, self._clocks, self._odometry = bus, clocks, Latest(bus, ODOMETRY)

    def check(self, goal: BackOffGoal) -> Failure | None:
        """Refuse before anything moves."""
        del goal
        if self._odometry.refresh() is None:
            return Failure(kind=FailureKind.NOT_READY, message="no odometry was heard", where=BACK_OFF.name)
        return None

    def run(self, goal: BackOffGoal, goal_id: str) -> Run[BackOffFeedback, BackOffResult]:
        """Drive until it is far enough or cancelled, then wait for rest."""
        del goal_id
        start, driven, canceling = self._base(), 0.0, False
        give_up = robot_seconds(self._clocks) + 2.0 + 3.0 * goal.distance / SPEED
        try:
            while driven < goal.distance and not canceling:
                if robot_seconds(self._clocks) > give_up:
                    evidence = {"driven_m": driven, "asked_m": goal.distance}
                    return failed(
                        Failure(kind=FailureKind.BASE_BLOCKED, message="stuck", evidence=dict(evidence))
                    )
                self._drive(-SPEED)
                canceling = (yield BackOffFeedback(driven=driven)) is Command.CANCEL
                driven = _between(start, self._base())
            self._drive(0.0)
            while not self._at_rest():
                yield BackOffFeedback(driven=driven)
                driven = _between(start, self._base())
            return canceled() if canceling else succeeded(BackOffResult(driven=driven))
        finally:
            self._drive(0.0)  # the last resort sends a stop and must not yield

    def _drive(self, linear: float) -> None:
        BASE_VELOCITY.publish(self._bus, BaseVelocity(linear=linear, angular=0.0))

    def _base(self) -> Odometry:
        heard = self._odometry.refresh()
        assert heard is not None  # check has seen to it
        return heard

    def _at_rest(self) -> bool:
        heard = self._odometry.refresh()
        return heard is not None and abs(heard.linear) < REST


def _between(one: Odometry, other: Odometry) -> float:
    """Return metres on the floor between two places, as the wheels tell them."""
    return math.dist((one.base_in_odom.x, one.base_in_odom.y), (other.base_in_odom.x, other.base_in_odom.y))


SKILL: Final = SkillType("back_off", lambda at: BackOff(at.bus, at.clocks), tells=(BASE_VELOCITY.key,))
