"""Look, over the bus in memory, with a head that moves and a camera that paints what is there."""

import math
from collections.abc import Callable

import numpy as np
import pytest

from tandem.skills import site
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import angle_between, compose, distance, invert
from tandem.skills.perception.camera import Camera
from tandem.skills.perception.look import Look
from tandem.skills.perception.session import Session
from tandem.skills.ports.actions.perception import LookGoal, LookResult
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.keys import STOP_STATE, Latest, rgbd
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.skill import Command, Outcome
from tandem.skills.ports.world import CLUTTER, SIGHTINGS, WORLD, Box, ItemFact, WorldState
from tandem.skills.wire.workers import InlineCompute
from tests.skills.perception.pictures import Face, header, picture
from tests.skills.perception.solids import scene
from tests.skills.perception.stage import DESCRIPTION, Stage
from tests.skills.world.facts import tag

LAB = site.load("lab")
ROBOT = FloorPose(x=-0.55, y=0.5, yaw=0.1)
TAG = tag(0.55, 0.55, math.pi - 0.3)


def paint(tag_in_map: Pose | None) -> Callable[[Pose, RobotTime], RgbdImage]:
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        faces: tuple[Face, ...] = ()
        if tag_in_map is not None:
            in_camera = compose(invert(camera_in_map), tag_in_map)
            x, y, z = in_camera.position
            if abs(x) < 0.45 * z and abs(y) < 0.25 * z:
                faces = (Face(29, in_camera, 0.048),)
        return picture(faces, rng, samples=4, seconds=now.seconds)

    return painter


def drive(
    stage: Stage,
    goal: LookGoal,
    command_at: dict[int, Command] | None = None,
    world: tuple[ItemFact, ...] = (),
    limit: int = 1500,
) -> Outcome[LookResult]:
    look = Look(stage.bus, stage.clocks, DESCRIPTION, LAB, InlineCompute(stage.clocks))
    WORLD.publish(stage.bus, WorldState(stamp=stage.now, version=1, items=world))
    assert look.check(goal) is None
    run = look.run(goal, "t/look/1")
    stage.step()
    next(run)
    for step in range(limit):
        stage.step()
        try:
            run.send((command_at or {}).get(step, Command.GO_ON))
        except StopIteration as stop:
            assert not stage.bus.listened(rgbd("head")), "rendering goes on though nobody looks"
            outcome: Outcome[LookResult] = stop.value
            return outcome
    raise AssertionError("the look did not end")


def test_the_tag_is_told_in_the_map_from_a_moved_head() -> None:
    stage = Stage(paint(TAG), ROBOT)
    heard = Latest(stage.bus, SIGHTINGS)
    outcome = drive(stage, LookGoal(item=29, tilts=(-0.45,)))
    assert outcome.result is not None
    (seen,) = outcome.result.sightings
    assert outcome.result.found
    assert distance(seen.tag_in_map, TAG) < 0.003
    assert angle_between(seen.tag_in_map.orientation, TAG.orientation) < math.radians(2)
    assert stage.head == pytest.approx((0.0, -0.45), abs=1e-3)
    assert [message.sightings for message in heard.take()] == [(seen,)]


def test_pictures_are_taken_only_with_the_head_at_rest() -> None:
    stage = Stage(paint(TAG), ROBOT)
    drive(stage, LookGoal(tilts=(-0.2, -0.45), pictures=2))
    for goal, begun in zip(stage.goals, (0, 2), strict=True):
        assert goal.points[-1].time > 0.3
        assert begun < len(stage.painted)
    assert stage.speed == pytest.approx((0.0, 0.0))
    assert len(stage.painted) >= 4


def test_nobody_listens_to_the_camera_before_a_picture_would_count() -> None:
    stage = Stage(paint(TAG), ROBOT)
    session = Session(stage.clocks, Latest(stage.bus, STOP_STATE))
    run = Camera(stage.bus, "head").picture(session, stage.now.plus(0.05))
    next(run)
    assert not stage.bus.listened(rgbd("head"))
    for _ in range(6):
        stage.step()
        run.send(Command.GO_ON)
    assert stage.bus.listened(rgbd("head"))


def test_it_ends_early_once_the_item_is_seen() -> None:
    stage = Stage(paint(TAG), ROBOT)
    outcome = drive(stage, LookGoal(item=29, tilts=(-0.45, -0.9, 0.2)))
    assert outcome.result is not None
    assert outcome.result.found
    assert len(stage.goals) == 1


