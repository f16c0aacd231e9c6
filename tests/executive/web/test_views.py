"""Views of the page in a real browser, beside a robot in memory that tells what a test wants."""

from __future__ import annotations

import base64
import datetime as dt
import json
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Literal

import pytest
from web_fake import FakeRobot, served, served_together

from tandem.executive.config.run_options import BusOptions
from tandem.executive.security.authority import Wanted, begin, issue
from tandem.executive.security.identity import Identity
from tandem.executive.security.links import make
from tandem.skills.ports.action import GoalState, GoalStatus, status_topic
from tandem.skills.ports.actions.arm import MoveFeedback, MovePhase, move
from tandem.skills.ports.actions.base import DRIVE, DriveFeedback
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import STOP, laser
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import Occupancy, pack
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.reflex import PipelineState, ReflexState, pipeline_state, reflex_state
from tandem.skills.ports.sensors import LaserScan
from tandem.skills.ports.tasks import (
    TASK_STATUS,
    TREE,
    Attempt,
    KindOfTask,
    TaskKinds,
    TaskState,
    TaskStatus,
    TreeNode,
    TreeSnapshot,
)
from tandem.skills.ports.whereabouts import RobotWhereabouts
from tandem.skills.ports.world import (
    PEOPLE,
    ROBOT_POSE,
    SCENE,
    SIGHTINGS,
    Box,
    People,
    PlanningScene,
    RobotPose,
    SceneObject,
    Sighting,
    Sightings,
    TrackedPerson,
)

pytest.importorskip("playwright.sync_api", reason="no playwright: pip install playwright")
from playwright.sync_api import Browser, Page, Route, expect
from web_chromium import MARKS, opened, picture

pytestmark = MARKS
HERE = FloorPose(x=0.3, y=0.2, yaw=0.4)
AHEAD = Pose(position=(0.0, 0.1, 1.0), orientation=(0.0, 0.0, 0.0, 1.0))
REFLEX = ReflexState(
    reflex="avoid_collision", on=True, resources=("base",), rank=2, holds=True, fired=3, about="Backs off."
)
GREY = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABsSFBcUERsXFhceHBsgKEIrKCUlKFE6PTBCYFVlZF9VXVtqeJmBanGQc1tdhbWGkJ6j"
    "q62rZ4C8ybqmx5moq6T/wAALCAAJABABAREA/8QAFAABAAAAAAAAAAAAAAAAAAAAAP/EABQQAQAAAAAAAAAAAAAAAAAAAAD/2gAI"
    "AQEAAD8AAP/Z"
)
"""16 pixels by 9."""


@pytest.fixture
def robot() -> FakeRobot:
    return FakeRobot(seconds=100.0, picture=GREY, reflexes={REFLEX.reflex: REFLEX})


@pytest.fixture
def page(browser: Browser, robot: FakeRobot) -> Iterator[Page]:
    with served(robot) as address, opened(browser, address) as made:
        yield made


def tell(robot: FakeRobot) -> None:
    """Tell where it is, what it sees, where it drives to, and who has the base."""
    now = robot.now
    tag = Sighting(
        item=29, stamp=now, tag_in_map=AHEAD, tag_in_base=AHEAD, tag_in_camera=AHEAD,
        distance=1.0, quality=0.9, position_sigma=0.01,
    )  # fmt: skip
    way = DriveFeedback(
        base_in_map=HERE, remaining=2.0, progress=0.2, way=((0.3, 0.2), (1.0, 0.1), (1.4, -0.8))
    )
    fed = way.model_dump(mode="json")
    robot.tell(
        (
            ROBOT_POSE,
            RobotPose(
                stamp=now, localised=True, base_in_map=HERE, odom_in_map=HERE,
                position_sigma=0.01, yaw_sigma=0.01, moving=True,
            ),
        ),
        (SIGHTINGS, Sightings(stamp=now, sightings=(tag,))),
        (
            status_topic(DRIVE.name),
            GoalStatus(goal_id="a/b/1", state=GoalState.RUNNING, sequence=1, feedback=fed),
        ),
        (reflex_state(REFLEX.reflex), robot.reflexes[REFLEX.reflex]),
        (pipeline_state("base"), PipelineState(
            stamp=now, resource="base", holder=DRIVE.name, doing=("GoTo",)
        )),
    )  # fmt: skip


