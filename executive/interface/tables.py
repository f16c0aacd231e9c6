"""The documentation's tables of the interface: keys, messages, requests, actions, failures."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from enum import StrEnum
from typing import Final

from tandem.executive.interface.entries import (
    Entry,
    all_actions,
    all_entries,
    entries_of,
    sim_entries,
    status_entries,
    task_entries,
)
from tandem.executive.interface.field_docs import (
    field_default,
    field_docs,
    field_type,
    first_paragraph,
    models_within,
    type_name,
    whole_doc,
)
from tandem.skills.ports import action, keys, tasks, world
from tandem.skills.ports.failure import KINDS
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import Message
from tandem.trees.recovery_kinds import RECOVERIES
from tandem.trees.registry import discover

_REQUEST_ROW: Final = (
    f"`{tasks.REQUEST}`",
    "put or queried",
    "a request of those below → [TaskAnswer](#taskanswer)",
)
_PICTURE_ROW: Final = (
    f"`{keys.rgbd('<camera>')}`",
    "published while subscribed",
    "binary: [RgbdHeader](#rgbdheader) as JSON, then the pixels (`skills/ports/image.py`)",
)


def interface_tables() -> dict[str, str]:
    """Return each table's Markdown by its name."""
    return {
        "task_keys": _key_table(task_entries(), _REQUEST_ROW),
        "hardware_keys": _key_table(entries_of(keys), _PICTURE_ROW),
        "sim_keys": _key_table(sim_entries()),
        "world_keys": _key_table(entries_of(world)),
        "skill_keys": _key_table([*entries_of(action), *status_entries()]),
        "requests": _request_table(),
        "actions": _action_table(),
        "failures": _failure_table(),
        "messages": _message_tables(),
    }


def _key_table(entries: list[Entry], *others: tuple[str, str, str]) -> str:
    rows = list(others)
    for entry in entries:
        if isinstance(entry, Topic):
            rows.append((f"`{entry.key}`", "published", type_name(entry.model)))
        else:
            rows.append(
                (f"`{entry.key}`", "queried", f"{type_name(entry.asked)} → {type_name(entry.answered)}")
            )
    return table(("key", "how", "message"), rows)


def _request_table() -> str:
    rows = [
        (
            f'`"{kind.name}"`',
            kind.summary,
            type_name(kind.request),
            "" if kind.result is None else type_name(kind.result),
        )
        for kind in discover().values()
    ]
    return table(("`task`", "what it does", "message", "result"), rows)


def _action_table() -> str:
    rows = [
        (
            f"`{each.name}`",
            first_paragraph(each.goal),
            type_name(each.goal),
            type_name(each.feedback),
            type_name(each.result),
            f"{each.timeout:g}",
        )
        for each in all_actions()
    ]
    return table(("action", "what it does", "goal", "feedback", "result", "time-out (robot s)"), rows)


def _failure_table() -> str:
    rows = [
        (
            f"`{kind}`",
            facts.meaning,
            "yes" if facts.retryable else "no",
            f"`{facts.helper}`",
            RECOVERIES[kind] or "none",
        )
        for kind, facts in KINDS.items()
    ]
    return table(("kind", "meaning", "again?", "who can help", "the recovery that takes it"), rows)


def _message_tables() -> str:
    return message_tables(all_models())


def message_tables(models: Iterable[type[Message | StrEnum]]) -> str:
    """Return a section for each message or enumeration, by name."""
    parts = []
    for model in sorted(models, key=lambda each: each.__name__):
        parts.append(f"### {model.__name__}\n\n{whole_doc(model)}\n")
        if issubclass(model, Message):
            parts.append(_field_table(model) if model.model_fields else "No fields.")
        else:
            parts.append(", ".join(f"`{each.value}`" for each in model))
        parts.append("")
    return "\n".join(parts).rstrip("\n")


def _field_table(model: type[Message]) -> str:
    docs = field_docs(model)
    rows = [
        (f"`{name}`", field_type(info), field_default(info), info.description or docs.get(name, ""))
        for name, info in model.model_fields.items()
    ]
    return table(("field", "type", "default", "meaning"), rows)


def all_models() -> set[type[Message | StrEnum]]:
    """Return every message and enumeration of the interface."""
    waiting: list[type[Message | StrEnum]] = [RgbdHeader, *(kind.request for kind in discover().values())]
    waiting += [kind.result for kind in discover().values() if kind.result is not None]
    for entry in all_entries():
        waiting += [entry.model] if isinstance(entry, Topic) else [entry.asked, entry.answered]
    for each in all_actions():
        waiting += [each.goal, each.feedback, each.result]
    found: set[type[Message | StrEnum]] = set()
    while waiting:
        model = waiting.pop()
        if model in found:
            continue
        found.add(model)
        if issubclass(model, Message):
            fields: Mapping[str, object] = {
                name: info.annotation for name, info in model.model_fields.items()
            }
            waiting += [below for annotation in fields.values() for below in models_within(annotation)]
    return found


def table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    """Return a table in Markdown."""
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', '&#124;') for cell in line)} |" for line in lines)
