"""The JSON Schemas of what is put on the bus, by key: out of the interface's own table."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Final

from tandem.executive.interface.entries import all_entries
from tandem.executive.records.mcap_writing import Schema
from tandem.skills.ports.keys import Topic
from tandem.skills.ports.match import matches
from tandem.skills.ports.message import Message

_NAMED: Final = re.compile("<[^>]+>")


class JsonSchemas:
    """Finds them; each model's is made once."""

    def __init__(self) -> None:
        self._models: Mapping[str, type[Message]] = {
            _NAMED.sub("*", entry.key): entry.model for entry in all_entries() if isinstance(entry, Topic)
        }
        self._made: dict[type[Message], Schema] = {}

    def of(self, key: str) -> Schema | None:
        """Return the schema of a key's messages; None for a key that nobody declares, as a plug-in's."""
        model = self._models.get(key) or next(
            (model for expression, model in self._models.items() if matches(expression, key)), None
        )
        if model is None:
            return None
        if model not in self._made:
            schema = {**model.model_json_schema(), "title": f"tandem.{model.__name__}"}
            self._made[model] = Schema(schema["title"], "jsonschema", json.dumps(schema).encode())
        return self._made[model]
