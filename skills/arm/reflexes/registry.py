"""The reflexes that come along for an arm with its hand: the files beside this one."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from tandem.skills.limbs import LimbOwner
from tandem.skills.ports.reflex import ARM, HAND

OWNER: Final = LimbOwner(resources=(ARM, HAND), shipped=MappingProxyType({}))
"""The process of each arm."""
