"""Robots are found by their files and entry points; a wrong name is answered with those there are."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tandem.sim.body import RobotBody
from tandem.sim.model import Wheels
from tandem.sim.physics import Physics
from tandem.sim.robots import registry
from tandem.sim.robots.registry import RobotError, names, robot_model, shipped
from tandem.sim.scenario import ScenarioError, load_scenario
from tandem.sim.scene import build_scene
from tandem.sim.stationed import DEEP
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sources import DocumentError
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
    wide = replace(shipped()["panda"], footprint_radius=0.5)
    monkeypatch.setattr(registry, "shipped", lambda: {"panda": wide})
    robot_model.cache_clear()
    with pytest.raises(RobotError, match=r"footprint_radius of 0\.5 m .*; found 0\.2 and 1\.6 m"):
        robot_model("panda")


def told_of(monkeypatch: pytest.MonkeyPatch, compose: Callable[[], object]) -> str:
    """Return in which words a robot called panda, put together so, is refused."""
    mine = replace(shipped()["panda"], compose=compose)  # type: ignore[arg-type] - a file may return anything
    monkeypatch.setattr(registry, "shipped", lambda: {"panda": mine})
    robot_model.cache_clear()
    with pytest.raises(DocumentError) as caught:
        robot_model("panda")
    robot_model.cache_clear()
    return str(caught.value)


def test_whatever_a_robots_file_raises_is_the_files_mistake(monkeypatch: pytest.MonkeyPatch) -> None:
    def compose() -> object:
        raise KeyError("no joint 'elbow' in this URDF")

    said = told_of(monkeypatch, compose)
    assert said.startswith("robot 'panda' can't be put together: KeyError:")
    assert "no joint 'elbow'" in said
    assert "test_registry.py:" in said


def test_a_description_that_its_model_refuses_is_told_without_pydantics_words(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    told = robot_model("panda").description.model_dump()
    told["postures"][0]["positions"] = (0.0,)
    said = told_of(monkeypatch, lambda: RobotDescription.model_validate(told))
    assert "posture 'home' of 'arm_single': expected 7 positions, found 1" in said
    assert "pydantic" not in said


def test_what_is_no_model_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "expected compose to return a RobotModel; found 3" in told_of(monkeypatch, lambda: 3)


def test_parts_that_do_not_fit_are_told_all_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    model = robot_model("panda")
    hand = model.description.end_effectors[0].model_copy(update={"frame": "tip", "touch_links": ("thumb",)})
    description = model.description.model_copy(update={"end_effectors": (hand,)})
    said = told_of(monkeypatch, lambda: replace(model, description=description))
    assert "expected link 'tip' in the URDF, the tool frame of hand single, found no such link" in said
    assert "expected link 'thumb' in the URDF, a touch_link of single, found no such link" in said


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"touching_links": (("panda_link5", "elbow"),)}, "touching_links: no link 'elbow' in the physics"),
        ({"hands": ()}, "hands: expected those of the description, ('single',), found ()"),
        ({"root": "floor"}, "expected 'floor' as the first link, found 'base_footprint'"),
        ({"wheels": Wheels(("left",), ("right",), 0.1, 0.4, 8.0)}, "wheels: no joint 'left' in the physics"),
        ({"wheels": Wheels((), (), 0.1, 0.4, 8.0)}, "expected wheels and a drive in the description"),
        ({"frames": {}}, "camera head: no frame 'post_optical_frame'"),
    ],
)
def test_what_the_physics_lacks_is_named(
    monkeypatch: pytest.MonkeyPatch, change: Mapping[str, Any], said: str
) -> None:
    model = robot_model("panda")
    assert said in told_of(monkeypatch, lambda: replace(model, **change))


def test_links_in_each_other_at_home_are_named_before_the_physics_pushes_them_apart() -> None:
    model = robot_model("panda")
    wrist = {"panda_joint6": 0.0}
    body = RobotBody(Physics(), replace(model, touching_links=()), positions=wrist)
    depth, *links = body.overlaps()[0]
    assert depth > DEEP
    assert links == ["panda_link5", "panda_link7"]
    told = RobotBody(
        Physics(), replace(model, touching_links=(("panda_link7", "panda_link5"),)), positions=wrist
    )
    assert ("panda_link5", "panda_link7") not in [each[1:] for each in told.overlaps()]


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
