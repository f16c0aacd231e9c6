"""What can be asked of an executive: requests, questions and verbs, each a talk that either client drives."""

from __future__ import annotations

import json
import uuid
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from pydantic import JsonValue

from executive.client.errors import RefusedError, RejectedError, UnknownTaskError
from executive.client.talks import Sent, Talk, Talks
from executive.why import chosen, explain
from skills.ports.keys import Nothing, Service
from skills.ports.message import Message
from skills.ports.tasks import (
    REQUEST,
    TASK_CANCEL,
    TASK_INFO,
    TASK_LIST,
    TASK_PAUSE,
    TASK_PICTURE,
    TASK_RESUME,
    TASK_STEP,
    TREE_NOW,
    AskPicture,
    CancelTask,
    ControlAnswer,
    ExecutiveInfo,
    NameTask,
    StepTask,
    TaskAnswer,
    TaskStatus,
    TreeSnapshot,
)

NAMED: Final = frozenset({"cancel"})
"""Verbs whose task must be named: an empty name by mistake must not end what happens to run."""
Request = Mapping[str, JsonValue] | Message
"""A request's document, or its model such as ``trees.tasks.fetch.FetchRequest``."""


def new_id() -> str:
    """Return an id for a request, such as nobody else has."""
    return uuid.uuid4().hex


@dataclass(frozen=True)
class Questions:
    """Whoever is asked raises what ``executive.client.errors`` says.

    Args:
        talks: asks until there is an answer.
        new_id: makes an id for a request that has none.
    """

    talks: Talks
    new_id: Callable[[], str] = new_id

    def submit(self, request: Request, client_id: str) -> Talk[str]:
        """Send a request and return its task's id; RejectedError when it is not taken."""
        document = self._with_id(request, client_id)
        answer = yield from self.talks.answer(REQUEST, json.dumps(document).encode(), TaskAnswer)
        if not answer.accepted:
            raise RejectedError(answer.problems)
        return answer.task

    def info(self) -> Talk[ExecutiveInfo]:
        """Return who serves."""
        return self.talks.ask(TASK_INFO, Nothing())

    def tasks(self) -> Talk[tuple[TaskStatus, ...]]:
        """Return all tasks that the executive remembers, oldest first."""
        return (yield from self.talks.ask(TASK_LIST, Nothing())).tasks

    def status(self, task: str) -> Talk[TaskStatus]:
        """Return a task as it stands; UnknownTaskError when there is none of this id."""
        for status in (yield from self.tasks()):
            if status.task == task:
                return status
        raise UnknownTaskError(task)

    def tree(self) -> Talk[TreeSnapshot]:
        """Return the running task's tree, or the last one's."""
        return self.talks.ask(TREE_NOW, Nothing())

    def why(self, task: str) -> Talk[str]:
        """Return in words why a task failed; the last that failed unless named."""
        status = chosen((yield from self.tasks()), task)
        if status is not None:
            return explain(status)
        if task:
            raise UnknownTaskError(task)
        return "no task has failed, and none is running"

    def picture(self, task: str, number: str) -> Talk[bytes]:
        """Return the picture of an attempt as JPEG; empty when it is not kept (any more)."""
        asked = AskPicture(task=task, picture=number).model_dump_json().encode()
        return (yield from self.talks.raw(TASK_PICTURE, asked)) or b""

    def cancel(self, task: str) -> Talk[str]:
        """Cancel a task."""
        return self._verb("cancel", TASK_CANCEL, task, lambda named: CancelTask(task=named))

    def pause(self, task: str) -> Talk[str]:
        """Pause a task."""
        return self._verb("pause", TASK_PAUSE, task, _name)

    def resume(self, task: str) -> Talk[str]:
        """Go on with a task."""
        return self._verb("resume", TASK_RESUME, task, _name)

    def step(self, task: str) -> Talk[str]:
        """Go on with a task by a leaf."""
        return self._verb("step", TASK_STEP, task, lambda named: StepTask(task=named))

    def _verb(
        self, verb: str, service: Service[Sent, ControlAnswer], task: str, asked: Callable[[str], Sent]
    ) -> Talk[str]:
        """Ask it of a task, of the running one unless one is named; return its id."""
        running = verb not in NAMED and not task
        named = (yield from self.info()).running if running else task
        if running and not named:
            raise RefusedError(verb, task, "no task is running")
        answer = yield from self.talks.ask(service, asked(named))
        if not answer.accepted:
            raise RefusedError(verb, named, answer.reason)
        return named

    def _with_id(self, request: Request, client_id: str) -> dict[str, JsonValue]:
        body = request.model_dump(mode="json") if isinstance(request, Message) else dict(request)
        body["id"] = client_id or body.get("id") or self.new_id()
        return body


def _name(task: str) -> NameTask:
    return NameTask(task=task)
