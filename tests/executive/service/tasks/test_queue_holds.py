"""What would fail every waiting task holds the queue, and each task tells what it waits for."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Literal

import pytest
from py_trees.behaviour import Behaviour
from py_trees.common import Status
from surroundings import WAIT as KIND
from surroundings import Surroundings

from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.executive.service.tasks.queue_holds import FIRST_TRY, LAST_TRY
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import STOP_STATE
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TASK_INFO, TaskState, TaskStatus
from tandem.skills.ports.world import ROBOT_POSE, RobotPose
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.knowledge import Knowledge
from tandem.trees.registry import discover
from tandem.trees.task import TaskType

S = TaskState
WAIT = {"task": "wait", "item": 29}


class FailingRequest(Message):
    task: Literal["failing"] = "failing"
    kind: str = "NOT_LOCALISED"


class Fails(Behaviour):
    """Fails as it is asked to, unless the robot is localised."""

    def __init__(self, kind: str, context: TreeContext) -> None:
        super().__init__("fails")
        self.kind, self.context = kind, context

    def update(self) -> Status:
        if self.context.knowledge.robot_localised:
            return Status.SUCCESS
        self.context.failures.add(Failure(kind=FailureKind(self.kind), message="nothing helps"))
        return Status.FAILURE


FAILING = TaskType(
    "failing", "Fail.", FailingRequest, lambda _, __: (), lambda asked, at: Fails(asked.kind, at)
)


@pytest.fixture
def here() -> Surroundings:
    return Surroundings(kinds={"wait": KIND, "failing": FAILING})


def states(here: Surroundings, *tasks: str) -> list[TaskState]:
    return [status(here, task).state for task in tasks]


def status(here: Surroundings, task: str) -> TaskStatus:
    return next(each for each in here.executive.book.all() if each.task == task)


def stop(here: Surroundings, *, on: bool) -> None:
    STOP_STATE.publish(
        here.bus, StopState(stopped=on, by="ann" if on else "", reason="a child" if on else "")
    )
    here.step(2)


def localised(here: Surroundings) -> None:
    stamp = here.clocks.robot()
    assert stamp is not None
    nowhere = FloorPose(x=0.0, y=0.0, yaw=0.0)
    pose = RobotPose(
        stamp=stamp,
        localised=True,
        base_in_map=nowhere,
        odom_in_map=nowhere,
        position_sigma=0.01,
        yaw_sigma=0.01,
        moving=False,
    )
    ROBOT_POSE.publish(here.bus, pose)


def test_a_set_stop_holds_all_that_wait_until_it_is_released(here: Surroundings) -> None:
    stop(here, on=True)
    tasks = [here.ask(WAIT).task for _ in range(3)]
    here.world(1)
    here.step(100, seconds=1.0)
    assert states(here, *tasks) == [S.QUEUED] * 3
    assert status(here, tasks[0]).waits_for == "the release of the hardware's stop, set by ann (a child)"
    assert status(here, tasks[2]).waits_for == status(here, tasks[0]).waits_for
    pending = TASK_INFO.query(here.bus, TASK_INFO.asked())
    here.step()
    assert "set by ann" in TASK_INFO.decode_answer(pending.poll()).waits_for
    stop(here, on=False)
    here.step(10)
    assert states(here, *tasks) == [S.SUCCEEDED] * 3


def test_what_the_first_waits_for_is_told_once(here: Surroundings) -> None:
    stop(here, on=True)
    task = here.ask(WAIT).task
    here.step(10)
    told = [(each.task, each.waits_for[:11]) for each in here.told()]
    assert set(told) == {(task, "the release")}
    assert len(told) <= 2


def test_a_silent_hardware_holds_the_queue(here: Surroundings) -> None:
    here.hardware()
    here.step()
    here.step(1, seconds=2.0)
    task = here.ask(WAIT).task
    here.step(20, seconds=1.0)
    assert (status(here, task).state, status(here, task).waits_for) == (
        S.QUEUED,
        "the hardware, which is silent",
    )
    here.world(1)
    here.hardware()
    here.step(2)
    assert states(here, task) == [S.SUCCEEDED]


def test_a_robot_that_was_not_heard_holds_the_tasks_that_need_it(here: Surroundings) -> None:
    here = Surroundings(kinds={"wait": KIND, **discover()})
    fetch = here.ask({"task": "fetch", "item": 29}).task
    free = here.ask(WAIT).task
    here.world(1)
    here.step(100, seconds=1.0)
    assert states(here, fetch, free) == [S.QUEUED, S.SUCCEEDED]
    assert "hw/description" in status(here, fetch).waits_for


def test_a_kind_that_cannot_say_what_it_waits_for_holds_its_own_tasks_only(
    caplog: pytest.LogCaptureFixture,
) -> None:
    def raises(_: Knowledge) -> str:
        raise KeyError("gripper")

    here = Surroundings(kinds={"wait": KIND, "failing": replace(FAILING, waits=raises)})
    broken, free = here.ask({"task": "failing"}).task, here.ask(WAIT).task
    here.world(1)
    here.step(20)
    assert states(here, broken, free) == [S.QUEUED, S.SUCCEEDED]
    assert "its function `waits` raised KeyError('gripper')" in status(here, broken).waits_for
    logged = [each for each in caplog.records if each.message == "`waits` of a kind of task raised"]
    assert [each.exc_info is not None for each in logged] == [True]


@pytest.mark.parametrize("kind", sorted(discover()))
def test_every_task_that_ships_says_what_it_waits_for(kind: str) -> None:
    assert discover()[kind].waits is unheard


def test_each_says_what_it_waits_for(here: Surroundings) -> None:
    here.ask(WAIT)
    second = here.ask(WAIT).task
    later = here.ask({**WAIT, "not_before": 86_400.0}).task
    assert status(here, second).waits_for == "its turn"
    assert status(here, later).waits_for == "its earliest start, 1970-01-02T00:00:00Z"
    here.clocks.wall = 9e5
    here.step()
    assert "a clock that can be trusted" in status(here, later).waits_for


def test_a_robot_that_cannot_localise_fails_one_task_and_holds_the_others(here: Surroundings) -> None:
    first, second = (here.ask({"task": "failing"}).task for _ in range(2))
    other = here.ask(WAIT).task
    here.world(1)
    here.step(10)
    assert states(here, first, second, other) == [S.FAILED, S.QUEUED, S.SUCCEEDED]
    assert "NOT_LOCALISED" in status(here, second).waits_for
    localised(here)
    here.step(5)
    assert states(here, second) == [S.SUCCEEDED]


def test_a_task_that_is_tried_in_vain_waits_again_ever_longer(here: Surroundings) -> None:
    here.ask({"task": "failing"})
    second = here.ask({"task": "failing"}).task
    here.step(10)
    begun = []
    for wait in (FIRST_TRY, 2 * FIRST_TRY, 4 * FIRST_TRY):
        here.step(1, seconds=0.9 * wait)
        here.step(5)
        begun.append(status(here, second).begun)
        here.step(1, seconds=0.2 * wait)
        here.step(5)
        begun.append(status(here, second).begun)
        assert states(here, second) == [S.QUEUED]
    assert begun == [0, 1, 1, 2, 2, 3]
    here.step(100, seconds=LAST_TRY)
    assert states(here, second) == [S.QUEUED]
    assert here.cancel(second).accepted


def test_a_new_request_does_not_wait_longer_for_a_try_than_the_first(here: Surroundings) -> None:
    here.ask({"task": "failing"})
    second = here.ask({"task": "failing"}).task
    here.step(10)
    here.step(20, seconds=LAST_TRY)
    begun = status(here, second).begun
    here.step(10)
    here.ask({"task": "failing"})
    here.step(1, seconds=1.1 * FIRST_TRY)
    here.step(5)
    assert status(here, second).begun == begun + 1


def test_another_failure_of_the_one_that_is_tried_is_its_own(here: Surroundings) -> None:
    here.ask({"task": "failing"})
    second = here.ask({"task": "failing", "kind": "ITEM_GONE"}).task
    third = here.ask({"task": "failing", "kind": "ITEM_GONE"}).task
    here.step(10)
    here.step(1, seconds=2 * FIRST_TRY)
    here.step(10)
    assert states(here, second, third) == [S.FAILED, S.FAILED]


def test_a_task_that_is_taken_up_again_waits_for_the_release_too(tmp_path: Path) -> None:
    here = Surroundings(ledger=lambda: SqliteLedger(tmp_path))
    task = here.ask(WAIT).task
    here.crash()
    here.begin()
    stop(here, on=True)
    here.world(1)
    here.step(30, seconds=1.0)
    assert here.executive.running.ticks <= 1
    stop(here, on=False)
    here.step(3)
    assert states(here, task) == [S.SUCCEEDED]


def test_a_kind_of_its_own_may_wait_for_what_it_needs(here: Surroundings) -> None:
    kind = replace(KIND, waits=lambda known: "" if known.robot_localised else "the robot's place")
    here = Surroundings(kinds={"wait": kind})
    task = here.ask(WAIT).task
    here.world(1)
    here.step(5)
    assert status(here, task).waits_for == "the robot's place"
    localised(here)
    here.step(3)
    assert states(here, task) == [S.SUCCEEDED]
