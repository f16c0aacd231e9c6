"""An item in a request: its number, or the name that the site gives it.

A request's model declares the field as ``ItemNumber``; its tree then has a number, whichever the client said.
The names stand in the site file. So a request is read with the site as the context of the validation.
"""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import BeforeValidator, Field, WithJsonSchema

from tandem.skills.ports.item_number import numbered
from tandem.skills.ports.site import LAST_ITEM, MAX_NAME

_SAID: Final = "number of the item (if it bears a tag, that of the tag), or its name at this site"

ItemNumber = Annotated[
    int,
    BeforeValidator(numbered),
    Field(ge=0, le=LAST_ITEM, description=_SAID),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "integer", "minimum": 0, "maximum": LAST_ITEM},
                {"type": "string", "minLength": 1, "maxLength": MAX_NAME},
            ],
            "description": _SAID,
        }
    ),
]
"""A field of a request: the number of an item, for which a client may say the item's name at the site."""
