"""JSON Schemas of all that a client sends or reads."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from pydantic import JsonValue, TypeAdapter
from pydantic.json_schema import models_json_schema

from tandem.executive.service.intake.kind_schemas import with_envelope
from tandem.skills.ports.hardware import Stop, StopState
from tandem.skills.ports.keys import STOP, STOP_RELEASE, STOP_STATE, Nothing
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_ANSWERS,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_HISTORY,
    TASK_INFO,
    TASK_KINDS,
    TASK_LIST,
    TASK_PAUSE,
    TASK_REPRIORITISE,
    TASK_RESUME,
    TASK_SITE,
    TASK_STATUS,
    TASK_STEP,
    TASK_TIMELINE,
    TREE,
    TREE_NOW,
    AnswerQuestion,
    AskHistory,
    Breakpoint,
    CancelTask,
    ControlAnswer,
    ExecutiveInfo,
    ForceNode,
    History,
    NameTask,
    Reprioritise,
    StepTask,
    TaskAnswer,
    TaskKinds,
    TaskList,
    TaskStatus,
    TreeSnapshot,
)
from tandem.trees.task import TaskType

DIALECT: Final = "https://json-schema.org/draft/2020-12/schema"
CLIENT_MESSAGES: Final[tuple[type[Message], ...]] = (
    TaskAnswer,
    TaskStatus,
    TaskList,
    CancelTask,
    NameTask,
    StepTask,
    Reprioritise,
    AnswerQuestion,
    Breakpoint,
    ForceNode,
    ControlAnswer,
    AskHistory,
    History,
    ExecutiveInfo,
    TaskKinds,
    TreeSnapshot,
    Stop,
    StopState,
    Nothing,
)
_VERBS: Final = (
    TASK_CANCEL,
    TASK_PAUSE,
    TASK_RESUME,
    TASK_STEP,
    TASK_ABANDON,
    TASK_REPRIORITISE,
    TASK_ANSWER,
    TASK_BREAKPOINT,
    TASK_FORCE,
)
_DOCUMENT: Final[TypeAdapter[dict[str, JsonValue]]] = TypeAdapter(dict[str, JsonValue])


def interface_schema(kinds: Mapping[str, TaskType[Message]]) -> dict[str, JsonValue]:
    """Return one document: every message in ``$defs``, and which of them travels on which key."""
    results = {kind.name: kind.result for kind in kinds.values() if kind.result is not None}
    models = [kind.request for kind in kinds.values()] + [*results.values(), *CLIENT_MESSAGES]
    definitions = _definitions(models)
    for kind in kinds.values():
        definitions[kind.request.__name__] = with_envelope(definitions[kind.request.__name__], kind)
    requests: list[JsonValue] = [_ref(kind.request) for kind in kinds.values()]
    definitions["Request"] = {"oneOf": requests, "title": "Request"}
    return {
        "$schema": DIALECT,
        "title": "What clients of Tandem send and read",
        "$defs": definitions,
        "keys": _keys(),
        "results": {name: _ref(model) for name, model in results.items()},
    }


def separate_schemas(kinds: Mapping[str, TaskType[Message]]) -> dict[str, dict[str, JsonValue]]:
    """Return a document for each message, whole in itself, by the message's name."""
    whole = interface_schema(kinds)
    definitions = whole["$defs"]
    assert isinstance(definitions, dict)
    names = ["Request", *(kind.request.__name__ for kind in kinds.values())]
    names += [kind.result.__name__ for kind in kinds.values() if kind.result is not None]
    names += [model.__name__ for model in CLIENT_MESSAGES]
    return {
        name: {"$schema": DIALECT, "$ref": f"#/$defs/{name}", "$defs": _needed(name, definitions)}
        for name in names
    }


def _definitions(models: list[type[Message]]) -> dict[str, JsonValue]:
    _, schema = models_json_schema([(model, "validation") for model in models])
    return _DOCUMENT.validate_python(schema["$defs"])


def _keys() -> dict[str, JsonValue]:
    puts: dict[str, JsonValue] = {
        REQUEST: {"put": {"$ref": "#/$defs/Request"}},
        "task/<id>/status": {"subscribe": _ref(TaskStatus)},
    }
    for topic in (TASK_ANSWERS, TASK_STATUS, TREE, STOP_STATE):
        puts[topic.key] = {"subscribe": _ref(topic.model)}
    for service in (
        *_VERBS,
        TASK_LIST,
        TASK_HISTORY,
        TASK_INFO,
        TASK_KINDS,
        TASK_SITE,
        TASK_TIMELINE,
        TREE_NOW,
        STOP,
        STOP_RELEASE,
    ):
        puts[service.key] = {"query": _ref(service.asked), "answer": _ref(service.answered)}
    puts[REQUEST] = {
        "put": {"$ref": "#/$defs/Request"},
        "query": {"$ref": "#/$defs/Request"},
        "answer": _ref(TaskAnswer),
    }
    return puts


def _ref(model: type[Message]) -> JsonValue:
    return {"$ref": f"#/$defs/{model.__name__}"}


def _needed(name: str, definitions: Mapping[str, JsonValue]) -> dict[str, JsonValue]:
    found: dict[str, JsonValue] = {}
    waiting = [name]
    while waiting:
        each = waiting.pop()
        if each not in found:
            found[each] = definitions[each]
            waiting += _references(definitions[each])
    return dict(sorted(found.items()))


def _references(value: JsonValue) -> list[str]:
    if isinstance(value, list):
        return [name for each in value for name in _references(each)]
    if not isinstance(value, dict):
        return []
    here = value.get("$ref")
    below = [name for each in value.values() for name in _references(each)]
    return [*below, here.rsplit("/", 1)[1]] if isinstance(here, str) else below
