"""Where a command finds its robot: one set of options for every command that connects.

The rules are about the commands' code, which a user can't see: tests/outside drives the commands themselves.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Final

import pytest
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command

from tandem.executive.cli.main import build, main

CLI: Final = Path(__file__).parents[3] / "executive" / "cli"
SHARED: Final = {
    "--connect": "TANDEM_CONNECT",
    "--site-key": "TANDEM_SITE",
    "--robot": "TANDEM_ROBOT",
    "--keys": "TANDEM_KEYS",
    "--as": "TANDEM_AS",
}
OF_ITS_OWN: Final = {"demo", "run json", "campaign crash", "campaign restart", "campaign soak"}
"""They start a system of their own, and must not meet the robot that TANDEM_CONNECT names."""


def commands(group: TyperGroup, above: str = "") -> Iterator[tuple[str, TyperCommand]]:
    for name, each in group.commands.items():
        if isinstance(each, TyperGroup):
            yield from commands(each, f"{above}{name} ")
        else:
            assert isinstance(each, TyperCommand)
            yield f"{above}{name}", each


def variables(command: TyperCommand) -> Mapping[str, str]:
    """Return a command's options of the shared set, each with its variable."""
    return {
        option: str(parameter.envvar or "")
        for parameter in command.params
        for option in parameter.opts
        if option in SHARED
    }


def all_commands() -> dict[str, TyperCommand]:
    made = get_command(build())
    assert isinstance(made, TyperGroup)
    return dict(commands(made))


def test_a_command_has_the_whole_shared_set_or_nothing_of_it() -> None:
    odd = {
        name: variables(command)
        for name, command in all_commands().items()
        if variables(command) not in ({}, SHARED) and name not in OF_ITS_OWN
    }
    assert odd == {}


def test_a_run_of_its_own_does_not_read_where_another_robot_is() -> None:
    found = all_commands()
    read = {variable for name in OF_ITS_OWN for variable in variables(found[name]).values()}
    assert read == {""}


def test_no_command_makes_its_own_idea_of_where_the_robot_is() -> None:
    """BusOptions come from ``arguments`` alone, so a new command that connects has the shared set."""
    makers = {
        path.name
        for path in CLI.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Call) and ast.unparse(node.func) in {"BusOptions", "bus_options"}
    }
    assert makers == {"arguments.py", "system_options.py"}, "system_options: a run's own"


@pytest.mark.parametrize(
    ("variable", "value", "said"),
    [
        ("TANDEM_CONNECT", "tcp/127.0.0.1:1", "no router answers at tcp/127.0.0.1:1"),
        ("TANDEM_CONNECT", "here", "--connect"),
        ("TANDEM_CONNECT", "tcp/127.0.0.1:65536", "--connect"),
        ("TANDEM_SITE", "a/b", "--site-key"),
        ("TANDEM_ROBOT", "a/b", "--robot"),
        ("TANDEM_AS", "alice", "--as needs --keys"),
        ("TANDEM_KEYS", "/nowhere", "/nowhere: expected the key of one client"),
    ],
)
def test_the_environment_is_read(
    variable: str, value: str, said: str, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv(variable, value)
    assert main(["stop"]) in {2, 3}
    assert said in capfd.readouterr().err


def test_tls_without_keys_is_said_at_once(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["stop", "--connect", "tls/127.0.0.1:7448"]) == 2
    assert "TLS needs keys" in capfd.readouterr().err
