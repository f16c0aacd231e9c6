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
            _S.EXPIRED: "its latest start went by",
            _S.REJECTED: "after a restart it no longer fits the kinds of task or the site",
        },
        _S.RUNNING: {
            _S.PAUSING: "paused; its skills are coming to rest",
            _S.PAUSED: "paused, with nothing that had to come to rest; or asked about after a restart",
            _S.CANCELING: "cancelled; its skills are coming to rest",
            _S.SUCCEEDED: "its tree succeeded",
            _S.FAILED: "its tree failed, or the hardware did",
            _S.QUEUED: "a task of a higher priority took over, or it was tried in vain; it is taken up again",
            _S.INTERRUPTED: "the executive ended in the middle, and it is not to be taken up again",
        },
        _S.PAUSING: {
            _S.PAUSED: "all is at rest",
            _S.RUNNING: "resumed before all was at rest",
            _S.CANCELING: "cancelled",
            _S.FAILED: "a skill did not come to rest, or the hardware is lost",
            _S.INTERRUPTED: "the executive ended in the middle, and it is not to be taken up again",
        },
        _S.PAUSED: {
            _S.RUNNING: "resumed, or stepped",
            _S.CANCELING: "cancelled",
            _S.FAILED: "the hardware is lost",
            _S.INTERRUPTED: "the executive ended in the middle, and it is not to be taken up again",
        },
        _S.CANCELING: {
            _S.CANCELED: "all is at rest",
            _S.FAILED: "a skill did not come to rest, or the hardware is lost",
            _S.INTERRUPTED: "abandoned: the hardware is silent; or the executive crashed at it repeatedly",
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
        allowed = ", ".join(LEADS_TO[now]) or "nothing: it is an end"
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
            rows.append(f"| `{state}` | | it is an end |")
    return "\n".join(rows)
