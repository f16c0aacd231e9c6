"""The interface as an AsyncAPI 3.0 document, out of the same table as docs/interface.md.

Told as AsyncAPI wants it, from the side that serves a key: what is queried is *received* and replied to, what
is published is *sent*. Clients do the opposite. See https://www.asyncapi.com/docs/reference/specification/v3.0.0.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from importlib.metadata import version
from typing import Final

from pydantic import JsonValue, TypeAdapter
from pydantic.json_schema import models_json_schema

from tandem.executive.interface.entries import Entry, entries
from tandem.executive.interface.field_docs import first_paragraph
from tandem.executive.service.intake.kind_schemas import with_envelope
from tandem.skills.ports.keys import Topic, rgbd
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import REQUEST, TASK_PICTURE, AskPicture, TaskAnswer
from tandem.trees.task import TaskType

ASYNCAPI: Final = "3.0.0"
PREFIX: Final = "{site}/{robot}/"
GROUPS: Final = ("clients", "world", "hardware")
"""What others than Tandem's own processes send and read: clients, viewers, and who brings a robot."""
_JSON: Final[TypeAdapter[dict[str, JsonValue]]] = TypeAdapter(dict[str, JsonValue])
_PARAMETER: Final = re.compile(r"<(\w+)>")
_ABOUT: Final[Mapping[str, JsonValue]] = {
    "site": {"description": "First part of every key.", "default": "lab"},
    "robot": {"description": "Second part of every key.", "default": "tiago"},
    "id": {"description": "A task's id, as the answer to its request tells it."},
    "group": {"description": "A joint group of the robot's description, such as arm_left."},
    "side": {"description": "A hand of the robot's description, such as left."},
    "camera": {"description": "A camera of the robot's description, such as head."},
    "name": {"description": "A sensor of the robot's description, such as base."},
}
_BINARY: Final[Mapping[str, tuple[str, str]]] = {
    "Picture": ("image/jpeg", "The camera's picture of an attempt; empty when it is not kept (any more)."),
    "RgbdPicture": (
        "application/octet-stream",
        "RgbdHeader as JSON, then the pixels (skills/ports/image.py).",
    ),
}
"""Messages that are no JSON: what type they are of, and what they hold."""


def asyncapi(kinds: Mapping[str, TaskType[Message]]) -> dict[str, JsonValue]:
    """Return the document.

    Args:
        kinds: the kinds of task, whose requests are told.
    """
    found = [(group, entry) for group in GROUPS for entry in entries()[group]]
    models = dict.fromkeys(model for _, entry in found for model in _models(entry))
    models |= dict.fromkeys([TaskAnswer, AskPicture])
    channels: dict[str, JsonValue] = {_name(REQUEST): _request_channel(kinds)}
    operations: dict[str, JsonValue] = {_name(REQUEST): _request_operation(kinds)}
    for group, entry in found:
        channels[_name(entry.key)] = _channel(entry.key, [each.__name__ for each in _models(entry)])
        operations[_name(entry.key)] = _operation(group, entry)
    pictures = rgbd("<camera>")
    channels[_name(pictures)] = _channel(pictures, ["RgbdPicture"])
    operations[_name(pictures)] = _sent("hardware", pictures, "RgbdPicture")
    channels[_name(TASK_PICTURE)] = _channel(TASK_PICTURE, ["AskPicture", "Picture"])
    operations[_name(TASK_PICTURE)] = _replied("clients", TASK_PICTURE, ["AskPicture"], ["Picture"])
    return {
        "asyncapi": ASYNCAPI,
        "info": {
            "title": "Tandem",
            "version": version("tandem-executive"),
            "description": "A task executive for mobile, two-armed robots, over zenoh and JSON.",
            "license": {"name": "Apache-2.0"},
        },
        "defaultContentType": "application/json",
        "servers": {"router": {"host": "127.0.0.1:7447", "protocol": "zenoh"}},
        "channels": channels,
        "operations": operations,
        "components": {
            "messages": _messages([*kinds.values()], list(models)),
            "schemas": _schemas(kinds, list(models)),
        },
    }


