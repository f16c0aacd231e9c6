"""The arm's guard: an arm whose joints nobody hears any more is brought to rest."""

from __future__ import annotations

from typing import Final

from tandem.skills.arm.silence import SILENT_AFTER, joints_silent
from tandem.skills.limbs import LimbSurroundings
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import ARM
from tandem.skills.reflexes import Act, ReflexType

NAME: Final = "arm_guard"


class ArmGuardParameters(Message):
    """Nothing to set."""


class ArmGuardReflex:
    """Fires when the joint states fall silent while a goal has the arm.

    Before the first of them has come there is nothing to fall silent: skills say by themselves what they
    lack.
    """

    def __init__(self, at: LimbSurroundings, parameters: ArmGuardParameters) -> None:  # noqa: ARG002
        self._at = at

    def look(self, *, holds: bool) -> Failure | None:
        """Return that nobody sees what the arm does; once it is at rest, that is no reason any more."""
        holder = self._at.pipelines[ARM].holder
        if holds or not holder:
            return None
        newest = self._at.joints.refresh()
        if newest is None or not joints_silent(newest, self._at.clocks):
            return None
        return Failure(
            kind=FailureKind.HARDWARE_LOST,
            message=f"no joint states for {SILENT_AFTER} s while {holder} had {self._at.group}",
            where=f"reflex/{self._at.called(NAME)}",
            evidence={"silent_s": SILENT_AFTER},
        )

    def act(self) -> Act:
        """Bring the arm to rest."""
        return self._at.halt(NAME)

    def close(self) -> None:
        """Nothing to leave: the surroundings have the subscriptions."""


REFLEX: Final = ReflexType(
    name=NAME,
    about="brings an arm to rest when its joint states fall silent",
    protects="people and furniture from an arm that moves unseen",
    resources=(ARM,),
    rank=80,
    parameters=ArmGuardParameters,
    needs=lambda robot: "" if robot.hands else "an arm",
    make=ArmGuardReflex,
)
