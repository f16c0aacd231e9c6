"""What a client raises; all of it is a ``ClientError``.

ClientError
├── NotConnectedError    no router answers there, or no executive behind it
├── OtherVersionError    the answer is none that this client understands
├── DeclinedError        the question was not taken: too often, too large, or not as it should be
├── RejectedError        the request was not taken; ``problems`` say where and why
├── RefusedError         a verb (cancel, pause, ...) was not taken; ``reason`` says why
├── UnknownTaskError     the executive knows no such task (any more)
├── TimedOutError        the task has not ended in the time that was allowed; it goes on
└── TaskFailedError      ``run``'s task ended otherwise than well; ``status`` has the whole of it
"""

from __future__ import annotations

from tandem.skills.ports.problems import Problem
from tandem.skills.ports.tasks import TaskStatus


class ClientError(Exception):
    """Something that was asked for did not come about; the message says what, and what to do."""


class NotConnectedError(ClientError):
    """Nobody answers: no router at the endpoint, or no executive for this robot."""


class OtherVersionError(ClientError):
    """An answer came that does not fit its model: the other program is of another version."""


class DeclinedError(ClientError):
    """A question that was not taken, again and again.

    Args:
        key: where it was asked.
        reason: the answer's own words: why it was refused.
    """

    def __init__(self, key: str, reason: str) -> None:
        self.key, self.reason = key, reason
        super().__init__(f"{key} was declined: {reason}")


class RejectedError(ClientError):
    """A request that was not taken.

    Args:
        problems: each place in the document, what was expected there and what was found.
    """

    def __init__(self, problems: tuple[Problem, ...]) -> None:
        self.problems = problems
        lines = (
            f"{problem.path}: expected {problem.expected}"
            + (f", found {problem.found}" if problem.found else "")
            for problem in problems
        )
        super().__init__("\n  ".join(("the request was rejected:", *lines)))


class RefusedError(ClientError):
    """A verb that was not taken.

    Args:
        verb: what was asked.
        task: of which task.
        reason: why not, in the executive's words.
    """

    def __init__(self, verb: str, task: str, reason: str) -> None:
        self.verb, self.task, self.reason = verb, task, reason
        super().__init__(f"{verb} of {task or 'the running task'} was refused: {reason}")


class UnknownTaskError(ClientError):
    """No such task is known (any more)."""

    def __init__(self, task: str) -> None:
        self.task = task
        super().__init__(f"unknown task {task!r}; `tasks()` returns the known ones")


class TimedOutError(ClientError):
    """A task that has not ended in time. It goes on; cancel it if it should not."""

    def __init__(self, task: str, seconds: float) -> None:
        self.task, self.seconds = task, seconds
        super().__init__(f"{task} has not ended within {seconds:g} s; it keeps running unless you cancel it")


class TaskFailedError(ClientError):
    """A task that ended FAILED, CANCELED, or in another way that is not SUCCEEDED.

    Args:
        status: its last status, with the failure and what was tried.
    """

    def __init__(self, status: TaskStatus) -> None:
        self.status = status
        failure = status.failure
        why = "" if failure is None else f": {failure.kind} at {failure.where}: {failure.message}"
        super().__init__(f"{status.task} ended {status.state}{why}")