def test_the_camera_is_shown_with_the_tags_that_were_found(page: Page, robot: FakeRobot) -> None:
    page.goto("/")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    tell(robot)
    page.get_by_role("button", name="Camera").click()
    expect(page).to_have_url("/?camera")
    expect(page.locator(".camera svg text")).to_have_text("tea")
    expect(page.locator(".camera figcaption")).to_contain_text("now · item tea seen now")
    page.get_by_role("button", name="Camera").click()
    expect(page.locator(".camera")).to_have_count(0)


def test_of_an_untagged_item_as_much_is_outlined_as_a_tag_would_take(page: Page, robot: FakeRobot) -> None:
    def site(route: Route) -> None:
        told = route.fetch().json()
        for item in told["items"]:
            item.update({"tag_size": None, "size": [0.24, 0.12, 0.12]} if item["item"] == 29 else {})
        route.fulfill(json=told)

    def width() -> float:
        expect(page.locator(".camera polygon")).to_have_count(1)
        points = (page.locator(".camera polygon").get_attribute("points") or "").split()
        across = [float(point.split(",")[0]) for point in points]
        return max(across) - min(across)

    page.goto("/?camera")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    tell(robot)
    tagged = width()  # 0.048 m
    page.route("**/api/site", site)
    page.reload()
    assert width() == pytest.approx(tagged * 0.8 * 0.12 / 0.048, rel=1e-3)


def test_of_several_cameras_one_is_chosen(page: Page, robot: FakeRobot) -> None:
    (head,) = robot.description.cameras
    wrist = head.model_copy(update={"name": "wrist"})
    robot.description = robot.description.model_copy(update={"cameras": (head, wrist)})
    page.goto("/?camera")
    page.get_by_label("Camera", exact=True).and_(page.locator("select")).select_option("wrist")
    expect(page).to_have_url("/?camera=wrist")
    expect(page.get_by_alt_text("What the camera wrist sees")).to_be_visible()
    assert robot.viewed[-1] == "wrist"
    expect(page.locator(".canvas")).to_have_attribute("data-robot", "loaded")
    tell(robot)
    expect(page.locator(".camera .guessed text")).to_have_text("tea")
    expect(page.locator(".camera figcaption")).to_contain_text(f"item tea seen by {head.name} now")
    picture(page, "page-cameras")


def test_the_points_of_all_lasers_are_drawn(page: Page, robot: FakeRobot) -> None:
    (front,) = robot.description.lasers
    rear = front.model_copy(update={"name": "rear"})
    robot.description = robot.description.model_copy(update={"lasers": (front, rear)})
    page.goto("/")
    expect(page.locator(".canvas")).to_have_attribute("data-robot", "loaded")
    near, far = front.range_min + 1.0, front.range_max
    robot.tell((laser(front.name), LaserScan(stamp=robot.now, ranges=(near, near, far))))
    expect(page.locator(".canvas")).to_have_attribute("data-beams", "2")
    robot.tell((laser(rear.name), LaserScan(stamp=robot.now, ranges=(near, near, near))))
    expect(page.locator(".canvas")).to_have_attribute("data-beams", "5")


