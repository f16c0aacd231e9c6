"""What clients send and read: requests, answers, task states, the tree as it runs."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Annotated, Final, Literal

from pydantic import Field, JsonValue

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Nothing, Service, Topic
from tandem.skills.ports.limits import Limits
from tandem.skills.ports.message import Count, Message, RobotTime
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.skills.ports.utc import UtcSeconds


class TaskState(StrEnum):
    """State of a task."""

    QUEUED = "QUEUED"
    RUNNING = "RUNNING"
    PAUSING = "PAUSING"
    PAUSED = "PAUSED"
    CANCELING = "CANCELING"
    SUCCEEDED = "SUCCEEDED"
    FAILED = "FAILED"
    CANCELED = "CANCELED"
    EXPIRED = "EXPIRED"
    """Its latest start went by while it was queued."""
    REJECTED = "REJECTED"
    """What was queued no longer fits the kinds of task or the site: seen after a restart only."""
    INTERRUPTED = "INTERRUPTED"
    """It was under way, and how far it came is not known: after a restart, or when it was abandoned."""

    @property
    def terminal(self) -> bool:
        """Whether nothing comes after it."""
        return self not in _UNENDED


_UNENDED: Final = frozenset(
    (TaskState.QUEUED, TaskState.RUNNING, TaskState.PAUSING, TaskState.PAUSED, TaskState.CANCELING)
)


class Question(Message):
    """A question to an operator; ``task/answer`` takes one of the choices."""

    node: str
    """The node of the tree that asks."""
    text: str
    choices: tuple[str, ...]


class TaskAnswer(Message):
    """The answer to a request: the task's id, or the problems."""

    accepted: bool
    task: str = ""
    problems: tuple[Problem, ...] = ()
    client_id: str = ""
    """The request's ``id``, if it had one, so that a client that only puts recognises its answer."""


class Progress(Message):
    """Phase of the task's tree, and its progress: 0 to 1, never decreasing."""

    phase: str = ""
    fraction: Annotated[float, Field(ge=0.0, le=1.0)] = 0.0


class Attempt(Message):
    """A failure while the task ran, and what the tree did about it."""

    at: RobotTime | None
    failure: Failure
    recovery: str = ""
    """Node name of the recovery that handled it; empty if none did."""
    times: Count = 0
    """How often that recovery has been tried, including this time."""
    picture: str = ""
    """Number of the camera picture of that moment, for ``task/picture``; empty if there is none."""


class TaskStatus(Message):
    """A task, whole; published on ``task/<id>/status`` and ``task/status`` at each change."""

    task: str
    kind: str
    request: dict[str, JsonValue]
    state: TaskState
    progress: Progress = Progress()
    failure: Failure | None = None
    tried: tuple[Attempt, ...] = ()
    """Failures so far, recovered or not, in order; the newest 32."""
    accepted_at: UtcSeconds
    """UTC seconds."""
    started: RobotTime | None = None
    ended: RobotTime | None = None
    ended_at: UtcSeconds | None = None
    """UTC seconds of its end."""
    client_id: str = ""
    priority: Annotated[int, Field(ge=-100, le=100)] = 0
    """Tasks with a higher priority run first."""
    not_before: UtcSeconds | None = None
    """UTC seconds of its earliest start."""
    expires: UtcSeconds | None = None
    """UTC seconds of its latest start."""
    begun: Count = 0
    """How often its tree has started: more than once after a restart, or if another task took over."""
    running: tuple[str, ...] = ()
    """Names of the running leaves."""
    time_left: float | None = None
    """Estimated remaining robot seconds, from past tasks of its kind; null if there are none."""
    question: Question | None = None
    """Its current question to an operator."""
    waits_for: str = ""
    """What it waits for while QUEUED: its turn, its earliest start, the release of a stop."""
    result: dict[str, JsonValue] | None = None
    """What it found or did, once it has ended, by its kind's schema; null if it tells nothing."""


PAGE: Final = 100
"""Tasks of one answer: some 120 KB, which take a few milliseconds to write."""
Place = Count
"""A task's place in the order of arrival; 0 stands for none."""


class AskTasks(Message):
    """Query the tasks that the executive has in memory, starting with the newest."""

    before: Place = 0
    """Only tasks older than the ``more`` of the previous answer; 0: start with the newest."""
    limit: Annotated[int, Field(ge=1, le=PAGE)] = PAGE


