"""A record plays into a bus in memory: forward, faster, to a moment and back; and it answers questions."""

from __future__ import annotations

from pathlib import Path

import pytest

from tandem.executive.records.known import ALIVE, Alive
from tandem.executive.records.lines_file import write_lines
from tandem.executive.records.player import Player
from tandem.executive.records.recording import Attachment, Facts, Recorded, Recording, Span, open_recording
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK, DESCRIPTION, Latest, Nothing
from tandem.skills.ports.message import Message, RobotTime
from tandem.skills.ports.tasks import (
    TASK_HISTORY,
    TASK_LIST,
    TASK_STATUS,
    TASK_TIMELINE,
    TREE,
    TREE_NOW,
    AskHistory,
    AskTasks,
    NameTask,
    NodeStatus,
    TaskState,
    TaskStatus,
    Timeline,
    TreeNode,
    TreeSnapshot,
    task_status,
)
from tandem.skills.ports.tasks import (
    Span as Run,
)
from tandem.skills.testing.mock_description import mock_description

FACTS = Facts(site="lab", robot="tiago", release="0.1.0", began=0.0)
END = 60.0


def stamp(at: float) -> RobotTime:
    return RobotTime(boot="b", seconds=at)


def told(at: float, key: str, message: Message) -> Recorded:
    return Recorded(key, at, stamp(at), round(at * 1e9), message.model_dump_json().encode())


def status(task: str, state: TaskState) -> TaskStatus:
    return TaskStatus(task=task, kind="fetch", request={}, state=state, accepted_at=float(task[1:]))


def tree(tick: int) -> TreeSnapshot:
    root = TreeNode(path="fetch", name="fetch", kind="sequence", type="Sequence")
    return TreeSnapshot(task="t1", kind="fetch", tick=tick, root=root)


def of_task(at: float, task: str, state: TaskState) -> tuple[Recorded, Recorded]:
    message = status(task, state)
    return told(at, TASK_STATUS.key, message), told(at, task_status(task).key, message)


@pytest.fixture
def record(tmp_path: Path) -> Recording:
    """A minute: two tasks, a tree every second, the clock at 10 Hz, an executive that goes."""
    found = [
        told(0.0, ALIVE, Alive(names=("executive", "process/base"))),
        *of_task(1.0, "t1", TaskState.RUNNING),
        *of_task(20.0, "t1", TaskState.SUCCEEDED),
        *of_task(30.0, "t2", TaskState.RUNNING),
        told(45.0, ALIVE, Alive(names=("process/base",))),
        *(told(float(each), TREE.key, tree(each)) for each in range(60)),
        *(told(each / 10, CLOCK.key, Clock(stamp=stamp(each / 10), tick=each)) for each in range(600)),
    ]
    spans = (
        Run(path="fetch/go", kind="action", begin=stamp(1.0), end=stamp(8.0), status=NodeStatus.SUCCESS),
        Run(path="fetch/pick", kind="action", begin=stamp(8.0), end=stamp(20.0), status=NodeStatus.SUCCESS),
    )
    attached = (
        Attachment(DESCRIPTION.key, 0.0, mock_description().model_dump_json().encode()),
        Attachment(
            f"{TASK_TIMELINE.key}/t1", 20.0, Timeline(task="t1", spans=spans).model_dump_json().encode()
        ),
    )
    path = tmp_path / "box.jsonl.gz"
    write_lines(path, FACTS, Span(0.0, END), attached, sorted(found, key=lambda each: each.at))
    return open_recording(path)


def test_all_is_played_once_and_in_order(record: Recording) -> None:
    player = Player(record)
    heard = player.bus.subscribe("**", depth=10_000)
    player.speed = 4.0
    steps = 0
    while not player.ended:
        player.advance(0.5)
        steps += 1
    said = [(each.key, each.payload) for each in heard.drain()]
    assert said == [(each.key, each.payload) for each in record.messages() if each.key != ALIVE]
    assert steps == 30


