"""Would it help to wait until the skill, the sensor or the hardware is back?"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset(
    (
        FailureKind.BUSY,
        FailureKind.NOT_READY,
        FailureKind.NOT_STORED,
        FailureKind.TIMED_OUT,
        FailureKind.SKILL_LOST,
        FailureKind.SKILL_CRASHED,
        FailureKind.HARDWARE_LOST,
        FailureKind.CAMERA_SILENT,
        FailureKind.CAMERA_BLIND,
        FailureKind.LASER_SILENT,
        FailureKind.BASE_HELD,
        FailureKind.ARMS_CROSSING,
    )
)


def waiting_helps(failure: Failure) -> bool:
    """Say whether the cause passes by itself."""
    return failure.kind in KINDS
