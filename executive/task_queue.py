"""The tasks: those that wait, first come, first served, and what became of the others."""

from __future__ import annotations

from collections import deque
from typing import Final

from executive.requests import Asked
from skills.ports.failure import Failure
from skills.ports.message import RobotTime
from skills.ports.tasks import Attempt, Problem, Progress, TaskAnswer, TaskState, TaskStatus

MAX_WAITING: Final = 100
"""Tasks that may wait; one more is refused."""
KEPT: Final = 200
"""Ended tasks that are remembered."""

_DIGITS: Final = "0123456789abcdefghijklmnopqrstuvwxyz"


def start_id(utc: float) -> str:
    """Return a name of this start of the executive: its UTC second to the base of 36.

    Servers of skills journal the ids of goals, which begin with the task's. So a task's id must never come
    again, not even after a restart that has forgotten how far the numbers were.
    """
    number, text = int(utc), ""
    while number:
        number, digit = divmod(number, len(_DIGITS))
        text = _DIGITS[digit] + text
    return text or "0"


class TaskBook:
    """Every task that is known, by its id: ``<kind>-<start>-<number>``, such as ``fetch-tlr5k2-0001``.

    Args:
        start: name of this start of the executive (``start_id``); empty in lockstep, where a run has one
            start only and ids are ``fetch-0001``.
    """

    def __init__(self, start: str = "") -> None:
        self._start = start
        self._numbered = 0
        self._tasks: dict[str, TaskStatus] = {}
        self._waiting: deque[tuple[str, Asked]] = deque()
        self._by_client: dict[str, tuple[Asked, str]] = {}

    def accept(self, asked: Asked, accepted_at: float) -> TaskAnswer:
        """Queue a request and answer with its id, or say why it can't be queued.

        The same document under the same client's id is not queued again; its answer is the first one's.
        """
        known = self._by_client.get(asked.client_id)
        if known is not None:
            return _again(asked, *known)
        if len(self._waiting) >= MAX_WAITING:
            full = Problem(
                path="(the document)",
                expected=f"at most {MAX_WAITING} tasks waiting; ask again later",
                found=f"{len(self._waiting)} waiting",
            )
            return TaskAnswer(accepted=False, problems=(full,), client_id=asked.client_id)
        self._numbered += 1
        parts = (asked.kind.name, self._start, f"{self._numbered:04d}")
        task = "-".join(part for part in parts if part)
        self._tasks[task] = TaskStatus(
            task=task,
            kind=asked.kind.name,
            request=asked.document,
            state=TaskState.QUEUED,
            accepted_at=accepted_at,
        )
        self._waiting.append((task, asked))
        if asked.client_id:
            self._by_client[asked.client_id] = (asked, task)
        return TaskAnswer(accepted=True, task=task, client_id=asked.client_id)

    def take(self) -> tuple[str, Asked] | None:
        """Return the task whose turn it is, out of the queue; None when none waits."""
        return self._waiting.popleft() if self._waiting else None

    def withdraw(self, task: str) -> bool:
        """Take a task out of the queue; False when it does not wait there."""
        before = len(self._waiting)
        self._waiting = deque(each for each in self._waiting if each[0] != task)
        return len(self._waiting) < before

    @property
    def waiting(self) -> tuple[str, ...]:
        """The ids of those that wait, in their order."""
        return tuple(task for task, _ in self._waiting)

    def get(self, task: str) -> TaskStatus | None:
        """Return a task, or None when it is not known (any more)."""
        return self._tasks.get(task)

    def all(self) -> tuple[TaskStatus, ...]:
        """Return all that is known, oldest first."""
        return tuple(self._tasks.values())

    def begin(self, task: str, now: RobotTime | None) -> TaskStatus:
        """Note that the task runs."""
        return self._change(task, {"state": TaskState.RUNNING, "started": now})

    def move_on(
        self, task: str, state: TaskState, progress: Progress, now: RobotTime | None = None
    ) -> TaskStatus:
        """Note where the task stands and how far it is; ``now`` is its start if none was heard then."""
        started = self._tasks[task].started or now
        return self._change(task, {"state": state, "progress": progress, "started": started})

    def tried(self, task: str, tried: tuple[Attempt, ...]) -> TaskStatus:
        """Note what went wrong so far."""
        return self._change(task, {"tried": tried})

    def end(
        self, task: str, state: TaskState, now: RobotTime | None, failure: Failure | None = None
    ) -> TaskStatus:
        """Note how the task ended, and forget the oldest of those that ended long ago."""
        ended = self._change(task, {"state": state, "ended": now, "failure": failure})
        over = [each.task for each in self._tasks.values() if each.state.terminal]
        for old in over[: max(0, len(over) - KEPT)]:
            del self._tasks[old]
        self._by_client = {
            client_id: (asked, of) for client_id, (asked, of) in self._by_client.items() if of in self._tasks
        }
        return ended

    def _change(self, task: str, update: dict[str, object]) -> TaskStatus:
        self._tasks[task] = self._tasks[task].model_copy(update=update)
        return self._tasks[task]


def _again(asked: Asked, first: Asked, task: str) -> TaskAnswer:
    if asked.document == first.document:
        return TaskAnswer(accepted=True, task=task, client_id=asked.client_id)
    problem = Problem(path="id", expected="an id for each request", found=f"that of {task}, which asks else")
    return TaskAnswer(accepted=False, problems=(problem,), client_id=asked.client_id)
