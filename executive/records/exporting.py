"""A record as JSON lines: one object a message, for tools that know neither of its layouts."""

from __future__ import annotations

import base64
import json
from collections import Counter
from collections.abc import Iterator

from tandem.executive.records.recording import Recorded, Recording
from tandem.skills.ports.match import matches
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.plain_json import read_json


class KeyCount(Message):
    """How much a record has of a key."""

    key: str
    messages: Count
    size: Count
    """Bytes of their payloads."""


def exported(record: Recording, expression: str = "**") -> Iterator[str]:
    """Yield a line for each message whose key matches: key, at, boot, seconds, host and the document."""
    for message in record.messages():
        if matches(expression, message.key):
            yield _line(message)


def counts(record: Recording) -> tuple[KeyCount, ...]:
    """Return how much there is of each key, by key."""
    number, size = Counter[str](), Counter[str]()
    for message in record.messages():
        number[message.key] += 1
        size[message.key] += len(message.payload)
    return tuple(KeyCount(key=key, messages=number[key], size=size[key]) for key in sorted(number))


def _line(message: Recorded) -> str:
    stamp = message.stamp
    told: dict[str, object] = {
        "key": message.key,
        "at": message.at,
        "time": None if stamp is None else stamp.model_dump(),
        "host": message.host,
    }
    try:
        told["message"] = read_json(message.payload)
    except ValueError:
        told["base64"] = base64.b64encode(message.payload).decode()
    return json.dumps(told, ensure_ascii=False, separators=(",", ":"))