class TaskList(Message):
    """A page of the tasks in the executive's memory, oldest first."""

    tasks: tuple[TaskStatus, ...]
    more: Place = 0
    """Pass it as ``before`` to get the next page; 0 if there are no older ones."""


class NameTask(Message):
    """Pause, resume or abandon the task with this id, or query its status.

    Here and in every other command, ``task`` may also be the ``id`` that the client gave its request.
    """

    task: str


class StepTask(Message):
    """Run a paused task for one more leaf, or for one tick."""

    task: str
    by: Literal["leaf", "tick"] = "leaf"


class Reprioritise(Message):
    """Change the priority of a queued task."""

    task: str
    priority: Annotated[int, Field(ge=-100, le=100)]


class AnswerQuestion(Message):
    """Answer a task's question with one of its choices."""

    task: str
    answer: Annotated[str, Field(max_length=200)]


Side = Literal["before", "after"]
"""Of a node, where a breakpoint is."""
ForcedStatus = Literal["SUCCESS", "FAILURE"]
"""How a node ends that does not work."""


class Breakpoint(Message):
    """Set or remove a breakpoint before or after a node of the tree."""

    task: str
    node: str
    """The node's path, or its name if no other node has it."""
    when: Side = "before"
    on: bool = True


class ForceNode(Message):
    """Force the status of a node in a test run; null lets it run again."""

    task: str
    node: str
    status: ForcedStatus | None


class AskHistory(Message):
    """Query tasks of the ledger, newest first."""

    states: tuple[TaskState, ...] = ()
    """Only tasks in these states; default: all."""
    since: float = 0.0
    """Only tasks accepted at or after these UTC seconds."""
    task: str = ""
    """Only the task with this id, and those whose request has it as ``id``."""
    before: Place = 0
    """Only tasks older than the ``more`` of the previous answer; 0: start with the newest."""
    limit: Annotated[int, Field(ge=1, le=PAGE)] = PAGE


class History(Message):
    """Tasks of the ledger, newest first."""

    tasks: tuple[TaskStatus, ...]
    more: Place = 0
    """Pass it as ``before`` to get the next page; 0 if there are no more."""


class AskPicture(Message):
    """The picture of an attempt of a task."""

    task: str
    picture: str


class CancelTask(Message):
    """Cancel the task of this id, queued or running."""

    task: str


class ControlAnswer(Message):
    """Whether a command was accepted, or why not."""

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
    """Class of the behaviour."""
    status: NodeStatus = NodeStatus.INVALID
    last: NodeStatus = NodeStatus.INVALID
    """Its status at the last tick, even if its parent has reset it to INVALID since."""
    message: str = ""
    children: tuple[TreeNode, ...] = ()

    @property
    def shown(self) -> NodeStatus:
        """Its status; of one that has been set back how it ended last."""
        return self.last if self.status is NodeStatus.INVALID else self.status

    def walk(self) -> Iterator[TreeNode]:
        """Yield this node and all below it, parents first."""
        left = [self]
        while left:
            node = left.pop()
            yield node
            left.extend(reversed(node.children))


MOST_ON_BOARD: Final = 40
"""Values of a board that are told: at most some 4 kB with each tree."""


class TreeSnapshot(Message):
    """A task's tree at one moment; ``tick`` counts the ticks since the task's start."""

    task: str
    kind: str
    tick: Count
    stamp: RobotTime | None = None
    root: TreeNode
    board: dict[str, str] = Field(default_factory=dict, max_length=MOST_ON_BOARD)
    """What the tree's leaves have decided so far, in words, by name; of kinds that tell it."""
    breakpoints: dict[str, tuple[Side, ...]] = Field(default_factory=dict)
    """Where the task pauses, by the node's path; whoever set it."""
    forced: dict[str, ForcedStatus] = Field(default_factory=dict)
    """The status that nodes of a test run end with instead of working, by path."""


class Span(Message):
    """One run of a node of a task's tree."""

    path: str
    kind: Literal["sequence", "selector", "parallel", "recovery", "decorator", "condition", "action"]
    begin: RobotTime
    end: RobotTime | None = None
    """None while it runs."""
    status: NodeStatus
    """How it ended; INVALID: it was left."""
    message: str = ""


class Timeline(Message):
    """The runs of a task's phases, recoveries and actions, the newest 256; of any task in the ledger."""

    task: str
    spans: tuple[Span, ...] = ()


