"""The table of what leads where: ``executive/service/tasks/task_book.py`` changes no state but by it."""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

from tandem.skills.ports.tasks import TaskState

_S = TaskState

LEADS_TO: Final = MappingProxyType(
    {
        _S.QUEUED: {
            _S.RUNNING: "its turn has come",
            _S.CANCELED: "cancelled before it began",
            _S.EXPIRED: "its latest start has passed",
            _S.REJECTED: "the request is no longer valid after a restart: the tasks or the site changed",
        },
        _S.RUNNING: {
            _S.PAUSING: "paused; its skills are coming to rest",
            _S.PAUSED: "paused with no skill moving, or waiting for an operator after a restart",
            _S.CANCELING: "cancelled; its skills are coming to rest",
            _S.SUCCEEDED: "its tree succeeded",
            _S.FAILED: "its tree or the hardware failed",
            _S.QUEUED: "a task with a higher priority took over, or the try was in vain; it runs later",
            _S.INTERRUPTED: "the executive ended, and the task is not to be resumed",
        },
        _S.PAUSING: {
            _S.PAUSED: "everything is at rest",
            _S.RUNNING: "resumed before everything was at rest",
            _S.CANCELING: "cancelled",
            _S.FAILED: "a skill did not come to rest, or the hardware is lost",
            _S.INTERRUPTED: "the executive ended, and the task is not to be resumed",
        },
        _S.PAUSED: {
            _S.RUNNING: "resumed or stepped",
            _S.CANCELING: "cancelled",
            _S.FAILED: "the hardware is lost",
            _S.INTERRUPTED: "the executive ended, and the task is not to be resumed",
        },
        _S.CANCELING: {
            _S.CANCELED: "everything is at rest",
            _S.FAILED: "a skill did not come to rest, or the hardware is lost",
            _S.INTERRUPTED: "abandoned while the hardware was silent, or the executive kept crashing",
        },
        _S.SUCCEEDED: {},
        _S.FAILED: {},
        _S.CANCELED: {},
        _S.EXPIRED: {},
        _S.REJECTED: {},
        _S.INTERRUPTED: {},
    }
)
"""Each state, where it leads, and why."""

FIRST: Final = TaskState.QUEUED
"""The state of a request that was accepted."""


class WrongTransitionError(RuntimeError):
    """A mistake in the program: a change that the table does not have."""

    def __init__(self, task: str, now: TaskState, then: TaskState) -> None:
        allowed = ", ".join(LEADS_TO[now]) or "nothing: it is final"
        super().__init__(f"{task}: {now} does not lead to {then}; it leads to {allowed}")


def check(task: str, now: TaskState, then: TaskState) -> None:
    """Raise ``WrongTransitionError`` unless the one state leads to the other, or they are the same."""
    if now is not then and then not in LEADS_TO[now]:
        raise WrongTransitionError(task, now, then)


def table() -> str:
    """Return it as a Markdown table, for the documentation."""
    rows = ["| state | leads to | when |", "| --- | --- | --- |"]
    for state, ways in LEADS_TO.items():
        rows += [f"| `{state}` | `{then}` | {when} |" for then, when in ways.items()]
        if not ways:
            rows.append(f"| `{state}` | | final |")
    return "\n".join(rows)
