"""``--json``: every command that prints facts has it, and prints the one shape that docs/json.md says."""

from __future__ import annotations

import json
from typing import Final

import pytest
from pydantic import TypeAdapter

from tandem.executive.cli.commands.cancel_command import in_order
from tandem.executive.cli.commands.retry_command import document_of
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.main import main
from tandem.executive.cli.shapes import EACH, Requested, Tasks, print_json, shapes
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import TaskState, TaskStatus
from tests.executive.cli.test_connection import all_commands

CONFIRMS: Final = "does one thing and confirms it in a sentence; its exit code says whether it was done"
RUNS: Final = "runs until Ctrl-C or its task's end; --report FILE has its facts as JSON"
REPORTS: Final = "--report FILE has its results as JSON"
WITHOUT: Final = {
    "demo": RUNS,
    "up": RUNS,
    "new": CONFIRMS,
    "pause": CONFIRMS,
    "resume": CONFIRMS,
    "step": CONFIRMS,
    "abandon": CONFIRMS,
    "reprioritise": CONFIRMS,
    "answer": CONFIRMS,
    "break": CONFIRMS,
    "force": CONFIRMS,
    "keys init": CONFIRMS,
    "keys new": CONFIRMS,
    "keys revoke": CONFIRMS,
    "keys link": "prints one address",
    "export": "prints JSON lines",
    "log export": "prints JSON lines",
    "log cut": CONFIRMS,
    "log recover": CONFIRMS,
    "schema": "prints JSON",
    "tree render": "--format json",
    "ros": "drives a robot until it is ended",
    "web": "serves a page until it is ended",
    "zones": "draws a picture",
    "bench": REPORTS,
    "campaign fetch": REPORTS,
    "campaign recovery": REPORTS,
    "campaign crash": REPORTS,
    "campaign fuzz": REPORTS,
    "campaign restart": REPORTS,
    "campaign soak": REPORTS,
    "experiment uncoordinated": REPORTS,
    "experiment crossing": REPORTS,
    "experiment coordinated": REPORTS,
    "experiment rocs": REPORTS,
    "experiment crossings": REPORTS,
    "experiment picking": REPORTS,
}


def status(task: str, state: TaskState, *, began: bool = True, **request: object) -> TaskStatus:
    return TaskStatus.model_validate(
        {
            "task": task,
            "kind": "fetch",
            "request": {"task": "fetch", "item": 29, **request},
            "state": state,
            "accepted_at": 0.0,
            "started": RobotTime(boot="b", seconds=1.0) if began else None,
        }
    )


def test_every_command_has_json_or_a_reason() -> None:
    having = {
        name
        for name, command in all_commands().items()
        if any("--json" in parameter.opts for parameter in command.params)
    }
    assert having.isdisjoint(WITHOUT)
    assert having | WITHOUT.keys() == all_commands().keys()
    assert having == shapes().keys() - {"request KIND", "run KIND"}


@pytest.mark.parametrize(
    "words",
    [
        ["tree", "list"],
        ["tree", "properties", "fetch", "--ticks", "200"],
        ["scenario", "list"],
        ["scenario", "check", "Demo"],
        ["doctor", "--connect", "tcp/127.0.0.1:1"],
        ["plugins"],
    ],
    ids=" ".join,
)
def test_what_needs_no_robot_prints_its_shape(words: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    main([*words, "--json"])
    found = json.loads(capfd.readouterr().out)
    name = next(each for each in shapes() if " ".join(words).startswith(each))
    for document in found if name in EACH else [found]:
        TypeAdapter(shapes()[name]).validate_python(document)


def test_times_of_day_are_iso(capfd: pytest.CaptureFixture[str]) -> None:
    shape = Tasks(tasks=(status("fetch-1", TaskState.RUNNING),))
    print_json(shape)
    out = capfd.readouterr().out
    assert json.loads(out)["tasks"][0]["accepted_at"] == "1970-01-01T00:00:00Z"
    assert Tasks.model_validate_json(out) == shape


def test_a_document_is_one_line_where_there_are_several(capfd: pytest.CaptureFixture[str]) -> None:
    print_json(Requested(task="fetch-1"), line=True)
    assert capfd.readouterr().out.count("\n") == 1


def test_a_retry_is_the_same_request_without_what_was_of_the_first() -> None:
    first = status("fetch-1", TaskState.FAILED, id="mine", by="ann", expires=5.0, labels={"order": "7"})
    again = document_of(first)
    assert again.pop("id") not in {"mine", "fetch-1"}
    assert again == {"task": "fetch", "item": 29, "labels": {"order": "7"}, "retry_of": "fetch-1"}


@pytest.mark.parametrize("state", [each for each in TaskState if not each.terminal])
def test_what_has_not_ended_is_not_retried(state: TaskState) -> None:
    with pytest.raises(CommandError, match="only a task that has ended can be retried"):
        document_of(status("fetch-1", state))


def test_what_waits_is_cancelled_before_what_runs() -> None:
    tasks = [
        status("ended", TaskState.FAILED),
        status("runs", TaskState.RUNNING),
        status("older", TaskState.QUEUED, began=False),
        status("newer", TaskState.QUEUED, began=False),
    ]
    assert [each.task for each in in_order(tasks)] == ["newer", "older", "runs"]


@pytest.mark.parametrize("words", [["cancel"], ["cancel", "fetch-1", "--all"]])
def test_cancel_takes_one_task_or_all(words: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    assert main(words) == 2
    assert "expected the ID of a task, or --all" in capfd.readouterr().err
