"""A process hangs while an arm moves: how long until the arm stands."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Iterator
from typing import Final

from benchmarks.processes import free_endpoint
from benchmarks.rows import Row
from tandem.executive.config.run_options import BusOptions, RunOptions
from tandem.executive.system.process_system import ProcessSystem
from tandem.executive.system.systems import wait_for
from tandem.skills.ports.action import GoalState, GoalStatus, SendGoal, goal_service, status_topic
from tandem.skills.ports.actions.arm import MoveGoal, move
from tandem.skills.ports.actions.base import LOCALISE, LocaliseGoal
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES, LEASES, Latest
from tandem.skills.ports.lease import Lease

GROUP: Final = "arm_left"
AT_REST: Final = 0.02
"""rad/s below which a joint counts as at rest."""
AFTER: Final = {"carry": "home", "home": "carry"}
TIMES: Final = 4


class Moving:
    """The left arm on its way to a posture, sent in the executive's name."""

    def __init__(self, system: ProcessSystem, goal_id: str, posture: str) -> None:
        _localise(system, f"{goal_id}/where")
        self.goal_id = goal_id
        action = move(GROUP)
        self.joints = Latest(system.bus, JOINT_STATES)
        self._statuses: Latest[GoalStatus] = Latest(system.bus, status_topic(action.name))
        goal = MoveGoal(posture=posture).model_dump(mode="json")
        lease = _executives(system)
        sent = SendGoal(goal_id=goal_id, client="executive", goal=goal, lease=lease)
        self._status = GoalStatus.model_validate_json(_sent(system, goal_service(action.name).key, sent))
        assert self._status.state is GoalState.RUNNING, self._status

    def state(self) -> GoalState:
        """Return where the goal stands."""
        return self.status().state

    def status(self) -> GoalStatus:
        """Return all that is known of the goal."""
        for status in self._statuses.take():
            if status.goal_id == self.goal_id:
                self._status = status
        return self._status

    def moves(self) -> bool:
        """Say whether the arm is well under way."""
        return self.fastest() > 10 * AT_REST

    def fastest(self) -> float:
        """Return the speed of its fastest joint (rad/s)."""
        joints: JointStates | None = self.joints.refresh()
        if joints is None:
            return 0.0
        pairs = zip(joints.names, joints.velocities, strict=True)
        return max(abs(speed) for name, speed in pairs if name.startswith(GROUP))


def _sent(system: ProcessSystem, key: str, goal: SendGoal) -> bytes:
    """Send a goal until it is answered: a query may get lost, and the same id starts once."""
    for _ in range(TIMES):
        answer = wait_for(system, system.bus.query(key, goal.model_dump_json().encode()), 5.0)
        if answer is not None:
            return answer
    raise TimeoutError(f"nobody answers at {key}")


def _localise(system: ProcessSystem, goal_id: str) -> None:
    """Have the base find out where it is: among things an arm moves only when that is known."""
    statuses = Latest(system.bus, status_topic(LOCALISE.name))
    goal = LocaliseGoal().model_dump(mode="json")
    sent = SendGoal(goal_id=goal_id, client="executive", goal=goal, lease=_executives(system))
    status = GoalStatus.model_validate_json(_sent(system, goal_service(LOCALISE.name).key, sent))
    while not status.state.terminal:
        system.advance()
        status = next((each for each in statuses.take() if each.goal_id == goal_id), status)
    assert status.state is GoalState.SUCCEEDED, status


def _executives(system: ProcessSystem) -> Lease:
    """Return the executive's lease, as the hardware tells it: this program speaks in the executive's name."""
    leases = Latest(system.bus, LEASES)
    while True:
        told = leases.refresh()
        held = None if told is None else told.of("executive")
        if told is not None and held is not None:
            return Lease(role="executive", boot=told.boot, epoch=held.epoch)
        system.advance()


def stands(moving: Moving) -> bool:
    """Say whether the arm is at rest, although its goal has not ended."""
    return moving.fastest() < AT_REST and not moving.state().terminal


def rows() -> Iterator[Row]:
    """Measure."""
    options = RunOptions(bus=BusOptions(endpoint=free_endpoint()), scenario="Defaults")
    posture = "carry"
    with ProcessSystem(options) as system:
        roles: tuple[str, ...] = ("executive", "arm_left")
        for role in roles:
            took = []
            for number in range(TIMES):
                took.append(_once(system, role, f"{role}/{number}/1", posture))
                posture = AFTER[posture]
            note = f"of {TIMES}, in simulated motion at full speed; a braking from it included"
            yield Row(f"the arm stands after its {role} process hangs, worst", max(took), "s", 0.5, note=note)


def _once(system: ProcessSystem, role: str, goal_id: str, posture: str) -> float:
    moving = Moving(system, goal_id, posture)
    _until(system, moving.moves)
    process = system.pids()[role]
    os.kill(process, signal.SIGSTOP)
    began = time.monotonic()
    try:
        _until(system, lambda: stands(moving))
        took = time.monotonic() - began
    finally:
        os.kill(process, signal.SIGCONT)
    _until(system, lambda: moving.state().terminal)
    assert moving.state() is GoalState.SUCCEEDED, moving.state()
    return took


def _until(system: ProcessSystem, holds: Callable[[], bool], within: float = 60.0) -> None:
    deadline = time.monotonic() + within
    while not holds():
        if time.monotonic() > deadline:
            raise TimeoutError("the arm did not do what was waited for")
        system.advance()
