"""Which robot of a scenario a command asks, and what it films."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import cv2
import pytest

from tandem.executive.cli.errors import CommandError
from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.film import SIZE
from tandem.executive.cli.option_checks import checked_film
from tandem.executive.cli.running_system import run_once, run_up
from tandem.executive.cli.shapes import Ran
from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.render.frame import TREE_WIDTH
from tandem.skills.ports.tasks import TaskState

PAIR = """
name: pair
site: rocs
robots:
  - {name: r2, robot: p3dx, start: {x: -1.0, y: 0.0, yaw: 0.0}}
  - {name: r3, robot: summit_xl, start: {x: 1.0, y: 0.0, yaw: 0.0}}
"""


def run(folder: Path, bus: BusOptions, film: Path | None = None, *, as_json: bool = False) -> ExitCode:
    scenario = folder / "pair.yaml"
    scenario.write_text(PAIR, "utf-8")
    request = json.dumps({"task": "follow", "robot": "r2", "seconds": 1.0})
    options = RunOptions(bus=bus, scenario=str(scenario), lockstep=True, request=request, film=film)
    return run_once(replace(options, as_json=as_json))


def test_the_robot_that_is_named_is_asked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, BusOptions(robot="r3")) is ExitCode.OK
    assert "task follow-0001 succeeded" in capsys.readouterr().out


def test_without_a_name_the_first_is_asked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, BusOptions()) is ExitCode.TASK_FAILED
    said = capsys.readouterr().out
    assert "p3dx has no sensor for other robots" in said, "the first is one that can not follow by sight"


def test_the_end_is_a_document_and_the_story_goes_elsewhere(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, BusOptions(robot="r3"), as_json=True) is ExitCode.OK
    said = capsys.readouterr()
    assert Ran.model_validate_json(said.out).status.state is TaskState.SUCCEEDED
    assert "task follow-0001 succeeded" in said.err


def test_a_robot_that_is_not_there_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, BusOptions(robot="r9")) is ExitCode.BAD_INPUT
    said = capsys.readouterr()
    assert "pair.yaml: expected --robot to name one of r2, r3, found r9" in " ".join(said.err.split())
    assert not said.out, "what is wrong goes where errors belong"


def test_a_folder_that_cannot_be_written_is_told_before_any_process_starts(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "plain").write_text("", "utf-8")
    assert run_up(RunOptions(data=tmp_path / "plain" / "data")) is ExitCode.UNKEPT
    assert "the ledger needs a writable folder: Not a directory" in capsys.readouterr().err


def test_a_run_is_filmed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    film = tmp_path / "run.webp"
    assert run(tmp_path, BusOptions(robot="r3"), film) is ExitCode.OK
    assert f"moving picture: {film}" in " ".join(capsys.readouterr().out.split())
    _, animation = cv2.imreadanimation(str(film))
    assert len(animation.frames) >= 2, "a second and more has passed"
    assert animation.frames[0].shape[:2] == (SIZE[1], SIZE[0] + TREE_WIDTH)


def test_a_film_that_cannot_be_written_ends_no_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    taken = tmp_path / "plain"
    taken.write_text("", "utf-8")
    assert run(tmp_path, BusOptions(robot="r3"), taken / "film.webp") is ExitCode.OK
    said = capsys.readouterr()
    assert "no moving picture: " in said.err
    assert "task follow-0001 succeeded" in said.out


def test_a_film_of_an_unknown_kind_is_refused_before_anything_starts() -> None:
    with pytest.raises(
        CommandError, match=r"--film: expected a name that ends in .webp, .gif, .png, found a.mp4"
    ):
        checked_film(Path("a.mp4"))