def _request_channel(kinds: Mapping[str, TaskType[Message]]) -> JsonValue:
    return _channel(REQUEST, [*(kind.request.__name__ for kind in kinds.values()), TaskAnswer.__name__])


def _request_operation(kinds: Mapping[str, TaskType[Message]]) -> JsonValue:
    return _replied("clients", REQUEST, [kind.request.__name__ for kind in kinds.values()], ["TaskAnswer"])


def _models(entry: Entry) -> list[type[Message]]:
    return [entry.model] if isinstance(entry, Topic) else [entry.asked, entry.answered]


def _channel(key: str, messages: list[str]) -> JsonValue:
    address = PREFIX + _PARAMETER.sub(r"{\1}", key)
    names = re.findall(r"{(\w+)}", address)
    return {
        "address": address,
        "parameters": {name: _ABOUT.get(name, {}) for name in names},
        "messages": {name: {"$ref": f"#/components/messages/{name}"} for name in dict.fromkeys(messages)},
    }


def _operation(group: str, entry: Entry) -> JsonValue:
    if isinstance(entry, Topic):
        return _sent(group, entry.key, entry.model.__name__)
    return _replied(group, entry.key, [entry.asked.__name__], [entry.answered.__name__])


def _sent(group: str, key: str, message: str) -> JsonValue:
    return {
        "action": "send",
        "channel": {"$ref": f"#/channels/{_name(key)}"},
        "messages": _in_channel(key, [message]),
        "tags": [{"name": group}],
    }


def _replied(group: str, key: str, asked: list[str], answered: list[str]) -> JsonValue:
    channel: JsonValue = {"$ref": f"#/channels/{_name(key)}"}
    return {
        "action": "receive",
        "channel": channel,
        "messages": _in_channel(key, asked),
        "reply": {"channel": channel, "messages": _in_channel(key, answered)},
        "tags": [{"name": group}],
    }


def _in_channel(key: str, messages: list[str]) -> JsonValue:
    return [{"$ref": f"#/channels/{_name(key)}/messages/{name}"} for name in messages]


def _messages(kinds: list[TaskType[Message]], models: list[type[Message]]) -> dict[str, JsonValue]:
    found: dict[str, JsonValue] = {
        model.__name__: {
            "name": model.__name__,
            "summary": first_paragraph(model),
            "payload": {"$ref": f"#/components/schemas/{model.__name__}"},
        }
        for model in [*(kind.request for kind in kinds), *models]
    }
    for name, (kind, summary) in _BINARY.items():
        payload: JsonValue = {"type": "string", "contentMediaType": kind, "contentEncoding": "binary"}
        found[name] = {"name": name, "summary": summary, "contentType": kind, "payload": payload}
    return dict(sorted(found.items()))


def _schemas(kinds: Mapping[str, TaskType[Message]], models: list[type[Message]]) -> dict[str, JsonValue]:
    requests = [kind.request for kind in kinds.values()]
    _, made = models_json_schema(
        [(model, "validation") for model in [*requests, *models]],
        ref_template="#/components/schemas/{model}",
    )
    schemas = _JSON.validate_python(made["$defs"])
    for kind in kinds.values():
        schemas[kind.request.__name__] = with_envelope(schemas[kind.request.__name__], kind)
    return {name: _as_draft_7(schema) for name, schema in sorted(schemas.items())}


def _as_draft_7(schema: JsonValue) -> JsonValue:
    """Return a schema as AsyncAPI reads it: what 2020-12 calls ``prefixItems`` was ``items``."""
    if isinstance(schema, list):
        return [_as_draft_7(each) for each in schema]
    if not isinstance(schema, dict):
        return schema
    return {
        ("items" if name == "prefixItems" else name): _as_draft_7(value) for name, value in schema.items()
    }


def _name(key: str) -> str:
    """Return a key as a name that AsyncAPI allows: letters, digits, hyphens and underscores."""
    return "-".join(part.strip("<>") for part in key.split("/"))