COUNTED = """() => {
  const gl = WebGL2RenderingContext.prototype, frame = window.requestAnimationFrame.bind(window);
  let on = null, count = {canvas: 0, beside: 0};
  window.drawn = [];
  const before = (name, act) => {
    const was = gl[name];
    gl[name] = function (...given) { act(...given); return was.apply(this, given); };
  };
  const draws = () => { count[on ? "beside" : "canvas"] += 1; };
  before("bindFramebuffer", (target, found) => {
    if (target !== gl.READ_FRAMEBUFFER) on = found;
  });
  for (const name of ["drawElements", "drawArrays", "drawElementsInstanced"]) before(name, draws);
  window.requestAnimationFrame = draw => frame(time => {
    count = {canvas: 0, beside: 0};
    draw(time);
    if (count.canvas || count.beside) window.drawn.push(count);
  });
}"""
"""Has the page count what each of its frames draws on the canvas, and beside it."""


def test_the_page_never_waits_for_a_picture_of_the_robot(page: Page, robot: FakeRobot) -> None:
    # What is drawn on a canvas, and what was ordered before it, holds up all clicks until it is done.
    page.add_init_script(f"({COUNTED})()")
    page.goto("/")
    expect(page.locator(".canvas")).to_have_attribute("data-robot", "loaded")
    tell(robot)
    expect(page.locator(".canvas")).to_have_attribute("data-plan", "3")
    page.wait_for_function("() => document.querySelector('.canvas').dataset.frames > 2")
    drawn = page.evaluate("window.drawn")
    assert max(each["beside"] for each in drawn) > 1, "pictures are drawn beside the canvas"
    assert {each["canvas"] for each in drawn} == {0, 1}, "the canvas gets them whole"
    assert not [each for each in drawn if each["canvas"] and each["beside"]], "never with the next one begun"


def test_the_planned_way_is_drawn(page: Page, robot: FakeRobot) -> None:
    page.goto("/")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    tell(robot)
    expect(page.locator(".canvas")).to_have_attribute("data-plan", "3")


def test_the_planned_way_of_a_hand_is_drawn(page: Page, robot: FakeRobot) -> None:
    group = robot.description.end_effectors[0].group
    page.goto("/")
    expect(page.locator(".canvas")).to_have_attribute("data-robot", "loaded")
    way = tuple((0.4 + 0.02 * i, 0.4 - 0.05 * i, 0.6 + 0.08 * i - 0.006 * i * i) for i in range(10))
    fed = MoveFeedback(phase=MovePhase.MOVING, progress=0.1, way=way).model_dump(mode="json")
    moving = GoalStatus(goal_id="a/b/1", state=GoalState.RUNNING, sequence=1, feedback=fed)
    robot.tell((status_topic(move(group).name), moving))
    expect(page.locator(".canvas")).to_have_attribute("data-hands", "1")
    picture(page, "page-hand")
    ended = GoalStatus(goal_id="a/b/1", state=GoalState.CANCELED, sequence=2)
    robot.tell((status_topic(move(group).name), ended))
    expect(page.locator(".canvas")).to_have_attribute("data-hands", "0")


def test_occupied_space_is_drawn_and_can_be_hidden(page: Page, robot: FakeRobot) -> None:
    page.goto("/")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    expect(page.get_by_role("button", name="Occupied space")).to_have_count(0)
    stack = pack(x + 10 * (y + 10 * z) for z in range(10) for y in range(3, 7) for x in range(3, 7))
    cells = Occupancy(
        stamp=robot.now, version=1, origin=(0.3, -1.3, 0.0), shape=(10, 10, 10), resolution=0.05, cells=stack
    )
    robot.tell((SCENE, PlanningScene(stamp=robot.now, version=1, objects=(), occupied=cells)))
    expect(page.locator(".canvas")).to_have_attribute("data-occupied", "160")
    picture(page, "page-occupied")
    page.get_by_role("button", name="Occupied space", pressed=True).click()
    expect(page).to_have_url("/?unoccupied")
    expect(page.get_by_role("button", name="Occupied space", pressed=False)).to_be_visible()


