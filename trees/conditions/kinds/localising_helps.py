"""Would it help to find out anew where the robot is?"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset((FailureKind.NOT_LOCALISED,))


def localising_helps(failure: Failure) -> bool:
    """Say whether the robot's own pose is what is missing."""
    return failure.kind in KINDS
