"""The order-picking paper's phases and figures, out of runs that were written by hand."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import cv2
import pytest

from tandem.executive.render.example import example_request, tree_of
from tandem.executive.trials.picking.phases import STEPS, phase_of, seconds, stretches
from tandem.executive.trials.picking.pictures import Album, scene_panels, workflow_panels
from tandem.executive.trials.picking.plans import HOME_DRIVES, repositioning_figure, search_figure
from tandem.executive.trials.picking.run import run_picking
from tandem.executive.trials.picking.settings import Phase, PickingOptions, PickingRun, Point, Stretch
from tandem.executive.trials.picking.summary import summary
from tandem.executive.trials.picking.witness import Known, Shot
from tandem.sim.render import Painter, PainterSettings
from tandem.sim.render_world import Posed, Snapshot
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import load_scenario
from tandem.sim.scene import build_scene, item_name
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.tasks import NodeStatus, Span, TreeNode
from tandem.skills.site import load
from tandem.trees.registry import discover

SITE = load("picking")
P = Phase
WORK: tuple[tuple[Phase, str, float, float, bool], ...] = (
    (P.REQUEST, "localise", 0.2, 1.0, True),
    (P.SEARCH, "look here", 1.0, 3.0, False),
    (P.SEARCH, "turn 30 degrees here", 3.0, 4.0, True),
    (P.SEARCH, "look again here", 4.0, 6.0, True),
    (P.APPROACH, "drive to item", 6.0, 10.0, True),
    (P.PICK, "open", 10.0, 10.5, False),
    (P.RECOVERY, HOME_DRIVES, 11.0, 20.0, True),
    (P.SEARCH, "look here", 20.0, 22.0, True),
    (P.APPROACH, "drive to item", 22.0, 26.0, True),
    (P.PICK, "grasp", 26.0, 27.0, True),
    (P.PICK, "close", 27.0, 28.0, True),
    (P.PICK, "attach", 28.0, 28.1, True),
    (P.CARRY, "drive to slot", 29.0, 35.0, True),
    (P.PLACE, "let go", 35.0, 36.0, True),
    (P.PLACE, "detach", 36.0, 36.1, True),
    (P.PLACE, "withdraw", 36.1, 37.0, True),
    (P.PLACE, "close empty", 37.0, 37.5, True),
    (P.HOME, "home: drive", 38.0, 44.0, True),
)


def made(work: tuple[tuple[Phase, str, float, float, bool], ...] = WORK) -> PickingRun:
    done = tuple(
        Stretch(phase=phase, node=node, begin=begin, end=end, ended_well=well)
        for phase, node, begin, end, well in work
    )
    return PickingRun(
        run=3,
        item=29,
        place=FloorPose(x=1.8, y=0.3, yaw=0.0),
        state="SUCCEEDED",
        wrong=(),
        failure=None,
        lasted=45.0,
        phases=seconds(done, 45.0),
        stretches=done,
        path=tuple(Point(at=at / 2, x=at / 90, y=0.0, yaw=at / 20) for at in range(90)),
    )


def leaves(node: TreeNode) -> Iterator[TreeNode]:
    if node.kind == "action":
        yield node
    for child in node.children:
        yield from leaves(child)


@pytest.fixture(scope="module")
def paths() -> dict[str, list[str]]:
    """Return the paths of the leaves of the real fetch's tree, by name."""
    kind = discover()["fetch"]
    found: dict[str, list[str]] = {}
    for leaf in leaves(tree_of(kind, SITE, example_request(kind, SITE))):
        found.setdefault(leaf.name, []).append(leaf.path)
    return found


@pytest.mark.parametrize(
    ("leaf", "phase"),
    [
        ("localise", P.REQUEST),
        ("look here", P.SEARCH),
        ("turn 30 degrees at spot", P.SEARCH),
        ("drive to item", P.APPROACH),
        ("look closely at item", P.APPROACH),
        ("pre-grasp", P.PICK),
        ("after pick: tuck arm", P.PICK),
        ("drive to slot", P.CARRY),
        ("put down", P.PLACE),
        ("close empty", P.PLACE),
        ("home: drive", P.HOME),
        ("get: localise anew", P.RECOVERY),
        ("place: home: drive", P.RECOVERY),
        (HOME_DRIVES, P.RECOVERY),
    ],
)
def test_each_leaf_of_the_fetch_belongs_to_a_phase(
    paths: dict[str, list[str]], leaf: str, phase: Phase
) -> None:
    assert {phase_of(path) for path in paths[leaf]} == {phase}


def test_the_papers_steps_are_leaves_of_the_fetch(paths: dict[str, list[str]]) -> None:
    assert set(STEPS) <= set(paths)


