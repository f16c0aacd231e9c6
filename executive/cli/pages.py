"""Fills the generated tables of the documentation, out of the code.

Run ``python -m tandem.executive.cli.pages docs/interface.md``. In a page the tables stand between
``<!-- begin NAME -->`` and ``<!-- end NAME -->``; the prose around them is written by hand. A test compares
the pages with the code.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterable
from enum import StrEnum
from pathlib import Path
from typing import Final

from tandem.executive.cli.commands import request_command, run_task_command
from tandem.executive.cli.exit_codes import MEANINGS, ExitCode
from tandem.executive.cli.main import build
from tandem.executive.cli.shapes import EACH, LINES, shapes
from tandem.executive.conformance.clause import Clause
from tandem.executive.conformance.suite import SUITE
from tandem.executive.interface.field_docs import first_paragraph, models_within
from tandem.executive.interface.tables import all_models, interface_tables, message_tables, table
from tandem.skills.ports.message import Message

_OF_KINDS: Final = {"request": request_command.ANY_KIND, "run": run_task_command.ANY_KIND}
"""Groups with a command for each kind of task."""
_MARKED: Final = re.compile(r"(<!-- begin (\w+) -->\n).*?(<!-- end \2 -->)", re.DOTALL)


def tables() -> dict[str, str]:
    """Return each table's Markdown by its name."""
    return {
        **interface_tables(),
        "exit_codes": _exit_code_table(),
        "commands": _command_table(),
        "hardware_clauses": _clause_table(),
        "json_commands": _json_table(),
        "json_shapes": _json_shapes(),
    }


def fill(page: str) -> str:
    """Return the page with fresh tables.

    Raises:
        KeyError: naming a marked table that there is none of.
    """
    made = tables()
    return _MARKED.sub(lambda found: f"{found[1]}{made[found[2]]}\n{found[3]}", page)


def marked(page: str) -> list[str]:
    """Return the names of the tables that the page has."""
    return [found[2] for found in _MARKED.finditer(page)]


def _exit_code_table() -> str:
    return table(("code", "meaning"), [(str(code.value), MEANINGS[code]) for code in ExitCode])


def _clause_table() -> str:
    rows = [
        (f"`{each.name}`", each.requires, _effect(each), f"[{each.where.partition('.md')[0]}]({each.where})")
        for each in SUITE
    ]
    return table(("clause", "what it requires", "what trying it does", "where"), rows)


def _effect(clause: Clause) -> str:
    effects = (("moves", clause.moving), ("sets the stop", clause.interrupts))
    return ", ".join(word for word, has in effects if has) or "reads"


def _json_table() -> str:
    rows, known = [], all_models()
    for command, shape in shapes().items():
        page = "interface.md" if shape in known else ""
        name = f"[{shape.__name__}]({page}#{shape.__name__.lower()})"
        how = "an array of " if command in EACH else "a line each: " if command in LINES else ""
        rows.append((f"`tandem {command}`", f"{how}{name}"))
    return table(("command", "what it prints"), sorted(rows))


def _json_shapes() -> str:
    own = _of_commands(shapes().values())
    text = message_tables(own)
    elsewhere = re.compile(r"\(#(?!(?:" + "|".join(each.__name__.lower() for each in own) + r")\))")
    return elsewhere.sub("(interface.md#", text)


def _of_commands(models: Iterable[type[Message]]) -> set[type[Message | StrEnum]]:
    """Return the models of the command line alone, with those of their fields."""
    known, found = all_models(), set[type[Message | StrEnum]]()
    waiting: list[type[Message | StrEnum]] = list(models)
    while waiting:
        model = waiting.pop()
        if model not in known and model not in found:
            found.add(model)
            fields = model.model_fields.values() if issubclass(model, Message) else ()
            waiting += [below for info in fields for below in models_within(info.annotation)]
    return found


def _command_table() -> str:
    app = build()
    rows = [_command_row("", each.name, each.callback, each.help) for each in app.registered_commands]
    for group in app.registered_groups:
        of = group.typer_instance
        assert of is not None
        rows += [
            _command_row(f"{group.name} ", each.name, each.callback, each.help)
            for each in of.registered_commands
        ]
        if group.name in _OF_KINDS:
            kind, what = _OF_KINDS[group.name]
            rows.append((f"`tandem {group.name} {kind}`", what))
    return table(("command", "what it does"), rows)


def _command_row(
    group: str, name: str | None, callback: Callable[..., object] | None, text: str | None
) -> tuple[str, str]:
    return (f"`tandem {group}{name}`", text or first_paragraph(callback))


def main(argv: list[str]) -> int:
    """Fill the pages named."""
    for name in argv:
        page = Path(name)
        page.write_text(fill(page.read_text(encoding="utf-8")), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
