"""Reflexes: what they watch, their action, and what those of the base, an arm or the head are made with."""

from __future__ import annotations

from tandem.skills.base.macros import Macros
from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.base.surround import Echo, Surround
from tandem.skills.limbs import LimbSurroundings
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Message
from tandem.skills.ports.reflex import ARM, BASE, HAND, HEAD
from tandem.skills.ports.reflex_setting import ReflexSetting, Threshold
from tandem.skills.reflexes import Act, Reflex, ReflexType

__all__ = [
    "ARM",
    "BASE",
    "HAND",
    "HEAD",
    "Act",
    "BaseSurroundings",
    "Echo",
    "Failure",
    "FailureKind",
    "LimbSurroundings",
    "Macros",
    "Message",
    "Reflex",
    "ReflexSetting",
    "ReflexType",
    "Surround",
    "Threshold",
]
