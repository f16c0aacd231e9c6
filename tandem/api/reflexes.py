"""Reflexes of the base: what they watch, their action, and what they are made with."""

from __future__ import annotations

from tandem.skills.base.macros import Macros
from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.base.surround import Echo, Surround
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import BASE
from tandem.skills.ports.reflex_setting import ReflexSetting, Threshold
from tandem.skills.reflexes import Act, Reflex, ReflexType

__all__ = [
    "BASE",
    "Act",
    "BaseSurroundings",
    "Echo",
    "Failure",
    "FailureKind",
    "Macros",
    "Message",
    "Reflex",
    "ReflexSetting",
    "ReflexType",
    "Surround",
    "Threshold",
]
