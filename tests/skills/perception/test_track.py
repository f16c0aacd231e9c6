"""Track, over the bus in memory: tags of each picture while things move and arms hide them."""

import math
from collections.abc import Generator

import numpy as np
import pytest

from tandem.skills import site
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.geometry.poses import angle_between, compose, distance, invert
from tandem.skills.perception.track import GONE_AFTER, Track
from tandem.skills.ports.actions.perception import LookFeedback, TrackGoal, TrackResult
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.keys import Latest, rgbd
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.skill import Command, Outcome
from tandem.skills.ports.world import SIGHTINGS, WORLD, Box, ItemFact, Sightings, WorldState
from tandem.skills.wire.workers import InlineCompute
from tests.skills.perception.pictures import Face, header, picture
from tests.skills.perception.solids import scene
from tests.skills.perception.stage import DESCRIPTION, Painter, Stage
from tests.skills.world.facts import tag

TABLE = site.load("bimanual")
ROBOT = FloorPose(x=0.0, y=0.0, yaw=0.0)
HEAD = np.array([0.0, -0.5])
HERE, THERE = tag(0.75, 0.1), tag(0.75, -0.1)


def showing(*tags: Pose | None) -> Painter:
    """Paint item 29 with its tag at each of these poses, a picture each; the last stays."""
    rng, left = np.random.default_rng(1), list(tags)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        shown = left.pop(0) if len(left) > 1 else left[0]
        faces = () if shown is None else (Face(29, compose(invert(camera_in_map), shown), 0.056),)
        return picture(faces, rng, samples=3, seconds=now.seconds)

    return painter


def in_view(at: Pose) -> Painter:
    """Paint item 29 where it stands, wherever the camera looks."""
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        face = Face(29, compose(invert(camera_in_map), at), 0.056)
        return picture((face,), rng, samples=3, seconds=now.seconds)

    return painter


class Tracking:
    """One run, stepped by hand."""

    def __init__(self, painter: Painter, goal: TrackGoal | None = None) -> None:
        self.stage = Stage(painter, ROBOT, head=HEAD)
        self.heard = Latest(self.stage.bus, SIGHTINGS)
        self.outcome: Outcome[TrackResult] | None = None
        skill = Track(self.stage.bus, self.stage.clocks, DESCRIPTION, TABLE, InlineCompute(self.stage.clocks))
        self._run: Generator[object, Command, Outcome[TrackResult]] = skill.run(
            goal or TrackGoal(), "t/track/1"
        )
        self.stage.step()
        next(self._run)

    def believe(self, at: Pose) -> None:
        fact = ItemFact(
            item=29,
            size=(0.07, 0.07, 0.07),
            tag_in_map=at,
            seen=RobotTime(boot="b", seconds=0.5),
            quality=0.5,
            position_sigma=0.001,
        )
        WORLD.publish(self.stage.bus, WorldState(stamp=self.stage.now, version=1, items=(fact,)))

    def step(self, command: Command = Command.GO_ON) -> object:
        self.stage.step()
        try:
            return self._run.send(command)
        except StopIteration as stop:
            self.outcome = stop.value
            return None

    def messages(self, count: int) -> list[Sightings]:
        told: list[Sightings] = []
        for _ in range(100 * count):
            self.step()
            told += self.heard.take()
            if len(told) >= count:
                return told
        raise AssertionError(f"{len(told)} pictures were told")


def test_an_item_that_moves_is_told_where_it_is_in_each_picture() -> None:
    tracking = Tracking(showing(HERE, HERE, THERE))
    places = [each.sightings[0].tag_in_map for each in tracking.messages(3)]
    assert [
        distance(place, where) < 0.005 for place, where in zip(places, (HERE, HERE, THERE), strict=True)
    ] == [
        True,
        True,
        True,
    ]
    feedback = tracking.step()
    assert isinstance(feedback, LookFeedback)
    assert (feedback.pictures, feedback.seen) == (3, (29,))


def test_it_ends_by_a_cancel_and_the_camera_rests() -> None:
    tracking = Tracking(showing(HERE))
    tracking.messages(1)
    tracking.step(Command.CANCEL)
    assert tracking.outcome is not None
    assert tracking.outcome.canceled
    assert not tracking.stage.bus.listened(rgbd("head"))


def test_only_what_is_asked_for_is_told() -> None:
    (message,) = Tracking(showing(HERE), TrackGoal(items=(42,))).messages(1)
    assert message.sightings == ()


