"""``tandem tree``: pictures, coverage and properties."""

import pytest
import typer
from typer.testing import CliRunner

from tandem.executive.cli.commands import tree_commands
from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.render.outline import HIDES
from tandem.skills.ports.tasks import TreeNode


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


def test_the_command_offers_everything_that_can_be_hidden() -> None:
    assert [each.value for each in tree_commands.Hide] == list(HIDES)


@pytest.mark.parametrize(
    ("options", "first", "at_most"),
    [
        ([], "→ fetch", 40),
        (["--depth", "1"], "→ fetch", 3),
        (
            ["--focus", "pick item", "--hide", "recoveries", "--hide", "guards", "--depth", "1"],
            "→ pick item",
            11,
        ),
        (["--focus", "fetch/request"], "δ request", 20),
    ],
)
def test_a_picture_is_as_large_as_is_asked_for(
    app: typer.Typer, options: list[str], first: str, at_most: int
) -> None:
    done = CliRunner().invoke(app, ["tree", "render", "fetch", *options])
    lines = done.stdout.splitlines()
    assert lines[0] == first
    assert len(lines) <= at_most


@pytest.mark.parametrize("options", [["--all"], ["--depth", "0"], ["--format", "json"]])
def test_every_node_is_there_on_request(app: typer.Typer, options: list[str]) -> None:
    done = CliRunner().invoke(app, ["tree", "render", "fetch", *options])
    assert "which one is meant?" in done.stdout
    assert "place: note the slot is taken" in done.stdout


def test_json_of_a_part_is_a_tree(app: typer.Typer) -> None:
    done = CliRunner().invoke(app, ["tree", "render", "fetch", "--format", "json", "--focus", "pick item"])
    assert TreeNode.model_validate_json(done.stdout).name == "pick item"


def test_an_unknown_focus_is_named(app: typer.Typer) -> None:
    done = CliRunner().invoke(app, ["tree", "render", "fetch", "--focus", "pik item"])
    assert isinstance(done.exception, CommandError)
    assert "similar: 'pick item'" in str(done.exception)
