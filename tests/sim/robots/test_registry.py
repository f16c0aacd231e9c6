"""Robots are found by their files and entry points; a wrong name is answered with those there are."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tandem.sim.robots import registry
from tandem.sim.robots.registry import RobotError, names, robot_model, shipped
from tandem.sim.scenario import ScenarioError, load_scenario
from tandem.sim.scene import build_scene
from tandem.skills.site import load


@pytest.mark.parametrize("name", shipped())
def test_a_shipped_robot_is_called_as_its_description_says(name: str) -> None:
    assert robot_model(name).description.name == name


@pytest.mark.parametrize("name", shipped())
def test_each_sensor_sits_on_a_frame_of_the_robot(name: str) -> None:
    model = robot_model(name)
    told = model.description
    sensors = (*told.cameras, *told.lasers, *told.range_sensors, *told.cliff_sensors, *told.robot_sensors)
    assert {each.frame for each in sensors} <= model.frames.keys()
    assert f'name="{sensors[0].frame}"' in told.urdf


@pytest.mark.parametrize("name", shipped())
def test_a_robot_has_bumpers_where_it_feels_contacts(name: str) -> None:
    model = robot_model(name)
    assert bool(model.bumper_links) is bool(model.description.bumpers)


def test_a_robot_whose_description_takes_other_room_than_it_declares_is_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    wide = replace(shipped()["panda"], name="wide", footprint_radius=0.5)
    monkeypatch.setattr(registry, "shipped", lambda: {"wide": wide})
    with pytest.raises(RobotError, match=r"footprint_radius of 0\.5 m .*; found 0\.2 and 1\.6 m"):
        robot_model("wide")


def test_a_wrong_name_is_answered_with_those_there_are() -> None:
    with pytest.raises(RobotError, match=r"no robot 'r2d2'; expected one of .*tiago_dual"):
        robot_model("r2d2")


def test_a_scenario_with_a_wrong_robot_says_where_it_stands() -> None:
    scenario = load_scenario("Defaults").model_copy(update={"robot": "r2d2"})
    with pytest.raises(ScenarioError, match=r"Defaults: robot: expected one of .*tiago_dual.*, found r2d2"):
        build_scene(load("lab"), scenario)


def declare(monkeypatch: pytest.MonkeyPatch, folder: Path, module: str) -> None:
    """Install a package whose entry point ``mine`` is a robot."""
    info = folder / "mine-1.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: mine\nVersion: 1\n")
    (info / "entry_points.txt").write_text("[tandem.robots]\nmine = my_robot:ROBOT\n")
    (folder / "my_robot.py").write_text(module)
    monkeypatch.syspath_prepend(str(folder))


@pytest.mark.parametrize(
    ("module", "told"),
    [
        ("1 / 0", "no robot 'mine'; expected one of .*: ZeroDivisionError: division by zero"),
        ("ROBOT = 3", "no robot 'mine'; expected one of .*mine 1. is left out: expected a Robot; found int"),
    ],
)
def test_a_plug_in_that_is_wrong_is_named_with_its_error(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, module: str, told: str
) -> None:
    declare(monkeypatch, tmp_path, module)
    monkeypatch.delitem(__import__("sys").modules, "my_robot", raising=False)
    assert "mine" in names()
    with pytest.raises(RobotError, match=told):
        robot_model("mine")