class ExecutiveInfo(Message):
    """Information about the executive."""

    name: str
    version: str
    tasks: tuple[str, ...]
    """The tasks that it accepts, and that the robot can do as far as it is known."""
    unable: dict[str, str] = Field(default_factory=dict)
    """Tasks that this robot can't do, each with what it needs and the robot lacks."""
    running: str = ""
    queued: Count = 0
    waits_for: str = ""
    """What the first queued task waits for while none runs."""


class KindOfTask(Message):
    """A kind of task that the executive accepts."""

    name: str
    """The value of ``task`` in a request."""
    summary: str
    """What it does, in one line."""
    request: dict[str, JsonValue]
    """JSON Schema of its request, whole in itself."""


class TaskKinds(Message):
    """The kinds of task that the executive accepts, and the items that they may be about."""

    kinds: tuple[KindOfTask, ...]
    items: tuple[str, ...] = ()
    """The numbers of the items of the robot's site, as text."""
    names: dict[str, Count] = Field(default_factory=dict)
    """Names that the site gives to items, with the number of each."""


class Times(Message):
    """A histogram of durations since the process started."""

    bounds: tuple[float, ...]
    """Seconds; the upper edge of each class but the last, which has none."""
    counts: tuple[Count, ...]
    """Count per class; one more than there are bounds."""
    total: float
    """Sum, in seconds."""


class ExecutivePulse(Message):
    """Published once a second, for monitoring the executive."""

    queued: Count
    running: str = ""
    """The running task, or empty."""
    ticks: Times
    """Duration of tree ticks, in seconds of the host."""


REQUEST: Final = "task/request"
"""Put or query a request's document here: {"task": "fetch", "item": 29}."""


def by_client(name: str, key: str) -> str:
    """Return the key at which a client with a name of its own asks: ``task/by/<name>/request``."""
    return key.replace("task/", f"task/by/{name}/", 1)


TASK_ANSWERS: Final = Topic("task/answers", TaskAnswer)
"""What was answered to each request, for clients that only put."""
TASK_STATUS: Final = Topic("task/status", TaskStatus)
"""Published at each change; queried, it answers with the task that changed last."""
TASK_CANCEL: Final = Service("task/cancel", CancelTask, ControlAnswer)
TASK_PAUSE: Final = Service("task/pause", NameTask, ControlAnswer)
TASK_RESUME: Final = Service("task/resume", NameTask, ControlAnswer)
TASK_STEP: Final = Service("task/step", StepTask, ControlAnswer)
"""A paused task goes on until one more leaf has ended, or by one tick, and is paused again."""
TASK_ABANDON: Final = Service("task/abandon", NameTask, ControlAnswer)
"""Give up a cancelled task whose hardware does not answer."""
TASK_REPRIORITISE: Final = Service("task/reprioritise", Reprioritise, ControlAnswer)
TASK_ANSWER: Final = Service("task/answer", AnswerQuestion, ControlAnswer)
TASK_BREAKPOINT: Final = Service("task/breakpoint", Breakpoint, ControlAnswer)
TASK_FORCE: Final = Service("task/force", ForceNode, ControlAnswer)
TASK_HISTORY: Final = Service("task/history", AskHistory, History, reads=True, limits=Limits(per_step=1))
TASK_PICTURE: Final = "task/picture"
"""Asked with an AskPicture; answered with a JPEG, or with nothing when there is none."""
TASK_LIST: Final = Service("task/list", AskTasks, TaskList, reads=True, limits=Limits(per_step=2))
TASK_INFO: Final = Service("task/info", Nothing, ExecutiveInfo, reads=True)
TASK_KINDS: Final = Service("task/kinds", Nothing, TaskKinds, reads=True)
TASK_TIMELINE: Final = Service("task/timeline", NameTask, Timeline, reads=True, exact=True)
TASK_SITE: Final = Service("task/site", Nothing, Site, reads=True)
TASK_PULSE: Final = Topic("task/pulse", ExecutivePulse)
TREE: Final = Topic("tree/snapshot", TreeSnapshot)
TREE_NOW: Final = Service("tree/now", Nothing, TreeSnapshot, reads=True)


def task_status(id_: str) -> Topic[TaskStatus]:
    """Return the topic of one task's status; queried, it answers with the status of now, or with nothing."""
    return Topic(f"task/{id_}/status", TaskStatus)