def test_people_are_drawn_in_3d_and_on_the_map(page: Page, robot: FakeRobot) -> None:
    def person(number: int, x: float) -> TrackedPerson:
        return TrackedPerson(
            id=number, x=x, y=0.4, vx=0.6, vy=-0.3, position_sigma=0.1, radius=0.3, unseen=0.0
        )

    both = People(stamp=robot.now, people=(person(3, 0.8), person(4, 1.5)))
    page.goto("/")
    expect(page.locator(".canvas")).to_have_attribute("data-robot", "loaded")
    robot.tell((PEOPLE, both))
    expect(page.locator(".canvas")).to_have_attribute("data-people", "2")
    picture(page, "page-people")
    page.get_by_role("link", name="Map").click()
    expect(page.locator(".room .person title")).to_have_text(["a person, 0.7 m/s"] * 2)
    picture(page, "page-people-map")
    robot.tell((PEOPLE, both.model_copy(update={"people": (person(4, 1.5),)})))
    expect(page.get_by_label("person 4")).to_be_visible()
    expect(page.get_by_label("person 3")).to_have_count(0)


def test_a_reflex_is_switched_where_it_is_shown_who_has_what(page: Page, robot: FakeRobot) -> None:
    page.goto("/")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    tell(robot)
    page.locator(".resources summary").click()
    expect(page.locator(".resources tbody tr")).to_have_text("basebase/driveGoTo")
    picture(page, "page-resources")
    page.get_by_role("button", name="Switch avoid_collision off").click()
    expect(page.locator(".warn")).to_contain_text("avoid_collision is off, by anna")
    page.get_by_role("button", name="Switch avoid_collision on").click()
    expect(page.locator(".warn")).to_have_count(0)


def test_a_reflex_that_protects_somebody_is_switched_off_only_after_a_question(
    page: Page, robot: FakeRobot
) -> None:
    robot.reflexes[REFLEX.reflex] = REFLEX.model_copy(update={"protects": "people from a blind base"})
    page.goto("/")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    tell(robot)
    page.locator(".resources summary").click()
    off = page.get_by_role("button", name="Switch avoid_collision off")
    off.click()
    question = page.get_by_role("alertdialog")
    expect(question).to_contain_text("It protects people from a blind base.")
    picture(page, "page-reflex-question")
    expect(page.get_by_role("button", name="Leave it on")).to_be_focused()
    page.keyboard.press("Enter")
    expect(question).to_have_count(0)
    expect(off).to_be_focused()
    assert robot.reflexes[REFLEX.reflex].on
    off.click()
    page.get_by_role("button", name="Switch off all the same").click()
    expect(page.locator(".warn")).to_contain_text("avoid_collision is off, by anna. It protects people")
    page.get_by_role("button", name="Switch avoid_collision on").click()
    expect(page.locator(".warn")).to_have_count(0)


def test_a_reflex_that_is_off_by_declaration_is_named_once_it_is_on(page: Page, robot: FakeRobot) -> None:
    off = REFLEX.model_copy(update={"on": False, "declared": False})
    page.goto("/")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    robot.reflexes[REFLEX.reflex] = off
    tell(robot)
    expect(page.locator(".resources .chip")).to_have_text("off")
    expect(page.locator(".warn")).to_have_count(0)
    robot.reflexes[REFLEX.reflex] = off.model_copy(update={"on": True, "by": "anna"})
    tell(robot)
    expect(page.locator(".warn")).to_contain_text("avoid_collision is on, by anna")


KIND = KindOfTask(
    name="fetch",
    summary="Fetch an item.",
    request={
        "type": "object",
        "properties": {
            "task": {"const": "fetch"},
            "item": {"type": "integer", "description": "which"},
            "ways": {"type": "array", "items": {}, "examples": [[{"x": 1.5}]]},
            "hand": {"type": "string", "examples": ["left"]},
            "source": {"$ref": "#/$defs/Source", "default": "sensor"},
        },
        "$defs": {"Source": {"type": "string", "enum": ["sensor", "belief"]}},
        "required": ["task", "item"],
    },
)


