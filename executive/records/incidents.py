"""What a black box is kept for: a task that failed, a stop that was set, a process that died."""

from __future__ import annotations

from tandem.executive.records.known import names_task
from tandem.executive.records.recording import Recorded
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.hearing import Ear
from tandem.skills.ports.keys import STOP_STATE
from tandem.skills.ports.message import read_leniently
from tandem.skills.ports.records import Cause
from tandem.skills.ports.tasks import TASK_STATUS, TaskState, TaskStatus

FRESH: float = 5.0
"""Robot seconds within which a task ended whose first status is its last: others are news of long ago."""
FAILED = frozenset((TaskState.FAILED, TaskState.INTERRUPTED))
PROCESS = "process/"


class Incidents:
    """Sees them in what is heard. Only statuses of tasks and of the stop are decoded.

    Args:
        ear: counts those that can't be read; one of its own, which nobody asks, unless given.
    """

    def __init__(self, ear: Ear | None = None) -> None:
        self._ear = Ear() if ear is None else ear
        self._open: dict[str, bool] = {}
        """Tasks that have not ended, and whether they are at work."""
        self._told: dict[str, None] = {}
        """Tasks whose failure was told: a status is said twice."""
        self._stopped = False
        self._there: frozenset[str] = frozenset()

    @property
    def task(self) -> str:
        """The task at work; empty if none is."""
        return next((task for task, at_work in self._open.items() if at_work), "")

    def hear(self, message: Recorded) -> Cause | None:
        """Return what a message says has gone wrong, or None."""
        if names_task(message.key):
            status = self._ear.read(message.key, TASK_STATUS.decode, message.payload)
            return None if status is None else self._task(status, message)
        if message.key == STOP_STATE.key:
            state = self._ear.read(message.key, _read_stop, message.payload)
            return None if state is None else self._stop(state, message)
        return None

    def look(self, alive: frozenset[str], at: Recorded | None) -> Cause | None:
        """Return which process has died since the last look, or None."""
        there = frozenset(name for name in alive if name.startswith(PROCESS))
        gone, self._there = self._there - there, there
        if not gone:
            return None
        names = ", ".join(sorted(name.removeprefix(PROCESS) for name in gone))
        words = f"the {names} process is gone" if len(gone) == 1 else f"the processes {names} are gone"
        return self._cause("death", words, at)

    def _task(self, status: TaskStatus, message: Recorded) -> Cause | None:
        task, known = status.task, status.task in self._open
        if not status.state.terminal:
            self._open[task] = status.started is not None and status.state is not TaskState.QUEUED
            return None
        self._open.pop(task, None)
        if status.state not in FAILED or task in self._told or not (known or _fresh(status, message)):
            return None
        self._told[task] = None
        if len(self._told) > 256:  # noqa: PLR2004 - far more than are told twice
            self._told.pop(next(iter(self._told)))
        why = "" if status.failure is None else f": {status.failure.kind}: {status.failure.message}"
        cause = self._cause("task", f"{task} {status.state}{why}", message)
        return cause.model_copy(update={"task": task})

    def _stop(self, state: StopState, message: Recorded) -> Cause | None:
        was, self._stopped = self._stopped, state.stopped
        if not state.stopped or was:
            return None
        reason = f": {state.reason}" if state.reason else ""
        return self._cause("stop", f"{state.by or 'somebody'} set the stop{reason}", message)

    def _cause(self, kind: str, words: str, at: Recorded | None) -> Cause:
        moment = {} if at is None else {"at": at.at, "stamp": at.stamp}
        return Cause.model_validate({"kind": kind, "words": words, "task": self.task, **moment})


def _fresh(status: TaskStatus, message: Recorded) -> bool:
    if status.ended is None or message.stamp is None:
        return False
    return status.ended.is_fresh(message.stamp, FRESH)


def _read_stop(payload: bytes) -> StopState:
    return read_leniently(StopState, payload)