def test_spans_become_work_after_the_request_and_what_never_ended_is_none() -> None:
    def at(seconds: float, boot: str = "b") -> RobotTime:
        return RobotTime(boot=boot, seconds=seconds)

    def span(name: str, begin: RobotTime, end: RobotTime | None) -> Span:
        return Span(path=f"f/search/{name}", kind="action", begin=begin, end=end, status=NodeStatus.SUCCESS)

    spans = (span("two", at(12), at(13)), span("one", at(11), at(12)), span("on", at(13), None))
    work = stretches((*spans, span("other boot", at(1, "c"), at(2, "c"))), at(10))
    assert [(each.node, each.begin, each.end, each.phase) for each in work] == [
        ("one", 1.0, 2.0, P.SEARCH),
        ("two", 2.0, 3.0, P.SEARCH),
    ]


def test_phases_last_until_the_next_begins_and_add_up_to_the_whole() -> None:
    run = made()
    assert run.phases[P.SEARCH] == pytest.approx(7.0)
    assert run.phases[P.RECOVERY] == pytest.approx(9.0)
    assert run.phases[P.PICK] == pytest.approx(4.0)
    assert sum(run.phases.values()) == pytest.approx(run.lasted)


def test_the_search_is_drawn_with_each_look_until_the_item_was_seen() -> None:
    drawn = search_figure(made(), SITE)
    assert drawn is not None
    assert "2 looks, 1 turns of 30 degrees" in drawn
    assert "seen after 6.0 s" in drawn


def test_an_item_in_view_has_no_search_and_nobody_who_went_on_has_no_new_try() -> None:
    run = made(tuple(each for each in WORK if not each[1].startswith("turn") and each[1] != HOME_DRIVES))
    assert search_figure(run, SITE) is None
    assert repositioning_figure(run, SITE) is None


def test_the_new_try_shows_where_the_arm_failed_home_and_where_it_did_not() -> None:
    drawn = repositioning_figure(made(), SITE)
    assert drawn is not None
    assert "where the arm failed, 1 times" in drawn
    assert "picked at 28.0 s" in drawn


def test_the_summary_has_a_row_for_each_phase_and_each_step_that_was_done() -> None:
    lines = summary(PickingOptions(), (made(), made()))
    assert "  right: 2 of 2" in lines
    assert any(line.split()[:2] == ["search", "(III-A.2)"] and "7.0" in line for line in lines)
    assert any("withdraw (III-D.2 c)" in line for line in lines)
    assert not any("put down" in line for line in lines)


def shot(at: float, known: Known) -> Shot:
    scenario = load_scenario("Locobot")
    things = tuple((body.name, body.pose) for body in build_scene(SITE, scenario) if body.mass)
    robot = Posed(base_in_map=Pose(position=(1.2, 0.3, 0.0)), joints=())
    return Shot(at=at, known=known, snapshot=Snapshot(robots=(robot,), bodies=things))


SHOTS = (
    *(shot(at, "not") for at in (0.0, 5.0, 24.0)),
    shot(26.2, "there"),
    shot(28.2, "held"),
    *(shot(at, "there") for at in (36.2, 37.2)),
)


def test_the_moments_of_the_scene_are_the_papers() -> None:
    panels = scene_panels(made(), SHOTS)
    assert [panel.words[0] for panel in panels] == ["a", "b", "c", "d", "e"]
    assert [panel.shot.known for panel in panels] == ["not", "there", "held", "there", "there"]


def test_the_workflow_begins_with_the_search_and_ends_at_home() -> None:
    panels = workflow_panels(made(), SHOTS)
    assert [panel.shot.at for panel in panels] == [5.0, 28.2, 36.2, 37.2]


def test_what_was_never_picked_has_no_pictures() -> None:
    failed = made(tuple(each for each in WORK if each[0] is not P.PICK))
    assert scene_panels(failed, SHOTS) == workflow_panels(failed, SHOTS) == ()


def test_the_item_is_green_in_the_scene_and_purple_in_the_hand(tmp_path: Path) -> None:
    bodies = build_scene(SITE, load_scenario("Locobot"))
    assert item_name(29) in {body.name for body in bodies}
    painter = Painter(PainterSettings(urdfs=(robot_model("locobot").physics_urdf,), hardware=False))
    try:
        album = Album(painter, bodies, 29, SITE)
        album.write(tmp_path / "scene.webp", scene_panels(made(), SHOTS)[1:3])
    finally:
        painter.close()
    picture = cv2.imread(str(tmp_path / "scene.webp"))
    assert picture is not None
    green, purple = picture[:324].astype(int), picture[324:].astype(int)
    assert ((green[..., 1] - green[..., [0, 2]].max(axis=2)) > 60).sum() > 20
    assert ((purple[..., [0, 2]].min(axis=2) - purple[..., 1]) > 40).sum() > 20


@pytest.mark.thorough
@pytest.mark.lockstep
def test_a_fetch_is_timed_and_drawn(tmp_path: Path) -> None:
    done = run_picking(PickingOptions(arm_fails=True), tmp_path, 0)
    assert done.right, done
    assert sum(done.phases.values()) == pytest.approx(done.lasted, abs=0.1)
    assert {path.name for path in tmp_path.iterdir()} == {
        "figure-2-search-0.svg",
        "figure-4-new-try-0.svg",
        "figure-10-scene-0.webp",
        "figure-11-workflow-0.webp",
    }
