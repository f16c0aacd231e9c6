"""The short forms run, and say what the table needs. What they measure is not judged."""

from __future__ import annotations

import math

import pytest

from benchmarks import arm_planning, growth, ledger, reaction, stillness, stops, ticks, waits
from benchmarks.rows import Row
from benchmarks.stop_latency import Trial
from tandem.skills.ports.action import GoalState, GoalStatus
from tandem.skills.ports.hardware import JointStates, Odometry
from tandem.skills.ports.keys import JOINT_STATES, ODOMETRY
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.tasks import TASK_STATUS, TaskState, TaskStatus
from tandem.skills.wire.memory import MemoryBus


def told(rows: list[Row]) -> dict[str, Row]:
    measured = [row for row in rows if "burners" not in row.what]  # beside these, nothing may come in time
    assert [row for row in measured if not (math.isfinite(row.value) and row.value >= 0.0)] == []
    named = {row.what: row for row in rows}
    assert len(named) == len(rows), "each line has a name of its own"
    return named


def test_ticks() -> None:
    rows = told(list(ticks.rows(quick=True)))
    assert rows["tick of the fetch tree, p99"].aim == 1.0


def test_arm_planning() -> None:
    assert "planning home, CPU p95" in told(arm_planning.rows(quick=True))


@pytest.mark.processes
def test_ledger() -> None:
    rows = told(list(ledger.rows(quick=True)))
    assert rows["from the restart until the task is told to run"].aim == 300.0
    assert rows["from put to acknowledgement, p99"].aim is not None


@pytest.mark.thorough
@pytest.mark.processes
def test_reaction() -> None:
    rows = told(list(reaction.rows(quick=True)))
    assert rows["from a skill's end to the next goal, p99"].aim == 2.0
    assert rows["from a request's put to the first tick, with a ledger, p99"].aim == 10.0


def test_growth() -> None:
    rows = told(list(growth.rows(quick=True)))
    assert {"step with a tick, 1,000 tasks ended", "task/list, answered, 10 tasks waiting"} <= rows.keys()


def test_late_stops_are_counted_by_what_was_under_way() -> None:
    trials = [
        Trial("pick", planning=False, goals=goals, answered=seconds)
        for goals, seconds in (
            ("grasp MOVING", 0.03),
            ("grasp MOVING", 0.01),
            ("close", 0.002),
            ("open", None),
        )
    ]
    rows = {row.what: row for row in stops.told("stop", trials, lambda trial: trial.answered)}
    assert rows["stop, max"].value == pytest.approx(30.0)
    assert [(row.value, row.note) for what, row in rows.items() if "late" in what] == [(1, "of 2 then")]


class Scene:
    """A robot with one joint and one finger; ten messages of each state of affairs."""

    def __init__(self) -> None:
        self.bus = MemoryBus()
        self.stillness = stillness.Stillness(self.bus)
        self._now = 0
        self.joints(0.0)
        status = TaskStatus(task="t", kind="fetch", request={}, state=TaskState.RUNNING, accepted_at=0.0)
        TASK_STATUS.publish(self.bus, status)
        self.stillness.step()

    def goal(self, action: str, state: GoalState) -> None:
        status = GoalStatus(goal_id=action, state=state, sequence=1)
        self.bus.publish(f"skill/{action}/status", status.model_dump_json().encode())

    def base(self, linear: float) -> None:
        at = FloorPose(x=0.0, y=0.0, yaw=0.0)
        ODOMETRY.publish(self.bus, Odometry(stamp=self.stamp, base_in_odom=at, linear=linear, angular=0.0))

    def joints(self, joint: float, finger: float = 0.0, count: int = 1) -> None:
        for _ in range(count):
            self._now += 1
            JOINT_STATES.publish(
                self.bus,
                JointStates(
                    stamp=self.stamp,
                    names=("arm_1", "gripper_finger"),
                    positions=(0.0, 0.0),
                    velocities=(joint, finger),
                    efforts=(0.0, 0.0),
                ),
            )
        self.stillness.step()

    @property
    def stamp(self) -> RobotTime:
        return RobotTime(boot="b", seconds=self._now / 100.0)


def test_the_reason_for_standing_is_the_goal_under_way() -> None:
    scene = Scene()
    scene.joints(0.0, count=10)
    scene.goal("arm_left/move", GoalState.RUNNING)
    scene.joints(0.0, count=20)
    scene.joints(0.5, count=30)
    scene.goal("arm_left/move", GoalState.SUCCEEDED)
    scene.goal("perception/look", GoalState.RUNNING)
    scene.joints(0.0, count=40)
    assert scene.stillness.seconds == pytest.approx(
        {"no goal": 0.1, "arm_left/move": 0.2, "moving": 0.3, "perception/look": 0.4}
    )
    assert scene.stillness.idle_share == pytest.approx(0.3)
    assert scene.stillness.moved_at == pytest.approx(0.32)


def test_the_base_and_the_fingers_move_the_robot_too() -> None:
    scene = Scene()
    scene.joints(0.0, finger=0.005, count=10)
    scene.base(0.2)
    scene.joints(0.0, count=10)
    assert scene.stillness.seconds == pytest.approx({"moving": 0.2})


def test_what_a_fetch_waits_for_is_told_by_phase_and_node_with_what_stood_meanwhile() -> None:
    bus = MemoryBus()
    heard, clock = waits.Waits(bus), iter(range(1000))

    def tick(goals: dict[str, str], joint: float, count: int) -> None:
        for goal, doing in goals.items():
            state = GoalState.RUNNING if doing else GoalState.SUCCEEDED
            status = GoalStatus(goal_id=f"t/{goal}/1", state=state, sequence=1, feedback={"phase": doing})
            bus.publish(f"skill/{goal}/x/status", status.model_dump_json().encode())
        for _ in range(count):
            stamp = RobotTime(boot="b", seconds=next(clock) / 100.0)
            moving = {"positions": (0.0,), "velocities": (joint,), "efforts": (0.0,)}
            JOINT_STATES.publish(bus, JointStates(stamp=stamp, names=("arm_1",), **moving))
        heard.step()

    task = TaskStatus(task="t", kind="fetch", request={}, state=TaskState.RUNNING, accepted_at=0.0)
    at = task.progress.model_copy(update={"phase": "pick"})
    TASK_STATUS.publish(bus, task.model_copy(update={"progress": at}))
    tick({}, 0.0, 1)
    tick({"arm": "PLANNING", "hand": "OPENING"}, 0.0, 10)
    tick({"arm": "MOVING", "hand": ""}, 0.5, 20)
    tick({"arm": ""}, 0.0, 5)
    rows = {row.what: row for row in waits.table("x", heard, "succeeded")}
    assert {what: round(row.value, 3) for what, row in rows.items()} == {
        "waits, x": 0.35,
        "waits, x: pick": 0.35,
        "waits, x: pick: arm": 0.3,
        "waits, x: pick: hand": 0.1,
        f"waits, x: pick: {waits.NOTHING}": 0.05,
    }
    assert rows["waits, x: pick: arm"].note == "planning 0.10, moving 0.20, standing 0.10"
