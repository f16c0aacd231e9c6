"""How the documents in the ledger's rows are read, which a newer version may have written."""

from __future__ import annotations

from typing import Protocol, TypeVar

from pydantic import JsonValue, TypeAdapter, ValidationError

from tandem.skills.ports.message import Message, read_leniently

M = TypeVar("M", bound=Message)


class Reader(Protocol):
    """One of the two ways."""

    def __call__(self, model: type[M], document: bytes) -> M:
        """Return the message of a document; a ValidationError, when it can't be read."""


def whole(model: type[M], document: bytes) -> M:
    """Read every field, for a task that goes on: what is not understood may say how it must not.

    Raises:
        ValidationError: pydantic's, also of a field that this version does not know.
    """
    return model.model_validate_json(document)


def known_part(model: type[M], document: bytes) -> M:
    """Read what this version knows, for people: fields that it can't read are left out.

    Raises:
        ValidationError: pydantic's, when a field without a default can't be read.
    """
    try:
        return read_leniently(model, document)
    except ValidationError as error:
        odd = {str(each["loc"][0]) for each in error.errors() if each["loc"]}
        if not odd or any(
            name not in model.model_fields or model.model_fields[name].is_required() for name in odd
        ):
            raise
        fields = TypeAdapter(dict[str, JsonValue])
        told = fields.validate_json(document)
        return read_leniently(model, fields.dump_json({name: told[name] for name in told.keys() - odd}))
