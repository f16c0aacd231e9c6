"""``tandem.yaml``: the command line beats it, it beats the defaults; a wrong one is refused with its line."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command

from tandem.executive.cli.defaults import defaults
from tandem.executive.cli.main import build, main
from tandem.executive.config.project import Project, read_project

FILE = """\
scenario: scenarios/first.yaml
site: bimanual
connect: tcp/127.0.0.1:7999
site_key: workshop
robot: tim
keys: keys
as: tim
data: ../data
speed: max
only: [router, hardware]
listen: [tls/0.0.0.0:7447]
on_restart: ask
"""


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a project's file, where the commands are typed."""
    for name in ("TANDEM_CONNECT", "TANDEM_SITE", "TANDEM_ROBOT", "TANDEM_KEYS", "TANDEM_AS"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tandem.yaml").write_text(FILE)
    return tmp_path


def test_paths_are_relative_to_the_file_and_names_stay_names(project: Path) -> None:
    read = read_project(project / "tandem.yaml")
    assert read.scenario == str(project / "scenarios" / "first.yaml")
    assert read.site == "bimanual"
    assert read.keys == str(project / "keys")
    assert read.data == str(project / ".." / "data")


def made(project: Path, *words: str) -> Mapping[str, object]:
    """Return a command's defaults."""
    whole = get_command(build())
    found: object = defaults(whole, read_project(project / "tandem.yaml"))
    for word in words:
        assert isinstance(found, dict)
        found = found[word]
    assert isinstance(found, dict)
    return found


def test_up_takes_all_of_it(project: Path) -> None:
    taken = made(project, "up")
    assert set(taken) == {
        "scenario", "site", "connect", "site_key", "robot", "keys", "holder", "data", "speed", "only",
        "listen", "on_restart",
    }  # fmt: skip
    assert taken["only"] == "router,hardware"


def test_a_client_takes_the_way_to_the_robot_and_a_campaign_the_room(project: Path) -> None:
    way = {"connect", "site_key", "robot", "keys", "holder"}
    assert set(made(project, "cancel")) == way
    for command in ("tasks", "why", "logs", "retry", "export"):
        assert set(made(project, command)) == {*way, "data"}, "also while nothing runs"
    assert set(made(project, "tree", "render")) == {*way, "site"}
    assert set(made(project, "campaign", "fetch")) == {"scenario", "site"}
    assert "demo" not in made(project)


def test_every_key_of_the_file_is_an_option_of_up() -> None:
    whole = get_command(build())
    assert isinstance(whole, TyperGroup)
    up = whole.commands["up"]
    assert isinstance(up, TyperCommand)
    options = {option for parameter in up.params for option in parameter.opts}
    keys = {info.alias or name for name, info in Project.model_fields.items()}
    assert {f"--{key.replace('_', '-')}" for key in keys} <= options


@pytest.mark.parametrize(
    "case",
    [
        ((), "", "7999"),
        ((), "tcp/127.0.0.1:8001", "8001"),
        (("--connect", "tcp/127.0.0.1:8000"), "tcp/127.0.0.1:8001", "8000"),
    ],
)
def test_typed_beats_environment_beats_file(
    project: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    case: tuple[tuple[str, ...], str, str],
) -> None:
    words, environment, endpoint = case
    (project / "tandem.yaml").write_text("connect: tcp/127.0.0.1:7999\n")
    if environment:
        monkeypatch.setenv("TANDEM_CONNECT", environment)
    assert main(["pause", *words]) == 3
    assert f"no router answers at tcp/127.0.0.1:{endpoint}" in capsys.readouterr().err


def test_it_is_found_elsewhere_when_it_is_named(
    project: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (project / "tandem.yaml").write_text("connect: tcp/127.0.0.1:7999\n")
    monkeypatch.chdir(project.parent)
    for named in (project, project / "tandem.yaml"):
        assert main(["--project", str(named), "pause"]) == 3
        assert "127.0.0.1:7999" in capsys.readouterr().err
    assert main(["--project", str(project.parent), "pause"]) == 2
    assert "expected a folder with tandem.yaml in it" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "error"),
    [
        ("scenario: Demo\nscenery: Demo\n", "tandem.yaml: scenery (line 2): expected no such field"),
        ("speed: fast\n", "tandem.yaml: speed"),
        ("seed: -1\n", "tandem.yaml: seed (line 1)"),
        ("- scenario\n", "tandem.yaml"),
    ],
)
def test_a_wrong_one_is_refused(
    project: Path, capsys: pytest.CaptureFixture[str], text: str, error: str
) -> None:
    (project / "tandem.yaml").write_text(text)
    assert main(["plugins"]) == 2
    assert error in capsys.readouterr().err


def test_a_request_finds_the_robot_of_the_project(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (project / "tandem.yaml").write_text("connect: tcp/127.0.0.1:7999\n")
    for words in (("fetch", "--item", "3"), ("json", "{}")):
        assert main(["request", *words]) == 3
        assert "no router answers at tcp/127.0.0.1:7999" in capsys.readouterr().err


def test_the_site_of_the_projects_scenario_is_that_of_commands_without_a_scenario(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tandem.yaml").write_text("scenario: TwoArms\n")
    wrong = '{"task": "fetch", "item": 29, "near": "nowhere"}'
    assert main(["tree", "render", "fetch", "--request", wrong]) == 2
    there = capfd.readouterr().err
    assert main(["tree", "render", "fetch", "--request", wrong, "--site", "bimanual"]) == 2
    assert capfd.readouterr().err == there


def test_a_scenario_that_is_checked_stands_in_its_own_site_and_not_in_that_of_the_projects(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tandem.yaml").write_text("scenario: Bench\n")
    assert main(["scenario", "check", "Defaults"]) == 0
    assert "site lab" in capsys.readouterr().out
