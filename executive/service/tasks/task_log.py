"""The log of tasks: a line when a task is taken, begins, is held, and ends, with its id and why."""

from __future__ import annotations

import logging

from tandem.skills.ports.tasks import TaskState, TaskStatus

_LOG = logging.getLogger(__name__)


class TaskLog:
    """Logs a task when its state is another than before."""

    def __init__(self) -> None:
        self._states: dict[str, TaskState] = {}

    def note(self, status: TaskStatus) -> None:
        """Log it if there is something new."""
        if self._states.get(status.task) is status.state:
            return
        if status.state.terminal:
            self._states.pop(status.task, None)
        else:
            self._states[status.task] = status.state
        about: dict[str, object] = {"task": status.task, "state": str(status.state)}
        if status.failure is not None:
            failure = status.failure
            about |= {"kind": str(failure.kind), "where": failure.where, "why": failure.message}
        level = logging.WARNING if status.state is TaskState.FAILED else logging.INFO
        _LOG.log(level, "task ended" if status.state.terminal else "task", extra=about)