def test_standing_still_says_nothing(record: Recording) -> None:
    player = Player(record)
    player.seek(10.0)
    player.speed = 0.0
    assert player.advance(5.0) == 0
    assert player.at == 10.0


@pytest.mark.parametrize("way", [(35.0,), (5.0, 35.0), (50.0, 35.0), (50.0, 2.0, 59.0, 35.0)])
def test_however_a_moment_is_reached_the_same_is_known(record: Recording, way: tuple[float, ...]) -> None:
    straight = Player(record)
    straight.play(35.0)
    player = Player(record)
    for at in way:
        player.seek(at)
    assert player.known() == straight.known()
    assert list(player.known().last) == list(straight.known().last)


def test_listeners_hear_what_holds_at_the_moment(record: Recording) -> None:
    player = Player(record)
    clock, trees = Latest(player.bus, CLOCK), Latest(player.bus, TREE)
    tasks = Latest(player.bus, TASK_STATUS)
    assert not player.seek(40.0)
    assert clock.refresh() == Clock(stamp=stamp(40.0), tick=400)
    assert trees.refresh() == tree(40)
    assert {each.task: each.state for each in tasks.take()} == {
        "t1": TaskState.SUCCEEDED,
        "t2": TaskState.RUNNING,
    }


def test_going_back_gives_a_new_bus(record: Recording) -> None:
    player = Player(record)
    player.seek(40.0)
    old = player.bus
    assert player.seek(10.0)
    assert player.bus is not old
    assert player.generation == 1
    assert [each.state for each in player.known().statuses()] == [TaskState.RUNNING]


@pytest.mark.parametrize(("at", "there"), [(0.0, True), (44.0, True), (46.0, False)])
def test_who_was_there(record: Recording, at: float, there: bool) -> None:  # noqa: FBT001 - a table
    player = Player(record)
    player.seek(at)
    assert ("executive" in player.bus.alive()) is there


def test_a_moment_outside_is_the_nearest_within(record: Recording) -> None:
    player = Player(record)
    player.seek(1e9)
    assert player.at == END
    assert player.ended
    player.seek(-5.0)
    assert player.at == 0.0


def test_questions_are_answered_as_of_the_moment(record: Recording) -> None:
    player = Player(record)
    player.seek(10.0)
    asked = {
        "description": DESCRIPTION.query(player.bus, Nothing()),
        "list": TASK_LIST.query(player.bus, AskTasks()),
        "history": TASK_HISTORY.query(player.bus, AskHistory(states=(TaskState.SUCCEEDED,))),
        "timeline": TASK_TIMELINE.query(player.bus, NameTask(task="t1")),
        "tree": TREE_NOW.query(player.bus, Nothing()),
    }
    player.step()
    said = {name: pending.poll() for name, pending in asked.items()}
    assert DESCRIPTION.decode_answer(said["description"] or b"") == mock_description()
    assert [each.task for each in TASK_LIST.decode_answer(said["list"] or b"").tasks] == ["t1"]
    assert TASK_HISTORY.decode_answer(said["history"] or b"").tasks == ()
    assert TREE_NOW.decode_answer(said["tree"] or b"") == tree(10)
    spans = TASK_TIMELINE.decode_answer(said["timeline"] or b"").spans
    assert [(each.path, each.status, each.end) for each in spans] == [
        ("fetch/go", NodeStatus.SUCCESS, stamp(8.0)),
        ("fetch/pick", NodeStatus.RUNNING, None),
    ]


def test_pages_of_the_list_go_back_to_the_first(record: Recording) -> None:
    player = Player(record)
    player.seek(END)
    found, before = [], 0
    while True:
        pending = TASK_LIST.query(player.bus, AskTasks(before=before, limit=1))
        player.step()
        page = TASK_LIST.decode_answer(pending.poll() or b"")
        found += [each.task for each in page.tasks]
        before = page.more
        if not before:
            break
    assert found == ["t2", "t1"]
