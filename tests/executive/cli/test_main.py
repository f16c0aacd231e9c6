"""The ``tandem`` command without a robot: what it says, and what it ends with."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tandem.executive.cli.exit_codes import MEANINGS, ExitCode
from tandem.executive.cli.main import main
from tandem.executive.cli.sending import _with_id, describe_failure
from tandem.executive.config import run_options as options
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.wire import zenoh_bus

NOWHERE = ["--connect", "tcp/127.0.0.1:1"]


@pytest.mark.parametrize(
    ("argv", "code", "said"),
    [
        (["tree", "list"], 0, "fetch"),
        (["scenario", "list"], 0, "OneOfEverything"),
        (["scenario", "check", "Demo"], 0, "valid scenario"),
        (["scenario", "check", "nope"], 2, "no scenario 'nope'; expected"),
        (["scenario", "check", "nope.yaml"], 2, "nope.yaml: cannot read"),
        (["tree", "render", "dance"], 2, "expected one of fetch"),
        (["tree", "render"], 2, "TASK or --live"),
        (
            ["tree", "render", "fetch", "--request", '{"task": "fetch", "item": 30}'],
            2,
            "item: expected one of",
        ),
        (["tree", "render", "fetch", "--site", "moon"], 2, "no site 'moon'"),
        (["tree", "render", "fetch", "-o", "no/such/folder/tree.svg"], 2, "--output"),
        (["tree", "render", "fetch", "--format", "jpeg"], 2, ""),
        (["demo", "--speed", "fast"], 2, "--speed"),
        (["demo", "--scenario", "nope"], 2, "no scenario 'nope'"),
        (["up", "--connect", "here"], 2, "--connect"),
        (["up", "--robot", "a/b"], 2, "--robot"),
        (["request", "fetch", *NOWHERE], 3, "tandem up"),
        (["request", "fetch", "--help", *NOWHERE], 3, "tandem up"),
        (["request", "fetch", "--connect", "here"], 2, "--connect"),
        (["request", "json", "@no/such", *NOWHERE], 2, "cannot read 'no/such'"),
        (["request", "fetch", "--item", "29", *NOWHERE], 3, "tandem up"),
        (["tasks", *NOWHERE], 3, "tandem up"),
        (["cancel", "fetch-1", *NOWHERE], 3, "tandem up"),
        (["cancel", "--all", *NOWHERE], 3, "tandem up"),
        (["retry", "fetch-1", *NOWHERE], 3, "tandem up"),
        (["watch", *NOWHERE], 3, "tandem up"),
        (["pause", *NOWHERE], 3, "tandem up"),
        (["resume", "fetch-1", *NOWHERE], 3, "tandem up"),
        (["step", *NOWHERE], 3, "tandem up"),
        (["why", *NOWHERE], 3, "tandem up"),
        (["tree", "render", "--live", *NOWHERE], 3, "tandem up"),
        (["--version"], 0, "tandem "),
        (["--log", "/dev/null/log", "tree", "list"], 2, "--log"),
        (["dance"], 2, "dance"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_what_it_says_and_ends_with(
    argv: list[str], code: int, said: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(argv) == code
    out, err = capfd.readouterr()
    assert said in out + err
    assert "Traceback" not in out + err


@pytest.mark.parametrize("form", ["unicode", "ascii", "dot", "svg", "png", "json"])
def test_a_tree_is_drawn_into_a_file(form: str, tmp_path: Path) -> None:
    path = tmp_path / f"tree.{form}"
    assert main(["tree", "render", "fetch", "--all", "--format", form, "--output", str(path)]) == 0
    assert path.stat().st_size > 1000


def test_schemas_as_one_document_and_as_files(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["schema"]) == 0
    assert "FetchRequest" in json.loads(capfd.readouterr().out)["$defs"]
    assert main(["schema", "--output", str(tmp_path)]) == 0
    assert "TaskStatus.schema.json" in {path.name for path in tmp_path.iterdir()}


def test_a_mistake_of_ours_leaves_its_trace_in_the_log(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def broken() -> None:
        raise RuntimeError("oh")

    monkeypatch.setattr("tandem.trees.registry.discover", broken)
    log = tmp_path / "log"
    assert main(["--log", str(log), "schema"]) == ExitCode.BUG
    assert "Traceback" in log.read_text()
    err = capfd.readouterr().err
    assert "RuntimeError: oh" in err
    assert "Traceback" not in err


@pytest.mark.parametrize("document", ['{"task": "fetch", "item": 29}', "{}", ' {"a": {"b": 1}}'])
def test_a_document_gets_an_id_so_that_it_can_be_asked_again(document: str) -> None:
    made = json.loads(_with_id(document.encode()))
    assert len(made.pop("id")) == 32
    assert made == json.loads(document)


@pytest.mark.parametrize("document", ["{", "[]", '{"id": "mine"}', '{"item": 1, "item": 2'])
def test_what_is_wrong_or_has_an_id_is_sent_as_it_is(document: str) -> None:
    assert _with_id(document.encode()) == document.encode()


def test_a_failure_is_told_with_its_chain_and_who_can_help() -> None:
    cause = Failure(kind=FailureKind.NO_IK, message="no joints", evidence={"distance_m": 0.9})
    text = describe_failure(Failure(kind=FailureKind.ITEM_UNREACHABLE, message="no arm", causes=(cause,)))
    assert "ITEM_UNREACHABLE: no arm" in text
    assert "distance_m 0.9" in text
    assert "who can help: base" in text


def test_every_exit_code_is_explained() -> None:
    assert set(MEANINGS) == set(ExitCode)


def test_one_default_endpoint() -> None:
    assert options.DEFAULT_ENDPOINT == zenoh_bus.DEFAULT_ENDPOINT


def test_help_loads_neither_messages_nor_trees_nor_zenoh() -> None:
    code = (
        "import sys; from tandem.executive.cli.main import main; main(['--help']);"
        "print([n for n in ('zenoh', 'py_trees', 'numpy', 'cv2', 'pybullet', 'tandem.skills.ports.message')"
        " if n in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == "[]"
