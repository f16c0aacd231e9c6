"""The reflexes that come along for the head: none, since what turns it watches all that it needs to."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from tandem.skills.limbs import LimbOwner
from tandem.skills.ports.reflex import HEAD

OWNER: Final = LimbOwner(resources=(HEAD,), shipped=MappingProxyType({}))
"""The process of perception, which commands the head."""
