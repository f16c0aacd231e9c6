"""A fetch that is cancelled with ``on_cancel: put_down``, with a crash before, meanwhile or after.

Over the bus in memory, with mocked skills and the ledger on disk.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from surroundings import Surroundings

from tandem.executive.ledger.sqlite import SqliteLedger
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_PAUSE,
    TASK_RESUME,
    TASK_STEP,
    Breakpoint,
    CancelTask,
    ControlAnswer,
    ForceNode,
    StepTask,
    TaskAnswer,
    TaskState,
    TaskStatus,
    by_client,
)
from tandem.skills.site import load
from tandem.skills.testing.mock_robot import MockRobot
from tandem.trees.registry import discover

S = TaskState
TAG = Pose(position=(0.5, 0.5, 0.74), orientation=from_axes((0, -1, 0), (0, 0, 1), (-1, 0, 0)))
FETCH = {"task": "fetch", "item": 29, "on_cancel": "put_down"}


class Rig(Surroundings):
    """An executive whose robot of mocked skills outlives it."""

    def __init__(self, folder: Path) -> None:
        super().__init__(ledger=lambda: SqliteLedger(folder), kinds=discover())
        self.robot = MockRobot(self.hub.endpoint(), self.clocks, load("lab"), items={29: TAG}, duration=0.05)
        self.tick = 0

    def step(self, times: int = 1, seconds: float = 0.01) -> None:
        for _ in range(times):
            self.clocks.advance(seconds)
            if hasattr(self, "robot"):
                self.tick += 1
                stamp = self.clocks.robot()
                assert stamp is not None
                CLOCK.publish(self.bus, Clock(stamp=stamp, tick=self.tick))
                if self.tick % 50 == 0:
                    self.robot.tell()
                self.robot.step()
            self.executive.step()

    def restart(self) -> None:
        self.crash()
        self.begin()

    def status(self, task: str) -> TaskStatus:
        found = self.executive.book.find(task)
        assert found is not None
        return found

    def until(self, task: str, *states: TaskState, steps: int = 20_000) -> TaskStatus:
        for _ in range(steps):
            found = self.status(task)
            if found.state in states:
                return found
            self.step()
        raise AssertionError(f"{self.status(task)}")

    def hold_before(self, node: str, **more: object) -> str:
        task = self.ask({**FETCH, **more}).task
        self.until(task, S.RUNNING)
        assert self.say(TASK_BREAKPOINT, Breakpoint(task=task, node=node)).accepted
        self.until(task, S.PAUSED)
        return task


@pytest.fixture
def rig(tmp_path: Path) -> Rig:
    return Rig(tmp_path)


def put_down(rig: Rig, task: str) -> None:
    ended = rig.until(task, S.CANCELED, S.FAILED, S.INTERRUPTED)
    assert (ended.state, ended.failure) == (S.CANCELED, None)
    assert rig.robot.hands == {"left": None, "right": None}
    assert rig.robot.world.held == ()


NODES = ("open", "close", "attach", "retract", "put down", "let go", "detach", "withdraw", "home: drive")
"""In the order in which a fetch comes to them."""


@pytest.mark.parametrize("node", NODES)
def test_paused_then_a_crash_then_a_cancel(rig: Rig, node: str) -> None:
    task = rig.hold_before(node)
    rig.restart()
    assert rig.status(task).state is S.PAUSED
    assert rig.cancel(task).accepted
    put_down(rig, task)


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("steps", [0, 3, 30])
def test_a_cancel_then_a_crash(rig: Rig, node: str, steps: int) -> None:
    task = rig.hold_before(node)
    assert rig.cancel(task).accepted
    rig.step(steps)
    rig.restart()
    put_down(rig, task)


def test_an_item_that_goes_back_goes_to_where_it_stood(rig: Rig) -> None:
    task = rig.hold_before("retract")
    rig.restart()
    rig.cancel(task)
    put_down(rig, task)
    assert rig.robot.world.placed == (), "it is not in the depot"


def test_a_world_that_is_not_heard_yet_is_no_empty_hand(rig: Rig) -> None:
    task = rig.hold_before("put down")
    robot = rig.robot
    del rig.robot
    rig.restart()
    rig.cancel(task)
    rig.step(100, seconds=0.1)
    assert rig.status(task).state is S.CANCELING
    rig.robot = robot
    put_down(rig, task)


def test_a_second_cancel_holds_after_a_crash(rig: Rig) -> None:
    task = rig.hold_before("put down")
    rig.cancel(task)
    rig.step(30)
    assert rig.executive.running.wind_down.stage == "begun"
    rig.restart()
    rig.step(2)
    assert rig.cancel(task).accepted
    rig.restart()
    ended = rig.until(task, S.CANCELED)
    assert ended.failure is None
    assert 29 in rig.robot.hands.values(), "it was to be held"


def test_a_second_cancel_of_a_named_client_holds_too(rig: Rig) -> None:
    """It comes by a key of the client's own, and is on disk before it is answered like any other verb."""
    pending = rig.bus.query(by_client("ann", REQUEST), json.dumps(FETCH).encode())
    rig.step()
    task = TaskAnswer.model_validate_json(pending.poll() or b"").task
    rig.until(task, S.RUNNING)
    assert rig.say(TASK_BREAKPOINT, Breakpoint(task=task, node="put down")).accepted
    rig.until(task, S.PAUSED)
    rig.cancel(task)
    rig.step(30)
    pending = rig.bus.query(
        by_client("ann", TASK_CANCEL.key), CancelTask(task=task).model_dump_json().encode()
    )
    rig.executive._verbs.step()
    assert ControlAnswer.model_validate_json(pending.poll() or b"").accepted
    rig.restart()
    assert rig.until(task, S.CANCELED).failure is None
    assert 29 in rig.robot.hands.values(), "it was to be held"


def test_a_cancel_that_is_sent_twice_at_once_still_puts_down(rig: Rig) -> None:
    task = rig.hold_before("put down")
    for _ in range(2):
        TASK_CANCEL.query(rig.bus, CancelTask(task=task))
    put_down(rig, task)


def test_breakpoints_hold_after_a_crash_until_they_are_taken_away(rig: Rig) -> None:
    task = rig.hold_before("put down")
    for _ in range(2):
        rig.restart()
        assert rig.verb(TASK_RESUME, task).accepted
        rig.until(task, S.PAUSED)
        assert "put down" in rig.executive.running.running
    assert rig.say(TASK_BREAKPOINT, Breakpoint(task=task, node="put down", on=False)).accepted
    rig.restart()
    rig.verb(TASK_RESUME, task)
    rig.until(task, S.SUCCEEDED)


def test_a_forced_node_is_forced_after_a_crash(rig: Rig) -> None:
    task = rig.hold_before("put down", test_run=True)
    assert rig.say(TASK_FORCE, ForceNode(task=task, node="home: drive", status="FAILURE")).accepted
    rig.say(TASK_BREAKPOINT, Breakpoint(task=task, node="put down", on=False))
    rig.restart()
    rig.verb(TASK_RESUME, task)
    ended = rig.until(task, S.FAILED)
    assert "forced" in ended.failure.message


def test_a_step_ends_after_one_leaf_although_the_executive_crashed_in_it(rig: Rig) -> None:
    task = rig.ask(FETCH).task
    rig.until(task, S.RUNNING)
    rig.verb(TASK_PAUSE, task)
    rig.until(task, S.PAUSED)
    assert rig.say(TASK_STEP, StepTask(task=task)).accepted
    rig.restart()
    rig.step(1000)
    assert rig.status(task).state is S.PAUSED