def test_all_tilts_are_tried_and_not_finding_is_a_success() -> None:
    stage = Stage(paint(None), ROBOT)
    outcome = drive(stage, LookGoal(item=29, tilts=(-0.2, -0.6)))
    assert outcome.result is not None
    assert not outcome.result.found
    assert len(stage.goals) == 2


def test_looking_at_a_point_brings_it_to_the_middle() -> None:
    stage = Stage(paint(TAG), ROBOT)
    outcome = drive(stage, LookGoal(item=29, at=TAG.position, pictures=2))
    assert outcome.result is not None
    (seen,) = outcome.result.sightings
    x, y, z = seen.tag_in_camera.position
    assert abs(x / z) < 0.01
    assert abs(y / z) < 0.01


def test_a_head_that_is_held_up_is_told() -> None:
    outcome = drive(Stage(paint(TAG), ROBOT, held_up_at=-0.2), LookGoal(tilts=(0.1, -0.5)))
    assert outcome.result is not None
    assert outcome.result.head_short == pytest.approx(0.3, abs=0.01)


def test_clutter_is_measured_beside_a_known_item() -> None:
    table = box_in_map(LAB.furniture[1].boxes[0])
    can = Box(size=(0.08, 0.08, 0.15), pose=Pose(position=(0.7, 0.4, 0.785)))
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        return scene(header(now.seconds), camera_in_map, (table, can), rng)

    stage = Stage(painter, ROBOT)
    heard = Latest(stage.bus, CLUTTER)
    outcome = drive(stage, LookGoal(tilts=(-0.5,), clutter=True))
    assert outcome.result is not None
    assert outcome.result.clutter == 1
    (message,) = heard.take()
    assert message.boxes[0].pose.position == pytest.approx(can.pose.position, abs=0.03)


@pytest.mark.parametrize(("around", "there"), [(1.15, 1), (0.0, 0)])
def test_a_look_around_measures_what_stands_beside_the_picture(around: float, there: int) -> None:
    """The item is at one end of the table, a can at the other: an arm once swept the like aside."""
    table = box_in_map(LAB.furniture[1].boxes[0])
    can = Box(size=(0.08, 0.08, 0.15), pose=Pose(position=(0.5, 0.9, 0.785)))
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        return scene(header(now.seconds), camera_in_map, (table, can), rng)

    stage = Stage(painter, FloorPose(x=0.0, y=0.3, yaw=-0.4))
    heard = Latest(stage.bus, CLUTTER)
    outcome = drive(stage, LookGoal(at=(0.5, 0.05, 0.74), clutter=True, around=around), limit=6000)
    assert outcome.result is not None
    assert outcome.result.clutter == there
    last = heard.take()[-1]
    assert len(last.boxes) == there
    for box in last.boxes:
        assert box.pose.position == pytest.approx(can.pose.position, abs=0.03)


def test_an_item_that_is_gone_is_told_as_absent_and_a_hidden_one_is_not() -> None:
    table = box_in_map(LAB.furniture[1].boxes[0])
    can = Box(size=(0.1, 0.2, 0.2), pose=Pose(position=(0.6, 0.3, 0.81)))
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        return scene(header(now.seconds), camera_in_map, (table, can), rng)

    stage = Stage(painter, ROBOT)
    heard = Latest(stage.bus, SIGHTINGS)
    facts = tuple(
        ItemFact(
            item=item,
            size=(0.06, 0.06, 0.06),
            tag_in_map=at,
            seen=RobotTime(boot="b", seconds=0.5),
            quality=0.5,
            position_sigma=0.01,
        )
        for item, at in ((29, TAG), (42, tag(0.70, 0.25)))
    )
    outcome = drive(stage, LookGoal(tilts=(-0.5,), pictures=2), world=facts)
    assert [message.absent for message in heard.take()] == [(29,)]
    assert outcome.result is not None
    assert outcome.result.hidden == (42,)


def test_a_camera_that_is_silent_is_told() -> None:
    outcome = drive(Stage(paint(TAG), ROBOT, camera_works=False), LookGoal())
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.CAMERA_SILENT


def covered(image: RgbdImage) -> RgbdImage:
    return RgbdImage(image.header, np.zeros_like(image.colour), np.zeros_like(image.depth))


def test_a_dark_camera_is_told_within_its_time() -> None:
    stage = Stage(lambda pose, now: covered(paint(TAG)(pose, now)), ROBOT)
    outcome = drive(stage, LookGoal())
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.CAMERA_BLIND
    assert 1.5 <= float(outcome.failure.evidence["waited_s"]) < 1.8


