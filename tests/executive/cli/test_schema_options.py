"""Options of a request, made from the JSON Schema that the robot serves, and the documents made of them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import typer
from typer.testing import CliRunner

from tandem.executive.cli.commands import request_command
from tandem.executive.cli.commands.request_command import command_of
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.main import main
from tandem.executive.cli.schema_options import fields_of
from tandem.executive.service.intake.kind_schemas import kinds_offered
from tandem.skills.ports.tasks import KindOfTask
from tandem.trees.registry import discover

if TYPE_CHECKING:
    from pydantic import JsonValue

WATER = KindOfTask(
    name="water",
    summary="Water a plant.",
    request={
        "type": "object",
        "required": ["task", "plant"],
        "properties": {
            "task": {"const": "water"},
            "amount": {"type": "number", "default": 0.2, "description": "litres"},
            "plant": {"$ref": "#/$defs/Plant"},
            "gently": {"anyOf": [{"type": "boolean"}, {"type": "null"}]},
            "from-where": {"type": "array", "items": {"type": "number"}},
            "pot": {"anyOf": [{"type": "integer"}, {"type": "string"}]},
            "labels": {"type": "object", "additionalProperties": {"type": "string"}},
            "not_before": {"anyOf": [{"type": "number"}, {"type": "string", "format": "date-time"}]},
            "odd": {},
        },
        "$defs": {"Plant": {"enum": ["fern", "rose"], "type": "string", "description": "which one"}},
    },
)
"""A task that this package does not have."""


def sent(monkeypatch: pytest.MonkeyPatch, *words: str, kind: KindOfTask = WATER) -> dict[str, JsonValue]:
    """Return the document that the command would send."""
    found: list[dict[str, JsonValue]] = []
    to = "tandem.executive.cli.sending.send_fields"
    monkeypatch.setattr(to, lambda *given, **_: found.append(given[0]))
    command_of(kind)(list(words), standalone_mode=False)
    (document,) = found
    return document


@pytest.mark.parametrize(
    ("words", "field", "value"),
    [
        (["--amount", "0.5"], "amount", 0.5),
        (["--amount", "-1.2"], "amount", -1.2),
        (["--gently"], "gently", True),
        (["--no-gently"], "gently", False),
        (["--from-where", "[1, 2]"], "from-where", [1, 2]),
        (["--from-where", "the left"], "from-where", "the left"),
        (["--pot", "3"], "pot", 3),
        (["--pot", "blue"], "pot", "blue"),
        (["--labels", "order=7", "--labels", "by=a=b"], "labels", {"order": "7", "by": "a=b"}),
        (["--not-before", "2026-11-24T08:30:00Z"], "not_before", "2026-11-24T08:30:00Z"),
        (["--not-before", "1700000000"], "not_before", 1700000000),
        (["--odd", '{"a": 1}'], "odd", {"a": 1}),
    ],
)
def test_an_option_becomes_the_documents_value(
    words: list[str], field: str, value: JsonValue, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = sent(monkeypatch, "--plant", "fern", *words)
    assert document[field] == value
    assert (document["task"], document["plant"]) == ("water", "fern")


def test_what_is_not_given_is_not_sent(monkeypatch: pytest.MonkeyPatch) -> None:
    assert set(sent(monkeypatch, "--plant", "rose")) == {"task", "id", "plant"}


def test_an_id_of_the_users_is_kept() -> None:
    schema: dict[str, JsonValue] = {"properties": {"id": {"type": "string"}}}
    (field,) = fields_of(schema)
    assert (field.option, field.read("mine")) == ("--id", "mine")


def test_a_label_without_a_value_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(CommandError, match="--labels: expected k=v; found 'order'"):
        sent(monkeypatch, "--plant", "rose", "--labels", "order")


@pytest.mark.parametrize(
    ("words", "field", "value"),
    [
        (["--request-wait"], "wait", True),
        (["--request-robot", "kim"], "robot", "kim"),
        (["--request-json", "x"], "json", "x"),
        (["--class", "herbs"], "class", "herbs"),
    ],
)
def test_a_field_may_be_called_like_another_option_or_a_word_of_python(
    monkeypatch: pytest.MonkeyPatch, words: list[str], field: str, value: JsonValue
) -> None:
    kinds: JsonValue = {"type": "boolean" if value is True else "string"}
    kind = KindOfTask(name="named", summary="", request={"properties": {field: kinds}})
    assert sent(monkeypatch, *words, kind=kind)[field] == value


def test_a_schema_that_refers_to_itself_has_an_option() -> None:
    schema: dict[str, JsonValue] = {
        "properties": {"tree": {"$ref": "#/$defs/T"}},
        "$defs": {"T": {"anyOf": [{"$ref": "#/$defs/T"}, {"type": "integer"}]}},
    }
    assert [field.option for field in fields_of(schema)] == ["--tree"]


def test_a_task_that_only_the_robot_knows_is_listed_and_has_options(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(request_command, "kinds_of_robot", lambda *_, **__: (WATER,))
    assert main(["request", "--help"]) == 0
    assert "Water a plant." in capsys.readouterr().out
    assert main(["request", "water", "--help"]) == 0
    out = capsys.readouterr().out
    assert all(
        word in out for word in ("--plant", "fern or rose", "--amount", "litres", "--wait", "--connect")
    )
    assert main(["request", "dance"]) == 2
    assert "the robot offers no task 'dance'; it offers water" in capsys.readouterr().err


def test_the_robot_that_is_asked_is_the_one_that_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def kinds(options: object, **_: object) -> tuple[KindOfTask, ...]:
        asked.append(str(getattr(options, "endpoint", "")))
        return (WATER,)

    monkeypatch.setattr(request_command, "kinds_of_robot", kinds)
    main(["request", "water", "--amount", "1", "--connect", "tcp/10.0.0.1:1", "--help"])
    assert asked[0] == "tcp/10.0.0.1:1"


@pytest.mark.parametrize("kind", kinds_offered(discover()).kinds, ids=lambda kind: kind.name)
def test_every_task_that_ships_has_an_option_for_each_field(kind: KindOfTask) -> None:
    properties = kind.request["properties"]
    assert isinstance(properties, dict)
    options = {option for each in command_of(kind).params for option in each.opts}
    assert {f"--{name.replace('_', '-')}" for name in properties if name != "task"} <= options
    assert {"--id", "--priority", "--not-before", "--expires", "--labels", "--wait", "--connect"} <= options


def test_without_a_robot_the_help_lists_what_needs_none() -> None:
    app = typer.Typer()
    request_command.add_to(app)
    done = CliRunner().invoke(app, ["request", "--help"], env={"TANDEM_CONNECT": "tcp/127.0.0.1:1"})
    assert done.exit_code == 0
    assert "json" in done.output


@pytest.mark.parametrize(("said", "document"), [("{}", b"{}"), ("@", b'{"a": 1}')])
def test_a_document_comes_as_itself_or_from_a_file(said: str, document: bytes, tmp_path: Path) -> None:
    path = f"{tmp_path}/request.json"
    with open(path, "wb") as file:  # noqa: PTH123 - a path as text, as the user gives it
        file.write(document)
    assert request_command.read_document(f"@{path}" if said == "@" else said) == document


def test_a_file_that_is_not_there_is_named() -> None:
    with pytest.raises(CommandError, match="@no/such: cannot read 'no/such': No such file"):
        request_command.read_document("@no/such")
