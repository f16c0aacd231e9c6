"""Scenarios: those that come along are right, and mistakes are told with file, path and expectation."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tandem.sim.scenario import Scenario, ScenarioError, load_scenario, scenario_names
from tandem.sim.scene import build_scene
from tandem.sim.things import TrueItem
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sources import DocumentError, Source
from tandem.skills.site import load


@pytest.mark.parametrize("name", scenario_names())
def test_each_packaged_scenario_fits_its_site(name: str) -> None:
    scenario = load_scenario(name)
    assert scenario.name == name
    assert build_scene(load(scenario.site), scenario)


def test_the_demo_has_what_is_promised() -> None:
    demo = load_scenario("Demo")
    assert len(demo.items) >= 8
    assert {29, 42} <= {item.item for item in demo.items}
    assert abs(demo.noise.odometry_scale) >= 0.02
    assert demo.noise.laser_sigma >= 0.010
    assert demo.noise.depth_sigma > 0.0
    assert len({item.support for item in demo.items}) >= 2


@pytest.mark.parametrize(
    ("text", "path", "said"),
    [
        ("name: [", "", "not YAML"),
        ("name: x\n site: lab", "line 2", "indented as its neighbours"),
        ("items:\n  - {item: 1}\n - {item: 2}", "line 3", "indented as its neighbours"),
        ("- 1", "", "a mapping"),
        ("name: x", "start", "expected a value"),
        ("{name: x, start: {x: 0, y: 0, yaw: 0}, colour: red}", "colour", "no such field"),
        ("{name: x, start: {x: a, y: 0, yaw: 0}}", "start.x", "a number"),
        ("{name: x, start: {x: .nan, y: 0, yaw: 0}}", "start.x", "finite"),
        (
            "{name: x, start: {x: 0, y: 0, yaw: 0}, items: [{item: 9, support: table, x: 0, y: 0, mass: 7}]}",
            "items.0.mass",
            "less than or equal to 5",
        ),
    ],
)
def test_a_mistake_is_told_with_file_and_path(tmp_path: Path, text: str, path: str, said: str) -> None:
    file = tmp_path / "mine.yaml"
    file.write_text(text)
    with pytest.raises(DocumentError) as caught:
        load_scenario(file)
    assert str(caught.value).startswith(str(file))
    assert path in str(caught.value)
    assert said in str(caught.value)


def test_an_unknown_name_is_answered_with_the_names_there_are() -> None:
    with pytest.raises(ScenarioError, match=r"Defaults, Demo, .*OneOfEverything"):
        load_scenario("Dmo")


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(DocumentError, match=r"none\.yaml: cannot read"):
        load_scenario(tmp_path / "none.yaml")


def test_an_item_may_be_there_once() -> None:
    demo = load_scenario("Demo")
    doubled = {**demo.model_dump(), "items": [demo.item(29), demo.item(29)]}
    with pytest.raises(ValueError, match="each item once; several times there: 29"):
        type(demo).model_validate(doubled)


@pytest.mark.parametrize(
    ("item", "said"),
    [
        (TrueItem(item=500, support="table", x=1.0, y=0.5), "items.0.item: expected one of 3 (salt), 7"),
        (TrueItem(item=29, support="sofa", x=1.0, y=0.5), "items.0.support: no furniture 'sofa'"),
        (TrueItem(item=29, support="table", x=-1.0, y=0.5), "is not above table"),
    ],
)
def test_what_the_site_has_no_place_for_is_refused(item: TrueItem, said: str) -> None:
    scenario = load_scenario("Defaults").model_copy(update={"items": (item,)})
    with pytest.raises(ScenarioError, match=r"mine\.yaml") as caught:
        build_scene(load("lab"), scenario, source=Source("mine.yaml"))
    assert said in str(caught.value)


def test_variants_leave_the_original_alone() -> None:
    demo = load_scenario("Demo")
    moved = demo.with_item(TrueItem(item=29, support="shelf_board", x=-1.0, y=2.7))
    assert moved.item(29).support == "shelf_board"
    assert demo.item(29).support == "table"
    assert len(demo.without_item(29).items) == len(demo.items) - 1
    assert demo.starting_at(FloorPose(x=0.0, y=-2.0, yaw=0.0)).start.y == -2.0


@pytest.mark.parametrize(
    "demo",
    [
        {"robot": "r9", "request": {"task": "inspect"}},
        {"request": {"task": "inspect"}, "beside": [{"robot": "r1", "request": {"task": "inspect"}}]},
    ],
    ids=["nobody", "one that a script drives"],
)
def test_a_demo_asks_a_robot_with_an_executive(demo: dict[str, object]) -> None:
    shown = load_scenario("Rocs3").model_dump(mode="json") | {"demo": demo}
    with pytest.raises(ValueError, match=r"demo: expected a robot with an executive \(r2, r3\); found"):
        Scenario.model_validate_json(json.dumps(shown))


def test_a_scenario_like_another_says_only_what_differs(tmp_path: Path) -> None:
    (tmp_path / "base.yaml").write_text(
        "{name: base, site: room.yaml, start: {x: 0, y: 0, yaw: 0}, camera_rate: 2.0, "
        "noise: {laser_sigma: 0.1}}"
    )
    (tmp_path / "more").mkdir()
    mine = tmp_path / "more" / "mine.yaml"
    mine.write_text("{like: ../base.yaml, name: mine, noise: {depth_sigma: 0.1}}")
    made = load_scenario(mine)
    assert (made.name, made.camera_rate) == ("mine", 2.0)
    assert made.noise.laser_sigma == 0.0, "a field is taken whole"
    assert Path(made.site) == tmp_path / "more" / ".." / "room.yaml"


@pytest.mark.parametrize(
    ("text", "robots"),
    [
        ("{like: Locobot, name: mine, robot: p3dx}", ["p3dx"]),
        (
            "{like: LocobotCompany, name: mine, robot: p3dx, start: {x: 0, y: 0, yaw: 0}, demo: null}",
            ["p3dx"],
        ),
        (
            "{like: Locobot, name: mine, robots: [{name: r1, robot: p3dx, start: {x: 0, y: 0, yaw: 0}}]}",
            ["p3dx"],
        ),
        ("{like: LocobotCompany, name: mine}", ["locobot", "p3dx"]),
    ],
    ids=["another robot", "one instead of several", "several instead of one", "several"],
)
def test_robots_are_taken_in_one_form_only(tmp_path: Path, text: str, robots: list[str]) -> None:
    (tmp_path / "mine.yaml").write_text(text)
    assert [each.robot for each in load_scenario(tmp_path / "mine.yaml").placed] == robots


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{like: Dmo, name: x}", "mine.yaml: like (line 1): no scenario 'Dmo'"),
        ("{like: [Demo], name: x}", "expected the name or path of a scenario; found ['Demo']"),
        ("{like: none.yaml, name: x}", "none.yaml: cannot read"),
        ("{like: mine.yaml, name: x}", "expected no circle; found"),
        ("{like: Demo}\nname: x", "not YAML"),
    ],
)
def test_one_that_is_like_nothing_is_refused(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "mine.yaml").write_text(text)
    with pytest.raises(DocumentError) as caught:
        load_scenario(tmp_path / "mine.yaml")
    assert said in str(caught.value)


NAMED = (
    "{name: mine, site: lab, start: {x: -0.8, y: 1.2, yaw: 0}, items: [{%s, support: table, x: 0.5, y: 0.6}]}"
)


@pytest.mark.parametrize("said", ["item: 29", "item: tea", "tag: 29"])
def test_an_item_is_said_by_its_number_or_by_its_name(said: str, tmp_path: Path) -> None:
    (tmp_path / "mine.yaml").write_text(NAMED % said)
    assert load_scenario(tmp_path / "mine.yaml").item(29).support == "table"


@pytest.mark.parametrize(
    ("said", "reason"),
    [
        ("item: cocoa", "items.0.item (line 1): expected one of the site's items: 3 (salt), 7, 11"),
        ("item: tea, tag: 29", "items.0.tag (line 1): expected no such field, found 29"),
        ("tag: true", "items.0.tag (line 1): expected a whole number, found true"),
        ("mass: 0.1", "items.0.item (line 1): expected a value"),
    ],
)
def test_an_item_that_is_none_of_the_sites_is_refused(said: str, reason: str, tmp_path: Path) -> None:
    (tmp_path / "mine.yaml").write_text(NAMED % said)
    with pytest.raises(DocumentError) as caught:
        load_scenario(tmp_path / "mine.yaml")
    assert str(caught.value).startswith(f"{tmp_path / 'mine.yaml'}: {reason}")


def test_names_are_those_of_the_site_that_the_scenario_is_to_be_in(tmp_path: Path) -> None:
    (tmp_path / "mine.yaml").write_text(NAMED % "item: tin")
    assert load_scenario(tmp_path / "mine.yaml", "pantry").item(20).x == 0.5
    with pytest.raises(DocumentError, match="no site 'nowhere'"):
        load_scenario(tmp_path / "mine.yaml", "nowhere")


def test_names_of_a_site_that_can_not_be_read_are_told_at_the_site(tmp_path: Path) -> None:
    (tmp_path / "mine.yaml").write_text(NAMED.replace("lab", "none.yaml") % "item: tea")
    with pytest.raises(DocumentError, match=r"mine\.yaml: site \(line 1\): .*none\.yaml: cannot read"):
        load_scenario(tmp_path / "mine.yaml")