def test_a_moment_in_the_dark_is_waited_out() -> None:
    painter = paint(TAG)

    def dimmed(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        image = painter(camera_in_map, now)
        return covered(image) if len(stage.painted) < 8 else image

    stage = Stage(dimmed, ROBOT)
    outcome = drive(stage, LookGoal(item=29))
    assert outcome.result is not None
    assert outcome.result.found


def frozen(painter: Callable[[Pose, RobotTime], RgbdImage]) -> Callable[[Pose, RobotTime], RgbdImage]:
    kept: list[RgbdImage] = []

    def same(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        kept[:] = kept or [painter(camera_in_map, now)]
        return RgbdImage(header(now.seconds), kept[0].colour, kept[0].depth)

    return same


def test_a_picture_that_stands_still_while_the_head_moves_is_told() -> None:
    outcome = drive(Stage(frozen(paint(None)), ROBOT), LookGoal(tilts=(-0.2, -0.6)))
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.CAMERA_BLIND
    assert "stands still" in outcome.failure.message


def test_the_same_picture_of_the_same_view_is_no_fault() -> None:
    outcome = drive(Stage(frozen(paint(TAG)), ROBOT), LookGoal(tilts=(-0.45,), pictures=3))
    assert outcome.result is not None


def test_a_robot_that_does_not_know_where_it_is_does_not_look() -> None:
    stage = Stage(paint(TAG), ROBOT, localised=False)
    outcome = drive(stage, LookGoal())
    assert outcome.failure is not None
    assert outcome.failure.kind is FailureKind.NOT_LOCALISED
    assert stage.goals == []


def test_a_stop_of_the_hardware_ends_it() -> None:
    stage = Stage(paint(TAG), ROBOT)
    look = Look(stage.bus, stage.clocks, DESCRIPTION, LAB, InlineCompute(stage.clocks))
    stage.stop()
    run = look.run(LookGoal(), "t/look/1")
    next(run)
    with pytest.raises(StopIteration) as ended:
        run.send(Command.GO_ON)
    assert ended.value.value.failure.kind is FailureKind.HARDWARE_STOPPED


def test_a_refused_head_goal_is_told() -> None:
    outcome = drive(Stage(paint(TAG), ROBOT, refuse="no such group"), LookGoal())
    assert outcome.failure is not None
    assert "no such group" in outcome.failure.message


@pytest.mark.parametrize("step", [2, 20, 70, 90])
def test_a_cancel_at_any_moment_ends_with_the_head_at_rest(step: int) -> None:
    stage = Stage(paint(TAG), ROBOT)
    outcome = drive(stage, LookGoal(tilts=(-0.8,), pictures=5), {step: Command.CANCEL})
    assert outcome.canceled
    stage.step()
    assert stage.speed == pytest.approx((0.0, 0.0))


@pytest.mark.parametrize("step", [20, 80])
def test_a_pause_halts_the_head_and_a_resume_goes_on(step: int) -> None:
    stage = Stage(paint(TAG), ROBOT)
    started = stage.clocks.seconds
    outcome = drive(stage, LookGoal(item=29), {step: Command.PAUSE, step + 600: Command.RESUME})
    assert stage.clocks.seconds - started > 6.0
    assert outcome.result is not None
    assert outcome.result.found


def test_goals_that_can_not_be_are_refused_at_once() -> None:
    stage = Stage(paint(None), ROBOT)
    look = Look(stage.bus, stage.clocks, DESCRIPTION, LAB, InlineCompute(stage.clocks))
    unknown, nowhere = look.check(LookGoal(item=500)), look.check(LookGoal(tilts=()))
    assert unknown is not None
    assert unknown.kind is FailureKind.ITEM_UNKNOWN
    assert nowhere is not None
    assert nowhere.kind is FailureKind.INVALID_GOAL


def test_the_head_is_on_its_way_to_the_next_view_before_the_last_one_is_told() -> None:
    stage, heads = Stage(paint(TAG), ROBOT), list[int]()
    heard, step = Latest(stage.bus, SIGHTINGS), stage.step

    def listen() -> None:
        step()
        heads.extend(len(stage.goals) for _ in heard.take())

    stage.step = listen  # type: ignore[method-assign]
    drive(stage, LookGoal(at=(0.5, 0.05, 0.74), around=1.15), limit=6000)
    assert heads[0] == 2
