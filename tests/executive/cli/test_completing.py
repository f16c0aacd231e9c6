"""What the shell completes: quick, and silent when no robot answers."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Self

import pytest

from tandem.executive.cli import completing
from tandem.executive.cli.commands import request_command
from tandem.executive.cli.errors import CommandError
from tandem.skills.ports.tasks import KindOfTask, TaskKinds, TaskList, TaskState, TaskStatus

NOWHERE = {"TANDEM_CONNECT": "tcp/127.0.0.1:1"}


def completed(*words: str) -> tuple[str, str]:
    """Return what a shell is told for the last of the words, and what reached standard error."""
    line = " ".join(("tandem", *words))
    program = "from tandem.executive.cli.main import run; run()"
    environment = {
        **NOWHERE,
        "PATH": "",
        "_TANDEM_COMPLETE": "complete_bash",
        "COMP_WORDS": line,
        "COMP_CWORD": str(len(words)),
    }
    root = Path(__file__).parents[3]
    done = subprocess.run(
        [sys.executable, "-c", program],
        cwd=root,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.stdout, done.stderr


@pytest.mark.parametrize(
    ("words", "found"),
    [
        (["tasks"], "tasks"),
        (["scenario", "check", "De"], "Demo"),
        (["demo", "--scenario", "One"], "OneOfEverything"),
        (["tree", "render", "pick_t"], "pick_two"),
        (["tree", "render", "fetch", "--focus", "retr"], "retract"),
        (["tree", "render", "fetch", "--hide", "re"], "recoveries"),
        (["request", "js"], "json"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_what_is_installed_is_completed(words: list[str], found: str) -> None:
    out, err = completed(*words)
    assert found in out.split()
    assert err == ""


@pytest.mark.parametrize(
    "words",
    [["cancel", "f"], ["break", "p"], ["retry", "f"], ["request", "fe"], ["request", "fetch", "--item", "2"]],
    ids=" ".join,
)
def test_without_a_robot_nothing_is_said(words: list[str]) -> None:
    out, err = completed(*words)
    assert (out.strip(), err) == ("", "")


class Answering:
    """A connection that answers from a table."""

    def __init__(self, *_: object, within: float | None = None) -> None:
        assert within == completing.WITHIN

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing is open."""

    def ask(self, service: Any, _: object) -> object:
        return {
            "task/kinds": TaskKinds(kinds=(), items=("29", "3", "203"), names={"tea": 29}),
            "task/list": TaskList(tasks=(status("fetch-1", "FAILED"), status("pick-2", "RUNNING"))),
        }[service.key]


def status(task: str, state: str) -> TaskStatus:
    return TaskStatus(task=task, kind="fetch", request={}, state=TaskState(state), accepted_at=0.0)


@pytest.fixture
def robot(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tandem.executive.cli.connection.Connection", Answering)


@pytest.mark.usefixtures("robot")
@pytest.mark.parametrize(
    ("complete", "incomplete", "words"),
    [
        (completing.open_tasks, "", ["pick-2"]),
        (completing.ended_tasks, "", ["fetch-1"]),
        (completing.tasks, "f", ["fetch-1"]),
        (completing.items, "2", ["29", "203"]),
        (completing.items, "t", ["tea"]),
    ],
)
def test_a_robot_completes_its_tasks_and_items(complete: Any, incomplete: str, words: list[str]) -> None:
    context = SimpleNamespace(params={})
    assert [word for word, _ in complete(context, incomplete)] == words


def test_kinds_of_the_robot_are_asked_quickly(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[float | None] = []

    def kinds(_: object, *, within: float | None = None) -> tuple[KindOfTask, ...]:
        asked.append(within)
        return ()

    monkeypatch.setattr(request_command, "kinds_of_robot", kinds)
    group = request_command.RobotsKinds(name="request")
    group.list_commands(group.make_context("request", [], resilient_parsing=True))
    assert asked == [completing.WITHIN]


def test_a_robot_that_is_not_there_is_waited_for_no_longer_than_it_may(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    waited: list[float | None] = []

    class Nobody:
        def __init__(self, _: object, *, within: float | None = None) -> None:
            waited.append(within)
            raise CommandError("no router answers")

    monkeypatch.setattr("tandem.executive.cli.connection.Connection", Nobody)
    context: Any = SimpleNamespace(params={})
    assert completing.items(context, "") == []
    assert waited == [completing.WITHIN]
