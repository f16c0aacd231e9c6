"""The reflexes that come along for the base: the files beside this one."""

from __future__ import annotations

from types import MappingProxyType
from typing import Any, Final

from tandem.skills.base.reflexes import approach, avoid_collision, base_guard, bumper, cliff
from tandem.skills.base.reflexes.surroundings import BaseSurroundings
from tandem.skills.ports.reflex import BASE
from tandem.skills.reflex_owners import Owner
from tandem.skills.reflexes import ReflexType

BaseReflex = ReflexType[BaseSurroundings, Any]
"""A reflex of the base, whatever its parameters."""

OWNER: Final = Owner[BaseSurroundings](
    resources=(BASE,),
    shipped=MappingProxyType(
        {each.REFLEX.name: each.REFLEX for each in (cliff, bumper, base_guard, avoid_collision, approach)}
    ),
)
"""The base's process."""
