"""Which robot of a scenario a command asks."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tandem.executive.cli.exit_codes import ExitCode
from tandem.executive.cli.running_system import run_once
from tandem.executive.config.run_options import BusOptions, RunOptions

PAIR = """
name: pair
site: rocs
robots:
  - {name: r2, robot: p3dx, start: {x: -1.0, y: 0.0, yaw: 0.0}}
  - {name: r3, robot: summit_xl, start: {x: 1.0, y: 0.0, yaw: 0.0}}
"""


def run(folder: Path, bus: BusOptions) -> ExitCode:
    scenario = folder / "pair.yaml"
    scenario.write_text(PAIR, "utf-8")
    request = json.dumps({"task": "follow", "robot": "r2", "seconds": 1.0})
    return run_once(RunOptions(bus=bus, scenario=str(scenario), lockstep=True, request=request))


def test_the_robot_that_is_named_is_asked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, BusOptions(robot="r3")) is ExitCode.OK
    assert "task follow-0001 succeeded" in capsys.readouterr().out


def test_without_a_name_the_first_is_asked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, BusOptions()) is ExitCode.TASK_FAILED
    said = capsys.readouterr().out
    assert "p3dx has no sensor for other robots" in said, "the first is one that can not follow by sight"


def test_a_robot_that_is_not_there_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, BusOptions(robot="r9")) is ExitCode.BAD_INPUT
    said = " ".join(capsys.readouterr().out.split())
    assert "pair.yaml: expected --robot to name one of r2, r3, found r9" in said
