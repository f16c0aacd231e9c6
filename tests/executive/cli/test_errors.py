"""What goes wrong is said on standard error; standard output has what was asked for, and else nothing."""

from __future__ import annotations

import ast

import pytest

from tandem.executive.cli.main import main
from tests.executive.cli.test_connection import CLI, all_commands

OF_ERRORS = ("BAD_INPUT", "NOBODY_THERE", "REFUSED", "UNKEPT")
"""Exit codes of what went wrong. ``TASK_FAILED`` may be the end of what was carried out and told."""


@pytest.mark.parametrize("name", sorted(all_commands()))
def test_no_command_says_what_is_wrong_on_standard_output(
    name: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main([*name.split(), "--no-such-option"]) == 2
    said = capfd.readouterr()
    assert said.out == ""
    assert "--no-such-option" in said.err


def test_a_command_that_can_not_raises_the_error_that_main_says() -> None:
    """With ``typer.Exit`` each command would say it in its own way; ``main`` says each ``CommandError``."""
    codes = [
        ast.unparse(node)
        for path in CLI.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "typer.Exit"
    ]
    assert [code for code in codes if any(each in code for each in OF_ERRORS)] == []


def test_only_two_places_write_errors() -> None:
    """``main`` for all commands, and ``run_ending`` for runs, which go on after some of them."""
    makers = {
        path.relative_to(CLI).as_posix()
        for path in CLI.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value.startswith("error: ")
    }
    assert makers == {"main.py", "run_ending.py", "start.py"}