def test_an_item_the_site_does_not_know_is_refused() -> None:
    stage = Stage(showing(None), ROBOT)
    skill = Track(stage.bus, stage.clocks, DESCRIPTION, TABLE, InlineCompute(stage.clocks))
    refused = skill.check(TrackGoal(items=(29, 7)))
    assert refused is not None
    assert refused.kind is FailureKind.ITEM_UNKNOWN


def test_a_camera_that_falls_silent_is_told() -> None:
    tracking = Tracking(showing(HERE))
    tracking.messages(1)
    tracking.stage.camera_works = False
    for _ in range(400):
        tracking.step()
        if tracking.outcome is not None:
            break
    assert tracking.outcome is not None
    assert tracking.outcome.failure is not None
    assert tracking.outcome.failure.kind is FailureKind.CAMERA_SILENT


@pytest.mark.parametrize(("hidden", "absent"), [(True, ()), (False, (29,))])
def test_what_an_arm_hides_is_not_gone_and_what_left_is(*, hidden: bool, absent: tuple[int, ...]) -> None:
    table = box_in_map(TABLE.furniture[1].boxes[0])
    arm = Box(size=(0.1, 0.3, 0.2), pose=Pose(position=(0.45, 0.06, 0.91)))
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        return scene(header(now.seconds), camera_in_map, (table, arm) if hidden else (table,), rng)

    tracking = Tracking(painter)
    tracking.believe(HERE)
    assert [each.absent for each in tracking.messages(GONE_AFTER)] == [(), absent]


@pytest.mark.parametrize(("hidden", "absent"), [(True, ()), (False, (29,))])
def test_what_stands_where_the_tag_should_be_in_plain_view_is_not_the_item(
    *, hidden: bool, absent: tuple[int, ...]
) -> None:
    """A thing as near as the item was: nothing is seen through its place."""
    table = box_in_map(TABLE.furniture[1].boxes[0])
    plain = Box(size=(0.07, 0.2, 0.07), pose=Pose(position=(0.785, 0.1, 0.745)))
    arm = Box(size=(0.1, 0.3, 0.2), pose=Pose(position=(0.45, 0.06, 0.91)))
    rng = np.random.default_rng(1)

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        return scene(
            header(now.seconds), camera_in_map, (table, plain, arm) if hidden else (table, plain), rng
        )

    tracking = Tracking(painter)
    tracking.believe(HERE)
    assert [each.absent for each in tracking.messages(GONE_AFTER)] == [(), absent]


ASIDE = tag(0.75, -0.6)


def test_the_head_turns_to_an_item_that_is_out_of_the_picture_and_no_picture_is_read_meanwhile() -> None:
    tracking = Tracking(in_view(ASIDE), TrackGoal(gaze=(29,)))
    tracking.believe(ASIDE)
    first, second = tracking.messages(2)
    assert first.sightings == ()
    assert distance(second.sightings[0].tag_in_map, ASIDE) < 0.005
    assert second.stamp.seconds > first.stamp.seconds + 0.3


def test_without_a_gaze_the_head_stays_as_it_is() -> None:
    tracking = Tracking(in_view(ASIDE))
    tracking.believe(ASIDE)
    tracking.messages(3)
    assert tracking.stage.goals == []


def test_a_cancel_while_the_head_turns_ends_when_that_is_at_rest() -> None:
    tracking = Tracking(in_view(ASIDE), TrackGoal(gaze=(29,)))
    tracking.believe(ASIDE)
    while not tracking.stage.speed.any():
        tracking.step()
    tracking.step(Command.CANCEL)
    while tracking.outcome is None:
        tracking.step()
    assert tracking.outcome.canceled
    assert np.allclose(tracking.stage.speed, 0.0)


def test_an_item_that_shows_two_faces_does_not_seem_to_spin() -> None:
    rng, pictures = np.random.default_rng(1), [0]
    faces = (tag(0.75, 0.1, math.pi + 0.7), tag(0.75, -0.1, math.pi - 0.9))

    def painter(camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        pictures[0] += 1
        shown = faces[:1] if pictures[0] == 1 else faces
        painted = tuple(Face(29, compose(invert(camera_in_map), each), 0.056) for each in shown)
        return picture(painted, rng, samples=3, seconds=now.seconds)

    turns = [
        angle_between(each.sightings[0].tag_in_map.orientation, faces[0].orientation)
        for each in Tracking(painter).messages(4)
    ]
    assert max(turns) < math.radians(5.0)
