"""When which node of a task ran: told while it runs, and kept with the task."""

from __future__ import annotations

from surroundings import Surroundings

from tandem.executive.service.running.timeline import MOST, Spans
from tandem.skills.ports.keys import Nothing
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.tasks import (
    TASK_TIMELINE,
    NameTask,
    NodeStatus,
    Span,
    TreeNode,
)

WAIT = {"task": "wait", "item": 3}
RUNNING, SUCCESS, FAILURE, INVALID = (
    NodeStatus.RUNNING,
    NodeStatus.SUCCESS,
    NodeStatus.FAILURE,
    NodeStatus.INVALID,
)


def see(
    spans: Spans, seconds: float, status: NodeStatus, last: NodeStatus = INVALID, message: str = ""
) -> None:
    leaf = TreeNode(
        path="root/leaf", name="leaf", kind="action", type="Leaf", status=status, last=last, message=message
    )
    spans.see([leaf], RobotTime(boot="b", seconds=seconds))


def told(spans: tuple[Span, ...]) -> list[tuple[float, float | None, NodeStatus, str]]:
    return [(s.begin.seconds, None if s.end is None else s.end.seconds, s.status, s.message) for s in spans]


def test_each_run_of_a_node_is_a_span_with_its_end_and_its_words() -> None:
    spans = Spans()
    see(spans, 1, RUNNING)
    see(spans, 2, FAILURE, FAILURE, "empty")
    see(spans, 3, RUNNING)
    see(spans, 4, RUNNING)
    assert told(spans.all()) == [(1, 2, FAILURE, "empty"), (3, None, RUNNING, "")]
    see(spans, 5, INVALID, SUCCESS)
    assert told(spans.all())[1:] == [(3, 5, SUCCESS, "")]


def test_what_is_left_while_it_runs_is_told_as_left() -> None:
    spans = Spans()
    see(spans, 1, RUNNING)
    assert told(spans.end(RobotTime(boot="b", seconds=9))) == [(1, 9, INVALID, "")]


def test_of_many_runs_the_newest_are_kept() -> None:
    spans = Spans()
    for second in range(MOST + 10):
        see(spans, second, RUNNING)
        see(spans, second, SUCCESS)
    assert [len(spans.all()), spans.all()[0].begin.seconds] == [MOST, 10]


def asked(here: Surroundings, task: str) -> list[tuple[str, NodeStatus, bool]]:
    pending = TASK_TIMELINE.query(here.bus, NameTask(task=task))
    here.step()
    answer = pending.poll()
    assert answer is not None
    return [(s.path, s.status, s.end is None) for s in TASK_TIMELINE.decode_answer(answer).spans]


def test_it_is_told_while_the_task_runs_and_after_its_end() -> None:
    here = Surroundings()
    task = here.ask(WAIT).task
    here.step(3)
    assert asked(here, task) == [("wait/wait for the world", RUNNING, True)]
    here.world(2)
    here.step(3)
    assert asked(here, task) == [("wait/wait for the world", FAILURE, False)]
    assert asked(here, "wait-9999") == []


def test_a_wildcard_does_not_ask_for_it() -> None:
    here = Surroundings()
    here.ask(WAIT)
    pending = here.bus.query("task/time*", Nothing().model_dump_json().encode())
    here.step()
    assert pending.poll() is None
