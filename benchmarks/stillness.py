"""When the robot moves, and for whose sake it stands still: read off the bus alone.

The robot moves when a joint, a finger or the base does. While a task runs and the robot stands, the reason is
read off the goals that are under way, at each message of its joints (a hundred times a second):

- a look, a localisation or a grip: the skill's own work (light, a sharp picture, the fingers' force);
- no goal at all: between one goal's end and the next one's start, which is the executive's time;
- any other goal: planning, checks, messages, waiting for a motion's end; also for the executive's sake.
"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.action import GoalStatus
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import JointStates, Odometry
from tandem.skills.ports.keys import JOINT_STATES, ODOMETRY, Latest
from tandem.skills.ports.tasks import TASK_STATUS, TaskState

MOVING: Final = 0.01
"""rad/s or m/s of a joint, m/s or rad/s of the base; sensors' noise is below."""
FINGER_MOVING: Final = 0.002
"""m/s."""
OWN_WORK: Final = ("perception/look", "base/localise")
"""Skills that work while the robot stands; grippers' too."""


class Stillness:
    """A node that listens; give it all messages of a run.

    Args:
        bus: where the robot is.
    """

    def __init__(self, bus: Bus) -> None:
        self._goals = bus.subscribe("skill/*/*/status", depth=4096)
        self._joints = Latest(bus, JOINT_STATES, depth=4096)
        self._odometry = Latest(bus, ODOMETRY, depth=4096)
        self._tasks = Latest(bus, TASK_STATUS, depth=1024)
        self._open: dict[str, str] = {}
        self._last: float | None = None
        self._running = False
        self.seconds: dict[str, float] = {}
        """Robot seconds of the task by what the robot did: ``moving``, or why it stood."""
        self.moved_at: float | None = None
        """Robot time of the first motion of a task."""

    @property
    def total(self) -> float:
        """Robot seconds of the task until now."""
        return sum(self.seconds.values())

    @property
    def idle_share(self) -> float:
        """Share of the task in which the robot stood for the executive's sake."""
        own = {"moving", *(name for name in self.seconds if _own_work(name))}
        idle = sum(spent for name, spent in self.seconds.items() if name not in own)
        return idle / self.total if self.total else float("nan")

    def step(self) -> bool:
        """Take in what has arrived."""
        for status in self._tasks.take():
            self._running = status.state is TaskState.RUNNING
        for sample in self._goals.drain():
            self._take(sample.key, GoalStatus.model_validate_json(sample.payload))
        self._odometry.refresh()
        for states in self._joints.take():
            self._count(states)
        return False

    def close(self) -> None:
        """Stop listening."""
        for end in (self._goals, self._joints, self._odometry, self._tasks):
            end.close()

    def _take(self, key: str, status: GoalStatus) -> None:
        if status.state.terminal:
            self._open.pop(status.goal_id, None)
        else:
            self._open[status.goal_id] = key.removeprefix("skill/").removesuffix("/status")

    def _count(self, states: JointStates) -> None:
        now, last = states.stamp.seconds, self._last
        self._last = now
        if not self._running or last is None:
            return
        what = "moving" if moves(states, self._odometry.value) else self._why()
        self.seconds[what] = self.seconds.get(what, 0.0) + now - last
        if what == "moving" and self.moved_at is None:
            self.moved_at = now

    def _why(self) -> str:
        open_goals = sorted(set(self._open.values()), key=lambda name: (not _own_work(name), name))
        return open_goals[0] if open_goals else "no goal"


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


def _own_work(name: str) -> bool:
    return name in OWN_WORK or name.startswith("gripper_")
