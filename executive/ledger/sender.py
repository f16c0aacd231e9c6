"""Who sent a request: stands in the stored document, under a field that clients can't set."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from pydantic import JsonValue

BY_FIELD: Final = "by"
"""Who asked, by the key of the request; put there by ``tandem.executive.service.intake.client_gateway``."""
ANYBODY: Final = ""
"""Who came by a key without a name."""


def asked_by(document: Mapping[str, JsonValue]) -> str:
    """Return who asked, out of a document with the sender's name."""
    return str(document.get(BY_FIELD, ANYBODY))
