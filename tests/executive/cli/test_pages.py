"""docs/interface.md says what the code says."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tandem.executive.cli.pages import fill, marked, tables
from tandem.executive.interface.schemas import CLIENT_MESSAGES, interface_schema, separate_schemas
from tandem.skills.ports import keys, tasks, world
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Service, Topic
from tandem.trees.registry import discover

DOCS = Path(__file__).parents[3] / "docs"
PAGE, JSON, CLAUSES = DOCS / "interface.md", DOCS / "json.md", DOCS / "hardware-check.md"


@pytest.mark.parametrize("path", [PAGE, JSON, CLAUSES], ids=lambda path: path.name)
def test_the_page_is_up_to_date(path: Path) -> None:
    page = path.read_text(encoding="utf-8")
    assert fill(page) == page, f"run: python -m tandem.executive.cli.pages docs/{path.name}"


def test_the_pages_have_every_table() -> None:
    found = [name for path in (PAGE, JSON, CLAUSES) for name in marked(path.read_text(encoding="utf-8"))]
    assert sorted(found) == sorted(tables())


def test_every_key_kind_and_task_is_in_it() -> None:
    page = PAGE.read_text(encoding="utf-8")
    found = [
        entry.key
        for module in (keys, tasks, world)
        for entry in vars(module).values()
        if isinstance(entry, Topic | Service)
    ]
    names = [*found, tasks.REQUEST, keys.rgbd("<camera>"), *FailureKind, *discover()]
    assert [name for name in names if name not in page] == []


def test_links_lead_somewhere() -> None:
    page = PAGE.read_text(encoding="utf-8")
    heads = {line[4:].lower() for line in page.splitlines() if line.startswith("### ")}
    links = {part.split(")")[0] for part in page.split("](#")[1:]}
    assert links - heads == set()


def test_schemas_hold_what_clients_send_and_read() -> None:
    schema = interface_schema(discover())
    definitions = schema["$defs"]
    assert isinstance(definitions, dict)
    assert {model.__name__ for model in CLIENT_MESSAGES} <= set(definitions)
    request = json.dumps(definitions["FetchRequest"])
    assert '"const": "fetch"' in request
    assert '"id"' in request


def test_each_separate_schema_is_whole() -> None:
    for name, document in separate_schemas(discover()).items():
        definitions = document["$defs"]
        assert isinstance(definitions, dict)
        text = json.dumps(document)
        used = {part.split('"')[0] for part in text.split("#/$defs/")[1:]}
        assert used <= set(definitions), name
