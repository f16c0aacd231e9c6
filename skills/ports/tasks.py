"""What clients send and read: requests, answers, task states, the tree as it runs."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Final, Literal

from pydantic import Field, JsonValue

from skills.ports.failure import Failure
from skills.ports.keys import Nothing, Service, Topic
from skills.ports.message import Message, RobotTime


class TaskState(StrEnum):
    """Where a task stands."""

    QUEUED = "QUEUED"
    RUNNING = "RUNNING"
    PAUSING = "PAUSING"
    PAUSED = "PAUSED"
    CANCELING = "CANCELING"
    SUCCEEDED = "SUCCEEDED"
    FAILED = "FAILED"
    CANCELED = "CANCELED"
    REJECTED = "REJECTED"

    @property
    def terminal(self) -> bool:
        """Whether nothing comes after it."""
        return self not in _UNENDED


_UNENDED: Final = frozenset(
    (TaskState.QUEUED, TaskState.RUNNING, TaskState.PAUSING, TaskState.PAUSED, TaskState.CANCELING)
)


class Problem(Message):
    """What is wrong with a document: where in it, what was expected, what was there."""

    path: str
    expected: str
    found: str = ""


class TaskAnswer(Message):
    """The answer to a request: the task's id, or what is wrong."""

    accepted: bool
    task: str = ""
    problems: tuple[Problem, ...] = ()
    client_id: str = ""
    """The ``id`` of the request's document, if it had one: so a client that only puts knows its answer."""


class Progress(Message):
    """Phase in words of the task's tree, and how far: 0 to 1, never running backwards."""

    phase: str = ""
    fraction: Annotated[float, Field(ge=0.0, le=1.0)] = 0.0


class Attempt(Message):
    """Something that went wrong while the task ran, and what the tree did about it."""

    at: RobotTime | None
    failure: Failure
    recovery: str = ""
    """The recovery that took it, by the name of its node; empty when none did."""
    times: int = 0
    """How often that recovery has been tried by now, this time included."""
    picture: str = ""
    """Number of the camera's picture of that moment, asked for with ``task/picture``; empty without."""


class TaskStatus(Message):
    """A task, whole; published on ``task/<id>/status`` and ``task/status`` at each change."""

    task: str
    kind: str
    request: dict[str, JsonValue]
    state: TaskState
    progress: Progress = Progress()
    failure: Failure | None = None
    tried: tuple[Attempt, ...] = ()
    """What went wrong so far, mended or not, in order; the newest 32."""
    accepted_at: float
    """UTC seconds."""
    started: RobotTime | None = None
    ended: RobotTime | None = None


class TaskList(Message):
    """Every task that the executive remembers, oldest first."""

    tasks: tuple[TaskStatus, ...]


class NameTask(Message):
    """Pause, resume or step the running task of this id."""

    task: str


class AskPicture(Message):
    """The picture of an attempt of a task."""

    task: str
    picture: str


class CancelTask(Message):
    """Cancel the task of this id, queued or running."""

    task: str


class ControlAnswer(Message):
    """Whether a verb was taken, and why not."""

    accepted: bool
    reason: str = ""


class NodeStatus(StrEnum):
    """py_trees' statuses."""

    INVALID = "INVALID"
    RUNNING = "RUNNING"
    SUCCESS = "SUCCESS"
    FAILURE = "FAILURE"


class TreeNode(Message):
    """A node of a tree: its path of names from the root ("fetch/pick/close") names it for ever."""

    path: str
    name: str
    kind: Literal["sequence", "selector", "parallel", "recovery", "decorator", "condition", "action"]
    type: str
    """The class of the behaviour."""
    status: NodeStatus = NodeStatus.INVALID
    message: str = ""
    children: tuple[TreeNode, ...] = ()


class TreeSnapshot(Message):
    """A task's tree at one moment; ``tick`` counts the ticks since the task's start."""

    task: str
    kind: str
    tick: int
    stamp: RobotTime | None = None
    root: TreeNode


class ExecutiveInfo(Message):
    """Who serves the tasks here."""

    name: str
    version: str
    tasks: tuple[str, ...]
    """The kinds of request that are taken."""
    running: str = ""
    queued: int = 0


class Times(Message):
    """A histogram of durations since the start of who counts them."""

    bounds: tuple[float, ...]
    """Seconds; the upper edge of each class but the last, which has none."""
    counts: tuple[int, ...]
    """How many fell into each class; one more than there are bounds."""
    total: float
    """Seconds, all of them together."""


class ExecutivePulse(Message):
    """Told once a second, for who watches over the executive."""

    queued: int
    running: str = ""
    """The task that runs, or nothing."""
    ticks: Times
    """How long the ticks of trees took, in seconds of the host."""


REQUEST: Final = "task/request"
"""Put or query a request's document here: {"task": "fetch", "item": 29}."""


def by_client(name: str, key: str) -> str:
    """Return the key at which a client with a name of its own asks: ``task/by/<name>/request``."""
    return key.replace("task/", f"task/by/{name}/", 1)


TASK_ANSWERS: Final = Topic("task/answers", TaskAnswer)
"""What was answered to each request, for clients that only put."""
TASK_STATUS: Final = Topic("task/status", TaskStatus)
TASK_CANCEL: Final = Service("task/cancel", CancelTask, ControlAnswer)
TASK_PAUSE: Final = Service("task/pause", NameTask, ControlAnswer)
TASK_RESUME: Final = Service("task/resume", NameTask, ControlAnswer)
TASK_STEP: Final = Service("task/step", NameTask, ControlAnswer)
"""A paused task goes on until one more leaf has ended, and is paused again."""
TASK_PICTURE: Final = "task/picture"
"""Asked with an AskPicture; answered with a JPEG, or with nothing when there is none."""
TASK_LIST: Final = Service("task/list", Nothing, TaskList)
TASK_INFO: Final = Service("task/info", Nothing, ExecutiveInfo)
TASK_PULSE: Final = Topic("task/pulse", ExecutivePulse)
TREE: Final = Topic("tree/snapshot", TreeSnapshot)
TREE_NOW: Final = Service("tree/now", Nothing, TreeSnapshot)
