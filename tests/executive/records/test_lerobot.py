"""A LeRobot data set: what is read back from its files is what the record held, and the layout is v3's."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import av
import cv2
import numpy as np
import pyarrow.parquet as pq
import pytest
from synthetic_record import (
    BLUE,
    CLOSES,
    FACTS,
    JOINTS,
    message,
    motion,
    one_fetch,
    picture,
    stamp,
    status,
    write_mcap,
)

from tandem.executive.records.lerobot.export import Exported, Wanted, export
from tandem.executive.records.lerobot.layout import NUMBERS, Features, Place
from tandem.executive.records.lerobot.spans import NO_LEAF, words_of
from tandem.executive.records.lerobot.tables import FrameFiles
from tandem.executive.records.lerobot.videos import Film, VideoFiles
from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.recording import Recorded, RecordError, Span
from tandem.skills.ports.hardware import SetPoint
from tandem.skills.ports.keys import JOINT_STATES, group_setpoint
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import TaskState

HEAD = "observation.images.head"
OTHER = FACTS.model_copy(update={"seed": 8})
"""Of another run, whose task has the same name."""
FRAMES = 21
"""Of two seconds at ten frames a second, both ends included."""
PUBLISHED = {
    "codebase_version",
    "robot_type",
    "total_episodes",
    "total_frames",
    "total_tasks",
    "chunks_size",
    "data_files_size_in_mb",
    "video_files_size_in_mb",
    "fps",
    "splits",
    "data_path",
    "video_path",
    "features",
}
"""Fields of info.json in the published layout."""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Exported]:
    """Return a data set of two records with a task each, the second of which fails."""
    folder = tmp_path_factory.mktemp("lerobot")
    (folder / "runs").mkdir()
    write_mcap(folder / "runs" / "a.mcap", [*motion(), *one_fetch()])
    failing = [*one_fetch()[:-1], status(3.0, state=TaskState.FAILED)]
    write_mcap(folder / "runs" / "b.mcap", [*motion(), *failing], facts=OTHER)
    root = folder / "set"
    return root, export([folder / "runs"], root, Wanted())


def frames(root: Path) -> dict[str, list[object]]:
    return pq.read_table(root / "data/chunk-000/file-000.parquet").to_pydict()


def info(root: Path) -> dict[str, object]:
    return json.loads((root / "meta/info.json").read_text("utf-8"))


def test_the_files_are_those_of_the_published_layout(made: tuple[Path, Exported]) -> None:
    root, _ = made
    assert {str(each.relative_to(root)) for each in root.rglob("*") if each.is_file()} == {
        "data/chunk-000/file-000.parquet",
        "meta/episodes/chunk-000/file-000.parquet",
        "meta/info.json",
        "meta/stats.json",
        "meta/subtasks.parquet",
        "meta/tandem.json",
        "meta/tasks.parquet",
        f"videos/{HEAD}/chunk-000/file-000.mp4",
    }
    assert set(info(root)) == PUBLISHED


def test_features_are_the_columns_of_the_frames(made: tuple[Path, Exported]) -> None:
    root, _ = made
    features = info(root)["features"]
    schema = pq.read_schema(root / "data/chunk-000/file-000.parquet")
    videos = {name for name, each in features.items() if each["dtype"] == "video"}
    assert set(features) - videos == set(schema.names)
    for name in schema.names:
        kind, (width,) = schema.field(name).type, features[name]["shape"]
        names = features[name]["names"]
        if width > 1:
            assert (kind.list_size, str(kind.value_type), len(names)) == (width, "float", width)
        else:
            assert str(kind) == {"float32": "float"}.get(features[name]["dtype"], features[name]["dtype"])


def test_counts_and_ranges_agree(made: tuple[Path, Exported]) -> None:
    root, told = made
    episodes = pq.read_table(root / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    ranges = [(each["dataset_from_index"], each["dataset_to_index"], each["length"]) for each in episodes]
    assert ranges == [(0, FRAMES, FRAMES), (FRAMES, 2 * FRAMES, FRAMES)]
    columns = frames(root)
    assert columns["index"] == list(range(2 * FRAMES))
    assert columns["frame_index"] == [*range(FRAMES), *range(FRAMES)]
    assert columns["episode_index"] == [0] * FRAMES + [1] * FRAMES
    found = info(root)
    assert (found["total_episodes"], found["total_frames"], found["fps"]) == (2, 2 * FRAMES, 10)
    assert found["splits"] == {"train": "0:2"}
    assert (told.episodes, told.frames, told.left_out) == (2, 2 * FRAMES, ())
    assert pq.ParquetFile(root / "data/chunk-000/file-000.parquet").num_row_groups == 2


def test_state_is_what_was_known_at_each_moment(made: tuple[Path, Exported]) -> None:
    root, _ = made
    state = np.array(frames(root)["observation.state"][:FRAMES])
    moments = 1.0 + np.arange(FRAMES) / 10
    names = info(root)["features"]["observation.state"]["names"]
    assert names == [*(f"{each}.pos" for each in JOINTS), "base.x", "base.y", "base.yaw"]
    assert np.allclose(state[:, 0], moments)
    assert np.allclose(state[:, 3], moments / 10)
    assert np.allclose(state[:, 5], 0.5)
    assert np.allclose(frames(root)["timestamp"][:FRAMES], moments - 1.0)


def test_an_action_is_the_set_point_or_where_the_joint_is_next(made: tuple[Path, Exported]) -> None:
    root, _ = made
    action = np.array(frames(root)["action"][:FRAMES])
    moments = 1.0 + np.arange(FRAMES) / 10
    assert np.allclose(action[:, 0], moments + 0.1)
    streamed = [round(float(each), 1) for each in moments[action[:, 1] == 9.0]]
    assert streamed == [2.0, 2.1, 2.2, 2.3, 2.4], "one came within the step after each of these"
    assert set(action[:, 1].tolist()) == {0.0, 9.0}
    driven = moments[action[:, 3] > 0]
    assert (action[0, 3], driven[-1] < 2.5) == (np.float64(np.float32(0.1)), True), "old ones mean stop"


def test_tasks_and_leaves_are_named_by_number(made: tuple[Path, Exported]) -> None:
    root, _ = made
    columns = frames(root)
    (task,) = pq.read_table(root / "meta/tasks.parquet").to_pylist()
    assert task == {"task_index": 0, "task": "fetch item 3 to depot"}
    table = pq.read_table(root / "meta/subtasks.parquet")
    named = {each["subtask_index"]: each["subtask"] for each in table.to_pylist()}
    leaves = [named[each] for each in columns["subtask_index"][:FRAMES]]
    assert leaves == [NO_LEAF] * 5 + ["drive to item"] * 10 + ["close and watch the hand"] * 6
    assert leaves.index("close and watch the hand") == round((CLOSES - 1.0) * 10)
    assert json.loads(table.schema.metadata[b"pandas"])["index_columns"] == ["subtask"]


def test_the_end_and_success_are_told_in_the_last_frame(made: tuple[Path, Exported]) -> None:
    columns = frames(made[0])
    assert [place for place, done in enumerate(columns["next.done"]) if done] == [FRAMES - 1, 2 * FRAMES - 1]
    assert [place for place, right in enumerate(columns["next.success"]) if right] == [FRAMES - 1]


def test_the_video_has_the_frames_of_all_episodes(made: tuple[Path, Exported]) -> None:
    root, _ = made
    video = cv2.VideoCapture(str(root / f"videos/{HEAD}/chunk-000/file-000.mp4"))
    assert video.get(cv2.CAP_PROP_FPS) == 10.0
    shown = []
    while True:
        good, frame = video.read()
        if not good:
            break
        assert frame.shape == tuple(info(root)["features"][HEAD]["shape"])
        blue, _, red = frame.mean(axis=(0, 1))
        shown.append("blue" if blue > red else "red")
    assert shown == (["blue"] * 10 + ["red"] * 11) * 2
    episodes = pq.read_table(root / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    spans = [
        (each[f"videos/{HEAD}/from_timestamp"], each[f"videos/{HEAD}/to_timestamp"]) for each in episodes
    ]
    assert spans == [(0.0, 2.1), (2.1, 4.2)]


def test_the_video_is_in_the_codec_that_the_set_names(made: tuple[Path, Exported]) -> None:
    root, _ = made
    told = info(root)["features"][HEAD]["info"]
    with av.open(str(root / f"videos/{HEAD}/chunk-000/file-000.mp4")) as file:
        (stream,) = file.streams
        assert (stream.codec.canonical_name, stream.pix_fmt) == (told["video.codec"], told["video.pix_fmt"])
        times = [frame.time for frame in file.decode(stream)]
    assert (told["video.codec"], told["video.pix_fmt"]) == ("h264", "yuv420p")
    assert np.allclose(times, np.arange(2 * FRAMES) / 10, atol=1e-4), "LeRobot looks for frames by their time"


def test_statistics_are_those_of_the_columns(made: tuple[Path, Exported]) -> None:
    root, _ = made
    stats = json.loads((root / "meta/stats.json").read_text("utf-8"))
    state = np.array(frames(root)["observation.state"])
    assert set(stats) == set(info(root)["features"])
    assert np.allclose(stats["observation.state"]["mean"], state.mean(0))
    assert np.allclose(stats["observation.state"]["q99"], np.quantile(state, 0.99, axis=0))
    assert stats["action"]["count"] == [2 * FRAMES]
    assert np.array(stats[HEAD]["mean"]).shape == (3, 1, 1)
    assert np.allclose(np.array(stats[HEAD]["max"]).ravel(), [1.0, 0.0, 1.0], atol=0.05), "red, green, blue"


def test_it_says_of_which_records_it_was_made(made: tuple[Path, Exported]) -> None:
    first, second = json.loads((made[0] / "meta/tandem.json").read_text("utf-8"))["episodes"]
    assert (first["file"], first["task"], first["state"]) == ("runs/a.mcap", "fetch-0001", "SUCCEEDED")
    assert first["facts"]["commit"] == FACTS.commit
    assert (second["file"], second["state"]) == ("runs/b.mcap", "FAILED")


def test_a_black_box_becomes_one_too(tmp_path: Path) -> None:
    messages = sorted([*motion(), *one_fetch()], key=lambda each: each.at)
    write_lines(tmp_path / "box.jsonl.gz", FACTS, Span(0.0, 4.0), [], messages)
    told = export([tmp_path / "box.jsonl.gz"], tmp_path / "set", Wanted(fps=5))
    assert (told.episodes, told.frames, told.features.cameras) == (1, 11, ())
    assert info(tmp_path / "set")["video_path"] is None


def lost(since: float, until: float) -> list[Recorded]:
    """Return the motion without what came in between."""
    return [each for each in motion() if not since < each.at < until]


GAPS = {
    "joints": (lost(1.5, 2.3), {}, 10, r"no joints came for 0\.8 s, 0\.5 s after its start"),
    "joints at the start": (lost(-1.0, 2.0), {}, 10, r"no joints came for 1\.0 s, 0\.0 s after its start"),
    "pictures": ([*motion()], {"shown": lambda at: at < 0.5}, 10, r"no picture of head came for 2\.6 s"),
    "fewer than frames": (
        [*motion()],
        {},
        50,
        "joints came 41 times while it ran, too seldom for 101 frames",
    ),
}


@pytest.mark.parametrize(("moved", "more", "fps", "words"), GAPS.values(), ids=GAPS.keys())
def test_a_task_of_which_something_was_lost_is_no_episode(
    tmp_path: Path, moved: list, more: dict, fps: int, words: str
) -> None:
    write_mcap(tmp_path / "a.mcap", [*moved, *one_fetch()], **more)
    with pytest.raises(RecordError, match=f"fetch-0001: {words}"):
        export([tmp_path / "a.mcap"], tmp_path / "set", Wanted(fps=fps))


def test_pictures_that_nobody_wants_may_be_missing(tmp_path: Path) -> None:
    write_mcap(tmp_path / "a.mcap", [*motion(), *one_fetch()], shown=lambda at: at < 0.5)
    assert export([tmp_path / "a.mcap"], tmp_path / "set", Wanted(cameras=())).episodes == 1


def test_a_task_during_which_the_hardware_started_anew_is_no_episode(tmp_path: Path) -> None:
    again = [
        replace(each, stamp=RobotTime(boot="c", seconds=each.at - 2.0)) for each in motion() if each.at > 2.0
    ]
    write_mcap(tmp_path / "a.mcap", [*lost(2.0, 9.0), *again, *one_fetch()], cameras=())
    with pytest.raises(RecordError, match="the hardware started anew while it ran"):
        export([tmp_path / "a.mcap"], tmp_path / "set", Wanted())


def test_a_task_that_two_records_have_is_one_episode(tmp_path: Path) -> None:
    messages = sorted([*motion(), *one_fetch()], key=lambda each: each.at)
    write_mcap(tmp_path / "a.mcap", messages, cameras=())
    write_lines(tmp_path / "b.jsonl.gz", FACTS, Span(0.0, 4.0), [], messages)
    told = export([tmp_path / "a.mcap", tmp_path / "b.jsonl.gz"], tmp_path / "set", Wanted())
    assert told.episodes == 1
    assert [(path.name, each.reason) for path, each in told.left_out] == [
        ("b.jsonl.gz", "it is in a.mcap, too")
    ]


def test_a_task_that_goes_on_in_the_next_file_is_in_neither(tmp_path: Path) -> None:
    messages = sorted([*motion(), *one_fetch()], key=lambda each: each.at)
    first = [each for each in messages if each.at < 2.0]
    known = {each.key: each for each in first}
    write_mcap(tmp_path / "a.mcap", first, cameras=())
    write_lines(
        tmp_path / "b.jsonl.gz", FACTS, Span(2.0, 4.0), [], [*known.values(), *messages[len(first) :]]
    )
    both = r"its end is not in the record; fetch-0001: it had begun before the record does"
    with pytest.raises(RecordError, match=both):
        export([tmp_path / "a.mcap", tmp_path / "b.jsonl.gz"], tmp_path / "set", Wanted())


UNUSABLE = {
    "still running": (one_fetch()[:-1], "fetch-0001: its end is not in the record"),
    "never started": ([one_fetch()[0]], "fetch-0001: it did not start in the record"),
    "no task": ([], "found none;"),
}


@pytest.mark.parametrize(("states", "words"), UNUSABLE.values(), ids=UNUSABLE.keys())
def test_a_record_without_a_whole_task_is_refused(tmp_path: Path, states: list, words: str) -> None:
    write_mcap(tmp_path / "a.mcap", [*motion(), *states], cameras=())
    with pytest.raises(RecordError, match=words):
        export([tmp_path / "a.mcap"], tmp_path / "set", Wanted())
    assert [each.name for each in tmp_path.iterdir()] == ["a.mcap"], "nothing half-made is left"


def test_records_that_do_not_fit_together_are_refused(tmp_path: Path) -> None:
    first = write_mcap(tmp_path / "a.mcap", [*motion(), *one_fetch()])
    others = {
        write_mcap(
            tmp_path / "b.mcap", [*motion((*JOINTS, "tail")), *one_fetch()], facts=OTHER
        ): "also tail.pos",
        write_mcap(
            tmp_path / "c.mcap", [*motion(), *one_fetch()], size=(18, 32), facts=OTHER
        ): "head with 32 x 18",
        write_mcap(
            tmp_path / "d.mcap", [*motion(), *one_fetch()], cameras=(), facts=OTHER
        ): "found no pictures",
    }
    for other, words in others.items():
        with pytest.raises(RecordError, match=words):
            export([first, other], tmp_path / "set", Wanted())
    assert not (tmp_path / "set").exists()


def test_pictures_of_an_odd_size_are_refused(tmp_path: Path) -> None:
    odd = write_mcap(tmp_path / "a.mcap", [*motion(), *one_fetch()], size=(17, 32))
    with pytest.raises(RecordError, match=r"even height and width.*head with 32 x 17 pixels"):
        export([odd], tmp_path / "set", Wanted())
    assert not (tmp_path / "set").exists()


def test_a_camera_that_was_not_recorded_is_refused(tmp_path: Path) -> None:
    first = write_mcap(tmp_path / "a.mcap", [*motion(), *one_fetch()])
    with pytest.raises(RecordError, match=r"expected pictures of wrist .* found those of head"):
        export([first], tmp_path / "set", Wanted(cameras=("wrist",)))


@pytest.mark.parametrize(
    ("request_", "words"),
    [
        ({"task": "fetch", "item": 3, "to": "depot", "labels": ["x"]}, "fetch item 3 to depot"),
        ({"task": "wait", "seconds": 1.5, "by": None}, "wait seconds 1.5"),
        ({"task": "carry", "put_on": "table", "items": [3, 4]}, "carry put on table items 3, 4"),
    ],
)
def test_a_request_as_words(request_: dict, words: str) -> None:
    assert words_of(str(request_["task"]), request_) == words


def test_what_is_no_message_is_left_out(tmp_path: Path) -> None:
    wrong = [
        Recorded(JOINT_STATES.key, 1.23, stamp(1.23), 0, b'{"names": 3}'),
        Recorded(JOINT_STATES.key, 1.24, stamp(1.24), 0, b"\x00", "bytes"),
        Recorded("task/fetch-0001/status", 1.25, stamp(1.25), 0, b"{}"),
        message(
            group_setpoint("arm_right").key, 1.26, SetPoint(stamp=stamp(1.26), positions=(), velocities=())
        ),
    ]
    write_mcap(tmp_path / "a.mcap", [*motion(), *one_fetch(), *wrong], cameras=())
    assert export([tmp_path / "a.mcap"], tmp_path / "set", Wanted()).frames == FRAMES


def test_the_next_file_begins_when_one_is_full(tmp_path: Path) -> None:
    features = Features(("a.pos",), ("a.pos",), (("head", 36, 64),))
    numbers = dict.fromkeys(NUMBERS, np.zeros(2))
    columns = {"observation.state": np.zeros((2, 1)), "action": np.zeros((2, 1)), **numbers}
    columns |= {name: np.zeros(2, bool) for name, kind in NUMBERS.items() if kind == "bool"}
    tables = FrameFiles(tmp_path, features, file_mb=0.0)
    assert [tables.add(columns).number for _ in range(2)] == [0, 1]
    film = Film("head", (picture("head", BLUE, (36, 64)),), (0, 0))
    videos = VideoFiles(tmp_path, "head", (36, 64), 10, file_mb=0.0)
    assert [videos.add(film)[:3] for _ in range(2)] == [(Place(0), 0.0, 0.2), (Place(1), 0.0, 0.2)]
    assert (Place(1001).chunk, Place(1001).file) == (1, 1)