def test_a_form_is_kept_as_a_favourite_and_taken_along(page: Page, robot: FakeRobot, tmp_path: Path) -> None:
    robot.kinds = TaskKinds(kinds=(KIND,))
    page.goto("/request?task=fetch&item=29")
    page.get_by_label("Name of the favourite").fill("the red one")
    page.get_by_role("button", name="Keep as favourite").click()
    page.goto("/request?task=fetch")
    expect(page.get_by_label("item")).to_have_value("")
    expect(page.get_by_label("ways")).to_have_attribute("placeholder", '[{"x":1.5}]')
    expect(page.get_by_label("hand")).to_have_attribute("placeholder", "left")
    expect(page.get_by_label("source").locator("option")).to_have_text(
        ["sensor (default)", "sensor", "belief"]
    )
    page.get_by_role("link", name="the red one").click()
    expect(page.get_by_label("item")).to_have_value("29")
    picture(page, "page-request")
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save as JSON").click()
    file = tmp_path / "favourites.json"
    saved.value.save_as(file)
    assert json.loads(file.read_text("utf-8")) == [
        {"name": "the red one", "task": "fetch", "values": {"item": "29"}}
    ]
    page.get_by_role("button", name="Forget the red one").click()
    expect(page.get_by_role("link", name="the red one")).to_have_count(0)
    page.locator("input[type=file]").set_input_files(file)
    expect(page.get_by_role("link", name="the red one")).to_be_visible()


def test_what_is_no_favourite_is_left_out(page: Page, robot: FakeRobot) -> None:
    robot.kinds = TaskKinds(kinds=(KIND,))
    page.goto("/request")
    stored = json.dumps([{"name": 1}, 7, {"name": "good", "task": "fetch", "values": {}}])
    page.evaluate("text => localStorage.setItem('tandem.favourites', text)", stored)
    page.goto("/request")
    expect(page.locator(".favourites li")).to_have_count(1)


def test_an_executive_that_was_killed_is_waited_for(page: Page, robot: FakeRobot) -> None:
    page.goto("/request")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    robot.executive(there=False)
    expect(page.locator(".link")).to_contain_text("the executive is gone; waiting for it")
    robot.kinds = TaskKinds(kinds=(KIND,))
    robot.executive(there=True)
    expect(page.locator(".link")).to_contain_text("nothing heard")
    expect(page.get_by_role("link", name="fetch")).to_be_visible()


def test_beyond_the_host_one_logs_in_by_a_link(browser: Browser, robot: FakeRobot, tmp_path: Path) -> None:
    now = dt.datetime.now(dt.UTC)
    begin(tmp_path, now)
    issue(tmp_path, Wanted("robot", "r1"), now)
    issue(tmp_path, Wanted("viewer", "vera"), now)
    with served(robot, tmp_path) as address, opened(browser, address) as page:
        page.goto("/history")
        expect(page.get_by_role("heading", name="Log in")).to_be_visible()
        picture(page, "page-login")
        page.get_by_label("Word").fill("guess")
        page.get_by_role("button", name="Log in").click()
        expect(page.get_by_role("alert")).to_contain_text("tandem keys link")
        word = make(Identity(tmp_path, "vera"), address, dt.datetime.now(dt.UTC).timestamp())
        page.goto("about:blank")
        page.goto(f"/login#{word}")
        expect(page.locator(".role")).to_have_text("viewer")
        expect(page).to_have_url(f"{address}/")
        assert page.get_by_role("button", name="STOP").count() == 0
        page.get_by_role("button", name="Log out").click()
        expect(page.get_by_role("heading", name="Log in")).to_be_visible()


