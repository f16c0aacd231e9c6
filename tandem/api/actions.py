"""The actions of the shipped skills that any task may call: what a goal and a result of each says."""

from __future__ import annotations

from tandem.skills.ports.actions.base import (
    DRIVE,
    LOCALISE,
    ROTATE,
    DriveGoal,
    DriveResult,
    LocaliseGoal,
    LocaliseResult,
    RotateGoal,
    RotateResult,
)
from tandem.skills.ports.actions.perception import LOOK, LookGoal, LookResult
from tandem.skills.ports.skill import ActionType

__all__ = [
    "DRIVE",
    "LOCALISE",
    "LOOK",
    "ROTATE",
    "ActionType",
    "DriveGoal",
    "DriveResult",
    "LocaliseGoal",
    "LocaliseResult",
    "LookGoal",
    "LookResult",
    "RotateGoal",
    "RotateResult",
]
