"""What can go wrong while two arms hold one thing, or are on their way to it."""

from __future__ import annotations

from typing import Final

from tandem.skills.bimanual.hold import TwoArms
from tandem.skills.bimanual.object_frame import tilt
from tandem.skills.bimanual.squeeze import TOUCH
from tandem.skills.ports.actions.bimanual import PAIR, TWO_HANDS
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.reflex import PipelineState

STRAYED: Final = 0.12
"""Radians by which an arm may be off what it was told before it is said to have failed."""
LEVEL: Final = 0.0524
"""Radians (3 degrees) by which what is held may lean."""


def trouble(arms: TwoArms, *, holding: bool, level: Pose | None = None) -> Failure | None:
    """Return why a goal must end: an arm does not follow, the thing is lost, or it leans. None: it goes on.

    Args:
        arms: as they stand now.
        holding: whether both hands press on the thing.
        level: how the hands' middle stood before, in the base; None: it may lean as it does.
    """
    if arms.stopped:
        return _failure(FailureKind.HARDWARE_STOPPED, "the hardware's stop is set")
    if not arms.leading:
        return _let_go(arms)
    off, side = arms.strayed()
    if off > STRAYED:
        return _failure(
            FailureKind.ARM_STOPPED,
            f"the {side} arm is {off:.3f} rad off what it was told",
            arm=side,
            error_rad=round(off, 3),
        )
    if holding and min(arms.forces) < TOUCH:
        lost = PAIR[0] if arms.forces[0] < arms.forces[1] else PAIR[1]
        return _failure(
            FailureKind.GRASP_LOST, f"the {lost} hand presses with {min(arms.forces):.1f} N only", arm=lost
        )
    held = arms.held_middle() if level is not None else None
    if held is not None and level is not None and (leaning := tilt(level, held)) > LEVEL:
        return _failure(
            FailureKind.TILTED, f"the hands lean by {leaning:.3f} rad", tilt_rad=round(leaning, 4)
        )
    return None


def _let_go(arms: TwoArms) -> Failure:
    if arms.taken is not None:
        return overridden(FailureKind.OVERRIDDEN, arms.taken)
    return _failure(FailureKind.ARM_STOPPED, "somebody else moves one of the arms")


def overridden(kind: FailureKind, taken: PipelineState) -> Failure:
    """Return that a reflex has an arm; ``kind``: ``OVERRIDDEN`` for a goal under way, else ``BUSY``."""
    saw = "" if taken.why is None else f": {taken.why.message}"
    failure = _failure(kind, f"reflex {taken.reflex} has the {taken.resource}{saw}", reflex=taken.reflex)
    return failure if taken.why is None else failure.model_copy(update={"causes": (taken.why,)})


def _failure(kind: FailureKind, message: str, **evidence: str | float) -> Failure:
    return Failure(kind=kind, message=message, where=TWO_HANDS.name, evidence=evidence)