def test_items_are_called_by_their_names_and_tins_are_round(page: Page, robot: FakeRobot) -> None:
    def thing(item: int, shape: Literal["box", "cylinder"]) -> SceneObject:
        place = Pose(position=(0.5, item / 20, 0.8), orientation=(0.0, 0.0, 0.0, 1.0))
        box = Box(size=(0.06, 0.06, 0.1), pose=place, shape=shape)
        return SceneObject(name=f"item {item}", kind="item", box=box, item=item)

    scene = PlanningScene(stamp=robot.now, version=1, objects=(thing(29, "cylinder"), thing(7, "box")))
    page.goto("/map")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    robot.tell((SCENE, scene))
    tea = page.get_by_label("item 29 (tea)")
    expect(tea.locator("text")).to_have_text("tea")
    expect(tea.locator("rect")).to_have_attribute("rx", "0.03")
    expect(page.get_by_label("item 7").locator("text")).to_have_text("7")
    page.get_by_role("link", name="Now").click()
    expect(page.locator(".label.item")).to_have_text(["tea", "7"])
    canvas = page.locator(".canvas")
    expect(canvas).to_have_attribute("data-robot", "loaded")
    shapes = list[int]()
    for version in range(2, 7):
        things = (thing(29, "cylinder"), thing(7 + version, "box"))
        robot.tell((SCENE, PlanningScene(stamp=robot.now, version=version, objects=things)))
        expect(page.locator(".label.item")).to_have_text(["tea", str(7 + version)])
        expect(canvas).to_have_attribute("data-latest", "true")  # names come before what they stand at
        shapes.append(int(canvas.get_attribute("data-shapes") or 0))
    # What is drawn anew leaves nothing behind. News above the canvas may bring more of the room into view.
    assert any(one == later for one, later in pairwise(shapes)), shapes


def test_names_of_things_that_stand_close_do_not_lie_on_each_other(page: Page, robot: FakeRobot) -> None:
    def thing(item: int) -> SceneObject:
        place = Pose(position=(0.8 + item / 25, 0.1, 0.8), orientation=(0.0, 0.0, 0.0, 1.0))
        return SceneObject(name=f"item {item}", kind="item", box=Box(size=(0.03,) * 3, pose=place), item=item)

    things = tuple(thing(item) for item in range(1, 9))
    page.goto("/")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    robot.tell((SCENE, PlanningScene(stamp=robot.now, version=1, objects=things)))
    names = page.locator(".label.item")
    expect(names).to_have_count(len(things))
    expect(names.first).to_be_visible()
    drawn = """labels => labels.map(each => each.getBoundingClientRect()).flatMap((one, i, all) => all
        .slice(i + 1).map(other => Math.min(one.right, other.right) - Math.max(one.left, other.left) > 0
            && Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 0))"""
    picture(page, "page-names")
    assert not any(names.evaluate_all(drawn))


def test_what_is_typed_stays_while_the_robot_goes_on(page: Page, robot: FakeRobot) -> None:
    waiting = TaskStatus(task="go-1", kind="go", request={}, state=TaskState.QUEUED, accepted_at=0.0)
    robot.tasks, robot.refuses = (waiting,), "it begins now"
    page.goto("/task/go-1")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    priority = page.get_by_label("priority")
    priority.fill("5")
    robot.tell((TASK_STATUS, waiting.model_copy(update={"waits_for": "its turn"})))
    expect(page.locator(".figures")).to_contain_text("its turn")
    with page.expect_request("**/api/verb/reprioritise") as sent:
        priority.press("Enter")
    assert sent.value.post_data_json["priority"] == 5
    expect(page.get_by_role("alert")).to_contain_text("it begins now")
    expect(priority).to_have_value("0")


@pytest.mark.parametrize("state", [*TaskState, "BAD"])
def test_a_filter_of_the_address_is_shown(page: Page, state: str) -> None:
    page.goto(f"/history?state={state}")
    expect(page.get_by_label("state")).to_have_value(state)


