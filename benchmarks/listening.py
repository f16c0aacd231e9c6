"""What ``stillness`` and ``waits`` hear of a run: which goals are under way, and whether the robot moves.

The robot moves when a joint, a finger or the base does.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Final

from tandem.skills.ports.action import GoalStatus
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import JointStates, Odometry
from tandem.skills.ports.keys import JOINT_STATES, ODOMETRY, Latest
from tandem.skills.ports.tasks import TASK_STATUS, TaskStatus

MOVING: Final = 0.01
"""rad/s or m/s of a joint, m/s or rad/s of the base; sensors' noise is below."""
FINGER_MOVING: Final = 0.002
"""m/s."""


class Listening(ABC):
    """A node that listens; give it all messages of a run.

    Args:
        bus: where the robot is.
    """

    def __init__(self, bus: Bus) -> None:
        self._goals = bus.subscribe("skill/*/*/status", depth=4096)
        self._joints = Latest(bus, JOINT_STATES, depth=4096)
        self._odometry = Latest(bus, ODOMETRY, depth=4096)
        self._tasks = Latest(bus, TASK_STATUS, depth=1024)
        self._last: float | None = None
        self.open: dict[str, tuple[str, GoalStatus]] = {}
        """The goals under way by id, each with its skill such as ``base/drive``."""

    @abstractmethod
    def on_task(self, status: TaskStatus) -> None:
        """Take in how a task stands."""

    @abstractmethod
    def on_passed(self, seconds: float, now: float, *, moving: bool) -> None:
        """Take in that so many robot seconds have passed until ``now``, and whether the robot moves."""

    def step(self) -> bool:
        """Take in what has arrived."""
        for task in self._tasks.take():
            self.on_task(task)
        for sample in self._goals.drain():
            status = GoalStatus.model_validate_json(sample.payload)
            if status.state.terminal:
                self.open.pop(status.goal_id, None)
            else:
                skill = sample.key.removeprefix("skill/").removesuffix("/status")
                self.open[status.goal_id] = (skill, status)
        self._odometry.refresh()
        for states in self._joints.take():
            now, last = states.stamp.seconds, self._last
            self._last = now
            if last is not None:
                self.on_passed(now - last, now, moving=moves(states, self._odometry.value))
        return False

    def close(self) -> None:
        """Stop listening."""
        for end in (self._goals, self._joints, self._odometry, self._tasks):
            end.close()


def speed(states: JointStates) -> float:
    """Return the largest speed of a joint (rad/s, m/s), fingers apart."""
    named = zip(states.names, states.velocities, strict=True)
    return max((abs(velocity) for name, velocity in named if not _is_finger(name)), default=0.0)


def moves(states: JointStates, odometry: Odometry | None) -> bool:
    """Say whether base, joints or fingers move."""
    if odometry is not None and max(abs(odometry.linear), abs(odometry.angular)) > MOVING:
        return True
    named = zip(states.names, states.velocities, strict=True)
    fingers = max((abs(velocity) for name, velocity in named if _is_finger(name)), default=0.0)
    return speed(states) > MOVING or fingers > FINGER_MOVING


def _is_finger(joint: str) -> bool:
    return "finger" in joint
