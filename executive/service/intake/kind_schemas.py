"""The kinds of task as data: their summaries, and the JSON Schemas of their requests."""

from __future__ import annotations

from collections.abc import Mapping

from pydantic import JsonValue, TypeAdapter

from tandem.executive.service.intake.envelope import Envelope
from tandem.executive.service.intake.request_parser import ID_FIELD, KIND_FIELD, MAX_ID
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import KindOfTask, TaskKinds
from tandem.trees.task import TaskType


def kinds_offered(kinds: Mapping[str, TaskType[Message]], site: Site | None = None) -> TaskKinds:
    """Return the kinds with their schemas, each whole in itself, and the items of the site."""
    return TaskKinds(
        kinds=tuple(
            KindOfTask(name=kind.name, summary=kind.summary, request=request_schema(kind))
            for kind in kinds.values()
        ),
        items=() if site is None else tuple(str(each.item) for each in site.items),
        names={} if site is None else {each.name: each.item for each in site.items if each.name},
    )


def request_schema(kind: TaskType[Message]) -> dict[str, JsonValue]:
    """Return the schema of a request as a client sends it, with the definitions that it refers to."""
    return with_envelope(_schema(kind.request), kind)


def with_envelope(schema: JsonValue, kind: TaskType[Message]) -> dict[str, JsonValue]:
    """Return a request's schema with what the executive takes beside the model's own fields."""
    assert isinstance(schema, dict)
    properties, required = schema.get("properties"), schema.get("required", [])
    assert isinstance(properties, dict)
    assert isinstance(required, list)
    task: JsonValue = {"const": kind.name, "description": "The kind of task.", "type": "string"}
    own: JsonValue = {
        "description": "The client's own name for the request; sent again, it starts nothing new.",
        "maxLength": MAX_ID,
        "type": "string",
    }
    envelope = _schema(Envelope)["properties"]
    assert isinstance(envelope, dict)
    said = {name: value for name, value in envelope.items() if name not in properties}
    return {
        **schema,
        "properties": {**properties, **said, KIND_FIELD: task, ID_FIELD: own},
        "required": [KIND_FIELD, *(name for name in required if name != KIND_FIELD)],
    }


def _schema(model: type[Message]) -> dict[str, JsonValue]:
    return TypeAdapter(dict[str, JsonValue]).validate_python(model.model_json_schema())