def test_a_failure_that_came_again_and_again_is_said_once(page: Page, robot: FakeRobot) -> None:
    def at(seconds: float) -> RobotTime:
        return RobotTime(boot="a", seconds=seconds)

    def off(by: float) -> Failure:
        kind = FailureKind.BASE_OFF_GOAL
        return Failure(kind=kind, message=f"off by {by} m", where="drive", evidence={"off_m": by})

    empty = Failure(kind=FailureKind.GRASP_EMPTY, message="closed on nothing")
    tried = [
        Attempt(at=at(2.0 + by), failure=each, recovery="again")
        for by, each in enumerate((off(0.1), empty, off(0.3)))
    ]
    failure = Failure(kind=FailureKind.BASE_NO_PATH, message="no way", causes=(off(0.1), off(0.3)))
    robot.tasks = (
        TaskStatus(
            task="go-1", kind="go", request={"task": "go"}, state=TaskState.FAILED, accepted_at=0.0,
            started=at(1.0), ended=at(9.0), tried=tuple(tried), failure=failure,
        ),
    )  # fmt: skip
    page.goto("/task/go-1")
    expect(page.locator(".tried li")).to_have_count(2)
    expect(page.locator(".tried li").first).to_contain_text(
        "off by 0.1 m→ again, 2 times: the first after 1.0 s, the last after 3.0 s"
    )
    chain = page.locator(".chain .chain")
    expect(chain).to_have_count(1)
    expect(chain).to_contain_text("2 times: the first after 1.0 s, the last after 3.0 soff_m 0.1 to 0.3")


def test_a_breakpoint_is_set_with_the_keyboard_alone(page: Page, robot: FakeRobot) -> None:
    robot.tasks = (
        TaskStatus(task="go-1", kind="go", request={"task": "go"}, state=TaskState.RUNNING, accepted_at=0.0),
    )
    leaf = TreeNode(path="go/drive", name="drive", kind="action", type="Act", status="RUNNING")
    root = TreeNode(path="go", name="go", kind="sequence", type="Seq", status="RUNNING", children=(leaf,))
    robot.tree = TreeSnapshot(task="go-1", kind="go", tick=1, root=root)
    page.goto("/")
    page.get_by_role("treeitem").first.focus()
    page.keyboard.press("Tab")
    expect(page.get_by_role("button", name="Pause before")).to_be_focused()
    with page.expect_request("**/api/verb/breakpoint"):
        page.keyboard.press("Enter")


def test_breakpoints_are_shown_wherever_they_were_set_and_are_taken_away_there(
    page: Page, robot: FakeRobot
) -> None:
    leaf = TreeNode(path="go/drive/roll", name="roll", kind="action", type="Act")
    ready = TreeNode(path="go/drive/ready", name="ready", kind="condition", type="Check")
    drive = TreeNode(path="go/drive", name="drive", kind="sequence", type="Seq", children=(ready, leaf))
    root = TreeNode(path="go", name="go", kind="sequence", type="Seq", status="RUNNING", children=(drive,))
    robot.tasks = (
        TaskStatus(task="go-1", kind="go", request={"task": "go"}, state=TaskState.RUNNING, accepted_at=0.0),
    )
    robot.tree = TreeSnapshot(task="go-1", kind="go", tick=1, root=root)
    page.goto("/")
    expect(page.get_by_role("treeitem").last).to_contain_text("roll")
    expect(page.locator(".breakpoints")).to_have_count(0)
    set_ = {"go/drive/ready": ("after",), "go/drive/roll": ("before",)}
    robot.tell((TREE, robot.tree.model_copy(update={"breakpoints": set_})))
    rows = page.get_by_role("treeitem")
    expect(rows.last.locator(".gate")).to_have_text("‖▸pauses before")
    expect(rows.first.locator(".gate")).to_have_text("▸‖…pauses after drive/ready")  # it is not drawn
    expect(page.locator(".breakpoints li")).to_have_text(["Pauses after ready✕", "Pauses before roll✕"])
    rows.last.focus()
    expect(page.get_by_role("button", name="Pause before", pressed=True)).to_be_visible()
    picture(page, "page-breakpoints")
    with page.expect_request("**/api/verb/breakpoint") as sent:
        page.get_by_role("button", name="Don't pause after go/drive/ready").click()
    assert sent.value.post_data_json == {
        "task": "go-1", "node": "go/drive/ready", "when": "after", "on": False,
    }  # fmt: skip
    robot.tell((TREE, robot.tree))
    expect(page.locator(".breakpoints, .gate")).to_have_count(0)


