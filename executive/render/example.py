"""A task's tree without a robot: built for an example of a request, over a bus that nobody else is on."""

from __future__ import annotations

from collections.abc import Mapping

from pydantic import JsonValue
from pydantic.fields import FieldInfo

from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.message import Message
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import TreeNode
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.trees.clients import Clients
from tandem.trees.context import TreeContext
from tandem.trees.knowledge import Knowledge
from tandem.trees.snapshot import snapshot
from tandem.trees.task import TaskType


class NoExampleError(ValueError):
    """A request can't be made up; the message says why, and what to do."""


def example_request(kind: TaskType[Message], site: Site) -> dict[str, JsonValue]:
    """Return a request's document: its required fields, with the first item of the site where one is meant.

    Raises:
        NoExampleError: naming a required field that has no example.
    """
    document: dict[str, JsonValue] = {"task": kind.name}
    for name, info in kind.request.model_fields.items():
        if info.is_required() and name not in document:
            document[name] = _example(name, info, site, document)
    return document


def tree_of(kind: TaskType[Message], site: Site, document: dict[str, JsonValue]) -> TreeNode:
    """Return the tree that the request would be carried out with.

    Raises:
        pydantic.ValidationError: when the document is no request of this kind.
    """
    body = dict(document) if "task" in kind.request.model_fields else {
        name: value for name, value in document.items() if name != "task"
    }  # fmt: skip
    request = kind.request.model_validate(body, context=site)
    bus, clocks = MemoryBus(), SteppedClocks()
    context = TreeContext(kind.name, Clients(bus, clocks, "render"), Knowledge(bus, clocks, site), clocks)
    return snapshot(kind.tree(request, context))


def _example(name: str, info: FieldInfo, site: Site, known: Mapping[str, JsonValue]) -> JsonValue:
    if site.items and (name == "item" or name.endswith("_item")):
        return site.items[0].item
    if name in PAIR:
        for each in site.items:
            if each.is_for(name) and each.item not in known.values():
                return each.item
    examples: list[JsonValue] = info.examples or []
    if not examples:
        raise NoExampleError(
            f"field {name!r} is required and has no example; give the request with --request"
        )
    return examples[0]
