"""An item in a document: its number, or the name that the site gives it. The reader's code has the number.

The names stand in the site file, so a document is read with the site as the context of the validation.
"""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import AliasChoices, BeforeValidator, Field, ValidationInfo

from tandem.skills.ports.site import LAST_ITEM, Site

ITEM_OR_TAG: Final = AliasChoices("item", "tag")
"""The key of an item in scenarios and faults, and what it was up to release 0.1.0, when each had a tag."""


def numbered(said: object, info: ValidationInfo) -> object:
    """Return the number of a named item; whatever else was said is left to the validation.

    Raises:
        ValueError: when the site has no item of that name, or is not known to who reads.
    """
    if not isinstance(said, str):
        return said
    site = info.context
    if not isinstance(site, Site):
        raise ValueError("expected a number: only who knows the site can read a name")  # noqa: TRY004 - pydantic's
    named = None if said.isdecimal() else site.meant(said)  # a number is said as one
    if named is None:
        raise ValueError(f"expected one of the site's items: {site.item_words()}")
    return named.item


NamedItem = Annotated[int, Field(ge=0, le=LAST_ITEM), BeforeValidator(numbered)]
"""An item in a scenario or a fault: its number, for which a file may say its name."""
