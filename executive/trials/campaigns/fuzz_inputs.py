"""What the request interface is fuzzed with: documents out of its JSON Schemas, whole and spoiled, and none.

Needs hypothesis, which comes with ``tandem-executive[dev]``.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st
from pydantic import JsonValue, TypeAdapter

from tandem.executive.interface.entries import entries
from tandem.executive.interface.schemas import interface_schema
from tandem.executive.trials.campaigns.from_schema import as_json, from_schema
from tandem.skills.ports.keys import Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import REQUEST
from tandem.trees.task import TaskType

_ADAPTER: Final[TypeAdapter[JsonValue]] = TypeAdapter(JsonValue)
_LEAVES: Final[st.SearchStrategy[JsonValue]] = (
    st.none() | st.booleans() | st.integers() | st.floats() | st.text()
)
ANY_JSON: Final[st.SearchStrategy[JsonValue]] = st.recursive(
    _LEAVES,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)
"""Any JSON and a little more: Python writes NaN and halves of surrogate pairs."""
ALMOST_JSON: Final = st.text(alphabet='{}[]",:\\u0d8 1e9-NaN', max_size=60).map(str.encode)
TASK_HERE: Final = "(the task here)"
"""Stands for the id of the task that runs just then."""
KNOWN: Final[tuple[JsonValue, ...]] = (
    "fetch",
    "depot",
    "left",
    29,
    586,
    -1,
    0.5,
    "",
    "id",
    "0" * 65,
    TASK_HERE,
    [29, 3],
)
"""Values that are right somewhere, or only just wrong."""
LIKELY: Final[Mapping[str, tuple[JsonValue, ...]]] = {
    "item": (29, 3),
    "to": ("depot",),
    "task": (TASK_HERE,),
}
"""Values by the name of their field, without which hardly any document would be taken."""


@dataclass(frozen=True)
class Input:
    """One query."""

    key: str
    payload: bytes


def feed_drawn(
    drawn: st.SearchStrategy[Input], count: int, start: int, feed: Callable[[Input], None]
) -> None:
    """Feed so many inputs, the same ones for the same seed ``start``; an error of ``feed`` ends it.

    Nothing is shrunk: an input that breaks a process may take a new process each time.
    """
    generated = settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    seed(start)(generated(given(drawn)(feed)))()


def inputs(kinds: Mapping[str, TaskType[Message]]) -> st.SearchStrategy[Input]:
    """Return the inputs: half of them for ``task/request``, the others for the services of tasks."""
    schemas = interface_schema(kinds)["$defs"]
    assert isinstance(schemas, dict)
    requests = [_documents(schemas[kind.request.__name__], schemas) for kind in kinds.values()]
    verbs = [
        _inputs(entry.key, _documents(*_schema_of(entry.asked)))
        for entry in entries()["clients"]
        if isinstance(entry, Service)
    ]
    # A choice of choices would be made one: requests would be one among many.
    halves = (_inputs(REQUEST, st.one_of(requests)), st.one_of(verbs))
    return st.sampled_from(halves).flatmap(lambda half: half)


def documents_of(model: type[Message]) -> st.SearchStrategy[JsonValue]:
    """Return documents for a message: such as its schema takes, and others that only look alike."""
    return _documents(*_schema_of(model))


def _schema_of(model: type[Message]) -> tuple[JsonValue, dict[str, JsonValue]]:
    schema = _ADAPTER.validate_python(model.model_json_schema())
    assert isinstance(schema, dict)
    definitions = schema.get("$defs", {})
    assert isinstance(definitions, dict)
    return schema, definitions


def _inputs(key: str, documents: st.SearchStrategy[JsonValue]) -> st.SearchStrategy[Input]:
    nothing_like_it = ANY_JSON.map(_written) | st.binary(max_size=200) | ALMOST_JSON
    return st.builds(Input, st.just(key), documents.map(_written) | nothing_like_it)


def _documents(schema: JsonValue, definitions: Mapping[str, JsonValue]) -> st.SearchStrategy[JsonValue]:
    """Return documents that the schema takes, such with something spoiled, and such that only look alike."""
    assert isinstance(schema, dict)
    fields = schema.get("properties", {})
    assert isinstance(fields, dict)
    whole = from_schema(schema, definitions)
    likely = _likely(whole)
    names, values = st.sampled_from((*fields, "extra")), st.sampled_from(KNOWN) | ANY_JSON
    alike: st.SearchStrategy[JsonValue] = st.dictionaries(names, values).map(as_json)
    return whole | likely | _spoiled(likely, (*fields, "extra")) | alike


@st.composite
def _likely(draw: st.DrawFn, whole: st.SearchStrategy[JsonValue]) -> JsonValue:
    """Return a document that does not contradict the site, as far as that is known of its fields' names."""
    document = draw(whole)
    assert isinstance(document, dict)
    # The kind of a request is told from a task's id by what else is there.
    found = [name for name in LIKELY if name in document and (name != "task" or len(document) == 1)]
    return {**document, **{name: draw(st.sampled_from(LIKELY[name])) for name in found}}


@st.composite
def _spoiled(draw: st.DrawFn, whole: st.SearchStrategy[JsonValue], fields: tuple[str, ...]) -> JsonValue:
    """Return a document in which a field is missing, or holds what does not belong there."""
    document, field = draw(whole), draw(st.sampled_from(fields))
    assert isinstance(document, dict)
    if field in document and draw(st.booleans()):
        del document[field]
    else:
        document[field] = draw(st.sampled_from(KNOWN) | ANY_JSON)
    return document


def _written(document: object) -> bytes:
    return json.dumps(document).encode()
