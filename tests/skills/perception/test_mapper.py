"""The node that keeps the map, over the bus in memory, with a camera that paints what is there."""

from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from tandem.skills import site
from tandem.skills.geometry.floor_plan import box_in_map
from tandem.skills.perception.jobs import Shot
from tandem.skills.perception.look import Look
from tandem.skills.perception.mapper import NOT_PLACED, Mapper
from tandem.skills.perception.process import nodes
from tandem.skills.ports.actions.perception import LookGoal
from tandem.skills.ports.image import RgbdImage, encode
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.lattice import centres_of
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.occupancy import EditMap, MapEdit, MapEdited, Occupancy, OccupancySetting
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.skill import Command
from tandem.skills.ports.world import OCCUPANCY, OCCUPANCY_EDIT, PEOPLE, Box, People, TrackedPerson
from tandem.skills.wire.memory import MemoryBus
from tandem.skills.wire.workers import InlineCompute
from tests.skills.perception.pictures import header
from tests.skills.perception.solids import scene
from tests.skills.perception.stage import DESCRIPTION, URDF, Chain, Stage

LAB = site.load("lab")
ROBOT = FloorPose(x=-0.55, y=0.5, yaw=0.1)
SEEN = tuple(box_in_map(box) for each in LAB.furniture[:2] for box in each.boxes)
STRANGE = Box(size=(0.2, 0.2, 0.2), pose=Pose(position=(0.9, 0.6, 0.81)))


class Room:
    """What stands there, besides walls and a table, and how its pictures go wrong."""

    def __init__(self, *boxes: Box) -> None:
        self.boxes, self.dark, self.frozen = boxes, False, False
        self._painted: dict[tuple[object, ...], RgbdImage] = {}

    def paint(self, camera_in_map: Pose, now: RobotTime) -> RgbdImage:
        how = next(iter(self._painted)) if self.frozen else (camera_in_map, self.boxes)
        if how not in self._painted:  # casting its rays takes half a second
            rng = np.random.default_rng(1)
            self._painted[how] = scene(header(), camera_in_map, (*SEEN, *self.boxes), rng)
        image = self._painted[how]
        depth = np.zeros_like(image.depth) if self.dark else image.depth
        return RgbdImage(header(now.seconds), image.colour, depth)


def mapped(
    room: Room, rate: float = 1.0, saved: Path | None = None
) -> tuple[Stage, Mapper, Latest[Occupancy]]:
    stage = Stage(room.paint, base_in_map=ROBOT)
    stage.head = np.array([0.0, -0.3])
    heard = Latest(stage.bus, OCCUPANCY)
    setting = OccupancySetting(rate=rate)
    mapper = Mapper(stage.bus, stage.clocks, DESCRIPTION, LAB, setting, InlineCompute(stage.clocks), saved)
    return stage, mapper, heard


def go_on(stage: Stage, mapper: Mapper, seconds: float) -> None:
    for _ in range(round(seconds * 100)):
        stage.step()
        mapper.step()


def test_what_stands_there_is_told_once_and_again_only_on_change() -> None:
    stage, mapper, heard = mapped(room := Room(STRANGE))
    go_on(stage, mapper, 1.0)
    told = heard.take()
    assert [len(each.numbers()) > 0 for each in told] == [False, True]  # at the start, and after a picture
    centres = centres_of(told[-1])
    assert np.abs(centres - np.array(STRANGE.pose.position)).max() < 0.3
    room.boxes = ()
    go_on(stage, mapper, 1.2)
    assert [len(each.numbers()) for each in heard.take()] == [0]
    go_on(stage, mapper, 2.0)
    assert heard.take() == []


@pytest.mark.parametrize(("age", "kept"), [(0.0, False), (3.0, True)])
def test_who_is_tracked_is_not_kept_in_the_map(age: float, *, kept: bool) -> None:
    """Of somebody whom the base told of long ago it is not known where they are."""
    stage, mapper, heard = mapped(Room(STRANGE))
    x, y, _ = STRANGE.pose.position
    walker = TrackedPerson(id=1, x=x, y=y, vx=0.5, vy=0.0, position_sigma=0.05, radius=0.1, unseen=0.0)
    PEOPLE.publish(stage.bus, People(stamp=stage.now.plus(-age), people=(walker,)))
    go_on(stage, mapper, 1.0)
    assert (len(heard.take()[-1].numbers()) > 0) == kept


@pytest.mark.parametrize(("rate", "pictures"), [(1.0, 3), (0.5, 2), (5.0, 30)])
def test_the_camera_is_listened_to_at_the_rate_that_the_site_wants(rate: float, pictures: int) -> None:
    stage, mapper, _ = mapped(Room(), rate)
    go_on(stage, mapper, 3.0)
    assert len(stage.painted) == pytest.approx(pictures, abs=2)


def test_a_dark_depth_image_changes_nothing_and_is_told_until_one_is_good() -> None:
    stage, mapper, heard = mapped(room := Room(STRANGE))
    go_on(stage, mapper, 1.0)
    before = heard.take()[-1]
    room.dark, room.boxes = True, ()
    go_on(stage, mapper, 2.2)
    (told,) = heard.take()
    assert (told.cells, told.problem) == (before.cells, "expected a depth image, found zeros")
    room.dark = False
    go_on(stage, mapper, 1.2)
    assert [(len(each.numbers()), each.problem) for each in heard.take()] == [(0, "")]


