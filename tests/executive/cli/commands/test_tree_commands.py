"""``tandem tree coverage`` and ``tandem tree properties``."""

import pytest
import typer
from typer.testing import CliRunner

from tandem.executive.cli.commands import tree_commands
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode


@pytest.fixture
def app() -> typer.Typer:
    made = typer.Typer()
    tree_commands.add_to(made)
    return made


def test_gaps_are_named_and_end_with_1(app: typer.Typer) -> None:
    done = CliRunner().invoke(app, ["tree", "coverage", "fetch", "--depth", "0"])
    assert done.exit_code == ExitCode.TASK_FAILED
    assert "not seen  drive to item: FAILURE".lower() in done.output.lower()
    assert "0 invariants broken" in done.output


def test_drawn_schedules_are_counted(app: typer.Typer) -> None:
    done = CliRunner().invoke(app, ["tree", "properties", "fetch", "--ticks", "500", "--seed", "3"])
    assert done.exit_code == ExitCode.OK
    assert "0 broke a rule" in done.output


@pytest.mark.parametrize("command", ["coverage", "properties"])
def test_an_unknown_task_is_named(app: typer.Typer, command: str) -> None:
    done = CliRunner().invoke(app, ["tree", command, "dance"])
    assert isinstance(done.exception, CommandError)
    assert "'dance'" in str(done.exception)
