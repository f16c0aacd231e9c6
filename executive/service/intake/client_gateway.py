"""The executive's doors: who asks stands in the key.

A client with a key of its own asks at ``task/by/<name>/request``; the access rules let nobody else there.
So the name is true, although zenoh tells no receiver who sent. It is written into the document as ``by``:
with the document it is kept, so that it is known after a restart too. At ``task/by/<name>/cancel`` a client
cancels its own tasks.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from pydantic import JsonValue

from tandem.executive.ledger.sender import ANYBODY, BY_FIELD, asked_by
from tandem.skills.ports.endpoint import Call, Endpoint, endpoint
from tandem.skills.ports.problems import Problem, show
from tandem.skills.ports.tasks import TASK_CANCEL, CancelTask, ControlAnswer, TaskStatus, by_client


def with_sender(fields: Mapping[str, JsonValue], sender: str) -> dict[str, JsonValue] | Problem:
    """Return a document with its sender's name, or what is wrong: nobody says himself who he is."""
    if BY_FIELD in fields:
        expected = "no such field; the topic already names the client"
        return Problem(path=BY_FIELD, expected=expected, found=show(fields[BY_FIELD]))
    return dict(fields) if sender == ANYBODY else {BY_FIELD: sender, **fields}


def cancel_of_own(
    find: Callable[[str], TaskStatus | None],
    known: Callable[[CancelTask, str], CancelTask | ControlAnswer],
    cancel: Callable[[CancelTask], ControlAnswer],
) -> Endpoint:
    """Return the endpoint at which a named client cancels its own tasks, and nobody else's.

    Args:
        find: returns a task by its id.
        known: puts the task's id in place of the one that this client chose for its request.
        cancel: cancels one.
    """

    def take(call: Call[CancelTask]) -> ControlAnswer:
        asked = known(call.document, call.name)
        if isinstance(asked, ControlAnswer):
            return asked
        status = find(asked.task)
        if status is not None and asked_by(status.request) != call.name:
            reason = f"{status.task} belongs to another client than {call.name}; an operator may cancel it"
            return ControlAnswer(accepted=False, reason=reason)
        return cancel(asked)

    return endpoint(TASK_CANCEL, take, at=by_client("*", TASK_CANCEL.key))