def test_an_address_that_is_cut_in_a_character_is_answered(page: Page) -> None:
    page.goto("/task/%E0%A4%A")
    expect(page.get_by_role("link", name="History")).to_have_count(2)


def test_the_other_robots_of_the_site_are_on_the_map(page: Page, robot: FakeRobot) -> None:
    def session(route: Route) -> None:
        route.fulfill(json={**route.fetch().json(), "pages": {"r2": "https://r2.example/"}})

    page.route("**/api/session", session)
    page.goto("/map")
    expect(page.locator(".link")).to_contain_text("nothing heard")
    told = RobotWhereabouts(
        name="r2", start="s", sequence=1, base_in_map=HERE, kind="patrol", phase="corner 2",
        radius=0.38, height=0.39,
    )  # fmt: skip
    robot.tell_site("r2", told)
    expect(page.get_by_label("robot r2")).to_contain_text("r2")
    expect(page.get_by_label("robot r2").locator("circle")).to_have_attribute("r", "0.38")
    expect(page.locator(".others li")).to_have_text("r2 patrol: corner 2 · at 0.30, 0.20")
    expect(page.get_by_role("link", name="r2")).to_have_attribute("href", "https://r2.example/")
    page.get_by_role("link", name="Now").click()
    expect(page.locator(".view3d .label", has_text="r2")).to_be_visible()
    picture(page, "page-robots")
    page.evaluate("""() => {
        window.least = 1
        const shown = () => [...document.querySelectorAll(".view3d .label")]
        const names = () => shown().filter(each => each.textContent.startsWith("r2")).length
        const count = () => window.least = Math.min(window.least, names())
        new MutationObserver(count).observe(document.querySelector(".labels"), {childList: true})
    }""")
    robot.tell_site("r2", told.model_copy(update={"sequence": 2, "phase": "corner 3"}))
    expect(page.locator(".others li")).to_contain_text("corner 3")
    assert page.evaluate("window.least") == 1, "names that are drawn anew don't flicker"
    there = FloorPose(x=1.0, y=-0.5, yaw=0.0)
    robot.tell_site("r2", told.model_copy(update={"sequence": 3, "base_in_map": there}))
    page.get_by_role("link", name="Map").click()
    expect(page.locator(".room .other-path")).to_have_attribute("points", "0.3,-0.2 1,0.5")


def test_each_of_several_robots_has_a_page_and_a_link_to_the_others(browser: Browser) -> None:
    one, two = (FakeRobot(options=replace(BusOptions(), robot=name), seconds=100.0) for name in ("r1", "r2"))
    with served_together(one, two) as (first, second), opened(browser, first, beside=second) as page:
        page.goto("/map")
        expect(page.locator(".others li")).to_have_text("r2 · nothing heard")
        picture(page, "page-several")
        page.get_by_role("link", name="r2").click()
        expect(page).to_have_url(f"{second}/")
        expect(page.locator(".others li strong")).to_have_text("r1")
        expect(page.locator(".link")).to_contain_text("nothing heard")
        page.get_by_role("button", name="STOP").click()
        expect(page.locator(".stopped")).to_be_visible()
    assert [key for key, _ in one.asked] == []
    assert [key for key, _ in two.asked] == [STOP.key]