def test_a_camera_that_repeats_one_picture_changes_nothing_and_is_told_until_it_goes_on() -> None:
    """A robot that turns with such a camera would paint the same thing all around itself."""
    stage, mapper, heard = mapped(room := Room(STRANGE))
    go_on(stage, mapper, 1.0)
    before = heard.take()[-1]
    room.frozen, stage.head = True, np.array([0.5, -0.3])
    go_on(stage, mapper, 1.5)
    (told,) = heard.take()
    assert told.cells == before.cells
    assert told.problem == "the picture stands still though the camera has moved"
    room.frozen = False
    go_on(stage, mapper, 1.5)
    assert [each.problem for each in heard.take()] == [""]


def test_the_first_picture_fills_nothing_before_another_came() -> None:
    """It may stand still since before the robot moved."""
    stage, mapper, _ = mapped(room := Room(STRANGE))
    while not stage.painted:
        go_on(stage, mapper, 0.01)
    room.frozen, stage.head = True, np.array([0.5, -0.3])
    go_on(stage, mapper, 2.0)
    assert len(mapper.occupied) == 0
    room.frozen = False
    go_on(stage, mapper, 1.2)
    assert len(mapper.occupied) > 0


def test_a_picture_from_nobody_knows_where_changes_nothing_and_is_told() -> None:
    stage, mapper, heard = mapped(Room(STRANGE))
    stage.localised = False
    go_on(stage, mapper, 2.5)
    assert [(each.cells, each.problem) for each in heard.take()] == [("", ""), ("", NOT_PLACED)]
    stage.localised = True
    go_on(stage, mapper, 1.5)
    told = heard.take()[-1]
    assert (len(told.numbers()) > 0, told.problem) == (True, "")


def test_whoever_comes_later_is_told_too() -> None:
    stage, mapper, _ = mapped(Room(STRANGE))
    go_on(stage, mapper, 1.0)
    late = Latest(stage.bus, OCCUPANCY)
    stage.bus.announce("alive/arm_left")
    go_on(stage, mapper, 0.1)
    assert len(late.take()[-1].numbers()) > 0


def test_a_picture_that_is_taken_while_the_camera_swings_is_left_out() -> None:
    stage, mapper, heard = mapped(Room(STRANGE))
    for step in range(80):
        stage.head = np.array([0.01 * step - 0.7, -0.3])
        go_on(stage, mapper, 0.01)
    assert len(stage.painted) > 1
    assert [len(each.numbers()) for each in heard.take()] == [0]
    go_on(stage, mapper, 0.8)
    assert len(heard.take()[-1].numbers()) > 0


def test_each_look_gives_its_pictures_to_the_map() -> None:
    stage = Stage(Room(STRANGE).paint, base_in_map=ROBOT)
    taken = []
    look = Look(stage.bus, stage.clocks, DESCRIPTION, LAB, InlineCompute(stage.clocks), taken=taken.append)
    run = look.run(LookGoal(tilts=(-0.3, -0.5)), "t/look/1")
    stage.step()
    next(run)
    for _ in range(400):
        stage.step()
        with suppress(StopIteration):
            run.send(Command.GO_ON)
    assert len(taken) == 2


def test_only_a_site_that_wants_it_has_a_mapper() -> None:
    bus, stage = MemoryBus(), Stage(Room().paint)
    wanted = LAB.model_copy(update={"occupancy": OccupancySetting()})
    for place, many in ((LAB, 0), (wanted, 1)):
        made = nodes(bus, stage.clocks, DESCRIPTION, place, InlineCompute(stage.clocks))
        assert sum(isinstance(each, Mapper) for each in made) == many


def edited(stage: Stage, mapper: Mapper, edit: MapEdit) -> MapEdited:
    pending = OCCUPANCY_EDIT.query(stage.bus, EditMap(edit=edit, by="a test"))
    go_on(stage, mapper, 0.05)
    payload = pending.poll()
    assert payload is not None
    return OCCUPANCY_EDIT.decode_answer(payload)


def test_the_map_is_saved_read_at_the_next_start_and_cleared(tmp_path: Path) -> None:
    file = tmp_path / "lab.map.json"
    stage, mapper, heard = mapped(Room(STRANGE), rate=0.2, saved=file)
    go_on(stage, mapper, 1.0)
    before = mapper.occupied
    assert edited(stage, mapper, MapEdit.SAVE) == MapEdited(done=True, cells=len(before), path=str(file))
    _, again, _ = mapped(Room(), saved=file)
    assert again.occupied.tolist() == before.tolist()
    heard.take()
    assert edited(stage, mapper, MapEdit.CLEAR_SAVED).cells == len(before)
    assert [len(each.numbers()) for each in heard.take()] == [0]
    assert not file.exists()


def test_without_a_place_for_files_nothing_is_saved() -> None:
    stage, mapper, _ = mapped(Room(), rate=0.2)
    assert "keeps no files" in edited(stage, mapper, MapEdit.SAVE).reason


def test_a_picture_of_a_look_counts_at_once() -> None:
    stage, mapper, heard = mapped(Room(), rate=0.1)
    go_on(stage, mapper, 0.5)
    shot = Shot(
        encode(Room(STRANGE).paint(stage.camera_in_map(), stage.now)),
        Chain.from_urdf(URDF, "base", "optical").pose({"pan": 0.0, "tilt": -0.3}),
        ROBOT,
    )
    mapper.offer(shot)
    go_on(stage, mapper, 0.1)
    assert len(heard.take()[-1].numbers()) > 0
