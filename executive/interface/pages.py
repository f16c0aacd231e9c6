"""The tables of docs/interface.md, from the code.

Run ``python -m tandem.executive.interface.pages docs/interface.md``.

In the page they stand between ``<!-- begin NAME -->`` and ``<!-- end NAME -->``; the prose around is written
by hand. A test compares the page with the code.
"""

from __future__ import annotations

import importlib
import inspect
import pkgutil
import re
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from enum import StrEnum
from pathlib import Path
from types import ModuleType
from typing import Final

from tandem.executive.cli.exit_codes import MEANINGS, ExitCode
from tandem.executive.interface.field_docs import (
    field_default,
    field_docs,
    field_type,
    first_paragraph,
    models_within,
    type_name,
    whole_doc,
)
from tandem.sim import controls
from tandem.skills.ports import action, actions, keys, tasks, world
from tandem.skills.ports.failure import KINDS
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.keys import Service, Topic
from tandem.skills.ports.message import Message
from tandem.skills.ports.skill import ActionType
from tandem.skills.wire import loop
from tandem.trees.recoveries import RECOVERIES
from tandem.trees.registry import discover

Entry = Topic[Message] | Service[Message, Message]
"""A key and what travels on it."""
_REQUEST_ROW: Final = (
    f"`{tasks.REQUEST}`",
    "put or queried",
    "a request of those below → [TaskAnswer](#taskanswer)",
)
_PICTURE_ROW: Final = (
    f"`{keys.RGBD}`",
    "published while subscribed",
    "binary: [RgbdHeader](#rgbdheader) as JSON, then the pixels (`skills/ports/image.py`)",
)
_MARKED: Final = re.compile(r"(<!-- begin (\w+) -->\n).*?(<!-- end \2 -->)", re.DOTALL)


def tables() -> dict[str, str]:
    """Return each table's Markdown by its name."""
    return {
        "task_keys": _key_table(_task_entries(), _REQUEST_ROW),
        "hardware_keys": _key_table(_entries(keys), _PICTURE_ROW),
        "sim_keys": _key_table(_sim_entries()),
        "world_keys": _key_table(_entries(world)),
        "skill_keys": _key_table([*_entries(action), *_status_entries()]),
        "requests": _request_table(),
        "actions": _action_table(),
        "failures": _failure_table(),
        "exit_codes": _exit_code_table(),
        "commands": _command_table(),
        "messages": _message_tables(),
    }


def entries() -> dict[str, list[Entry]]:
    """Return the keys of the interface, by who they are for."""
    return {
        "clients": _task_entries(),
        "world": _entries(world),
        "skills": [*_entries(action), *_status_entries()],
        "hardware": _entries(keys),
        "stand-in": _sim_entries(),
    }


def fill(page: str) -> str:
    """Return the page with its tables made anew.

    Raises:
        KeyError: naming a marked table that there is none of.
    """
    made = tables()
    return _MARKED.sub(lambda found: f"{found[1]}{made[found[2]]}\n{found[3]}", page)


def marked(page: str) -> list[str]:
    """Return the names of the tables that the page has."""
    return [found[2] for found in _MARKED.finditer(page)]


def _entries(module: ModuleType) -> list[Entry]:
    """Return the topics and services that a module defines; functions get their arguments' names."""
    found: list[Entry] = []
    for value in vars(module).values():
        made = _called(module, value) if inspect.isfunction(value) else value
        if isinstance(made, Topic | Service):
            found.append(made)
    return found


def _called(module: ModuleType, function: Callable[..., object]) -> object:
    returned = str(inspect.signature(function).return_annotation)
    if function.__module__ != module.__name__ or not returned.startswith(("Topic", "Service", "ActionType")):
        return None
    names = inspect.signature(function).parameters
    return function(*(f"<{name}>" for name in names))


def _task_entries() -> list[Entry]:
    return [*_entries(tasks), Topic("task/<id>/status", tasks.TaskStatus)]


def _action_modules() -> Iterator[ModuleType]:
    for module in sorted(pkgutil.iter_modules(actions.__path__), key=lambda each: each.name):
        yield importlib.import_module(f"{actions.__name__}.{module.name}")


def _status_entries() -> list[Entry]:
    return [entry for module in _action_modules() for entry in _entries(module)]


def all_actions() -> list[ActionType[Message, Message, Message]]:
    """Return every action; names in angle brackets stand for groups and sides."""
    found = []
    for module in _action_modules():
        for value in vars(module).values():
            made = _called(module, value) if inspect.isfunction(value) else value
            if isinstance(made, ActionType):
                found.append(made)
    return found


def _key_table(entries: list[Entry], *others: tuple[str, str, str]) -> str:
    rows = list(others)
    for entry in entries:
        if isinstance(entry, Topic):
            rows.append((f"`{entry.key}`", "published", type_name(entry.model)))
        else:
            rows.append(
                (f"`{entry.key}`", "queried", f"{type_name(entry.asked)} → {type_name(entry.answered)}")
            )
    return _table(("key", "how", "message"), rows)


def _request_table() -> str:
    rows = [(f'`"{kind.name}"`', kind.summary, type_name(kind.request)) for kind in discover().values()]
    return _table(("`task`", "what it does", "message"), rows)


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
    return _table(("action", "what it does", "goal", "feedback", "result", "time-out (robot s)"), rows)


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
    return _table(("kind", "meaning", "again?", "who can help", "the recovery that takes it"), rows)


def _exit_code_table() -> str:
    return _table(("code", "meaning"), [(str(code.value), MEANINGS[code]) for code in ExitCode])


def _command_table() -> str:
    from tandem.executive.cli.main import build  # noqa: PLC0415 - it is only this table's

    app = build(["request"])
    rows = [_command_row("", each.name, each.callback, each.help) for each in app.registered_commands]
    for group in app.registered_groups:
        of = group.typer_instance
        assert of is not None
        rows += [
            _command_row(f"{group.name} ", each.name, each.callback, each.help)
            for each in of.registered_commands
        ]
    return _table(("command", "what it does"), rows)


def _command_row(
    group: str, name: str | None, callback: Callable[..., object] | None, text: str | None
) -> tuple[str, str]:
    return (f"`tandem {group}{name}`", text or first_paragraph(callback))


def _message_tables() -> str:
    parts = []
    for model in sorted(_all_models(), key=lambda each: each.__name__):
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
    return _table(("field", "type", "default", "meaning"), rows)


def _sim_entries() -> list[Entry]:
    return [*_entries(controls), *_entries(loop)]


def all_entries() -> list[Entry]:
    """Return every topic and service of the interface."""
    own = [*_task_entries(), *_entries(keys), *_entries(world), *_entries(action)]
    return [*own, *_status_entries(), *_sim_entries()]


def _all_models() -> set[type[Message | StrEnum]]:
    waiting: list[type[Message | StrEnum]] = [RgbdHeader, *(kind.request for kind in discover().values())]
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


def _table(head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    lines = [head, ("---",) * len(head), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', '&#124;') for cell in line)} |" for line in lines)


def main(argv: list[str]) -> int:
    """Fill the pages named."""
    for name in argv:
        page = Path(name)
        page.write_text(fill(page.read_text(encoding="utf-8")), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
