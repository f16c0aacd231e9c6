"""The reflexes that come along for an arm with its hand: the files beside this one."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from tandem.skills.arm.reflexes import arm_guard
from tandem.skills.limbs import LimbOwner
from tandem.skills.ports.reflex import ARM, HAND

OWNER: Final = LimbOwner(
    resources=(ARM, HAND),
    shipped=MappingProxyType({each.REFLEX.name: each.REFLEX for each in (arm_guard,)}),
)
"""The process of each arm."""
