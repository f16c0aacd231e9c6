"""What can be asked of an executive: requests, questions and verbs, each a talk that either client drives."""

from __future__ import annotations

import json
import uuid
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final, Literal

from pydantic import JsonValue

from tandem.executive.client.errors import RefusedError, RejectedError, UnknownTaskError
from tandem.executive.client.talks import Sent, Talk, Talks
from tandem.executive.render.failure_words import chosen, explain
from tandem.executive.security.identity import Identity
from tandem.skills.ports.actions.perception import PICTURE, AskView
from tandem.skills.ports.hardware import Stop, StopRelease, StopState
from tandem.skills.ports.keys import DESCRIPTION, STOP, STOP_RELEASE, Nothing, Service
from tandem.skills.ports.message import Message
from tandem.skills.ports.records import TASK_RECORDS, AskRecords, Records
from tandem.skills.ports.reflex import ReflexState, ReflexSwitch, reflex_switch
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import (
    REQUEST,
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_HISTORY,
    TASK_INFO,
    TASK_KINDS,
    TASK_LIST,
    TASK_PAUSE,
    TASK_PICTURE,
    TASK_REPRIORITISE,
    TASK_RESUME,
    TASK_SITE,
    TASK_STEP,
    TASK_TIMELINE,
    TREE_NOW,
    AnswerQuestion,
    AskHistory,
    AskPicture,
    AskTasks,
    Breakpoint,
    CancelTask,
    ControlAnswer,
    ExecutiveInfo,
    ForceNode,
    History,
    NameTask,
    Reprioritise,
    StepTask,
    TaskAnswer,
    TaskKinds,
    TaskList,
    TaskStatus,
    Timeline,
    TreeSnapshot,
    by_client,
)

By = Literal["leaf", "tick"]
When = Literal["before", "after"]
Forced = Literal["SUCCESS", "FAILURE"] | None
OF_THE_RUNNING: Final = frozenset({"pause", "resume", "step"})
"""Verbs whose task need not be named. Of the others an empty name by mistake must not meet what runs."""
Request = Mapping[str, JsonValue] | Message
"""A request's document, or its model such as ``tandem.trees.tasks.fetch.FetchRequest``."""


def new_id() -> str:
    """Return an id for a request, such as nobody else has."""
    return uuid.uuid4().hex


@dataclass(frozen=True)
class Questions:
    """All calls raise the errors of ``tandem.executive.client.errors``.

    Args:
        talks: asks until there is an answer.
        new_id: makes an id for a request that has none.
        identity: whose key is shown, where the router asks for one; the holder asks in its own name.
    """

    talks: Talks
    new_id: Callable[[], str] = new_id
    identity: Identity | None = None

    def submit(self, request: Request, client_id: str) -> Talk[str]:
        """Send a request and return its task's id; RejectedError when it is not taken."""
        document = self._with_id(request, client_id)
        answer = yield from self.talks.answer(self._own(REQUEST), json.dumps(document).encode(), TaskAnswer)
        if not answer.accepted:
            raise RejectedError(answer.problems)
        return answer.task

    def info(self) -> Talk[ExecutiveInfo]:
        """Return who serves."""
        return self.talks.ask(TASK_INFO, Nothing())

    def kinds(self) -> Talk[TaskKinds]:
        """Return the kinds of task, with the schema of each one's request."""
        return self.talks.ask(TASK_KINDS, Nothing())

    def site(self) -> Talk[Site]:
        """Return the place that the robot works in."""
        return self.talks.ask(TASK_SITE, Nothing())

    def description(self) -> Talk[RobotDescription]:
        """Return who the robot is, as its hardware says."""
        return self.talks.ask(DESCRIPTION, Nothing())

    def stop(self, by: str, reason: str) -> Talk[StopState]:
        """Set the hardware's stop."""
        return self.talks.ask(STOP, Stop(by=by, reason=reason))

    def release(self, by: str, reason: str) -> Talk[StopState]:
        """Release the hardware's stop."""
        return self.talks.ask(STOP_RELEASE, StopRelease(by=by, reason=reason))

    def tasks(self) -> Talk[tuple[TaskStatus, ...]]:
        """Return the tasks that have not ended and the last that have, oldest first."""
        asked, pages = AskTasks(), list[TaskList]()
        while True:
            pages.append((yield from self.talks.ask(TASK_LIST, asked)))
            if not pages[-1].more:
                return tuple(status for page in reversed(pages) for status in page.tasks)
            asked = AskTasks(before=pages[-1].more)

    def status(self, task: str) -> Talk[TaskStatus]:
        """Return a task as it stands; UnknownTaskError when there is none of this id."""
        found = yield from self.history(AskHistory(task=task, limit=1))
        if not task or not found.tasks:
            raise UnknownTaskError(task)
        return found.tasks[0]

    def timeline(self, task: str) -> Talk[Timeline]:
        """Return when which node of a task ran."""
        return self.talks.ask(TASK_TIMELINE, NameTask(task=task))

    def records(self, task: str) -> Talk[Records]:
        """Return the records that are kept."""
        return self.talks.ask(TASK_RECORDS, AskRecords(task=task))

    def history(self, asked: AskHistory) -> Talk[History]:
        """Return tasks out of the ledger, newest first."""
        return self.talks.ask(TASK_HISTORY, asked)

    def tree(self) -> Talk[TreeSnapshot]:
        """Return the running task's tree, or the last one's."""
        return self.talks.ask(TREE_NOW, Nothing())

    def why(self, task: str) -> Talk[str]:
        """Return in words why a task failed; the last that failed unless named."""
        if task:
            return explain((yield from self.status(task)))
        status = chosen((yield from self.tasks()), "")
        return "no task has failed, and none is running" if status is None else explain(status)

    def picture(self, task: str, number: str) -> Talk[bytes]:
        """Return the picture of an attempt as JPEG; empty when it is not kept (any more)."""
        asked = AskPicture(task=task, picture=number).model_dump_json().encode()
        return (yield from self.talks.raw(TASK_PICTURE, asked)) or b""

    def camera(self, name: str = "") -> Talk[bytes]:
        """Return what a camera sees now as JPEG; empty when no picture comes."""
        asked = AskView(camera=name).model_dump_json().encode() if name else b""
        return (yield from self.talks.raw(PICTURE, asked)) or b""

    def switch_reflex(self, reflex: str, by: str, *, on: bool) -> Talk[ReflexState]:
        """Switch a reflex on or off."""
        return self.talks.ask(reflex_switch(reflex), ReflexSwitch(on=on, by=by))

    def cancel(self, task: str) -> Talk[str]:
        """Cancel a task."""
        requester = self.identity is not None and self.identity.role() == "requester"
        key = self._own(TASK_CANCEL.key) if requester else TASK_CANCEL.key
        service = Service(key, TASK_CANCEL.asked, TASK_CANCEL.answered)
        return self._verb("cancel", service, task, lambda named: CancelTask(task=named))

    def pause(self, task: str) -> Talk[str]:
        """Pause a task."""
        return self._verb("pause", TASK_PAUSE, task, _name)

    def resume(self, task: str) -> Talk[str]:
        """Go on with a task."""
        return self._verb("resume", TASK_RESUME, task, _name)

    def step(self, task: str, by: By) -> Talk[str]:
        """Go on with a task by a leaf or a tick."""
        return self._verb("step", TASK_STEP, task, lambda named: StepTask(task=named, by=by))

    def abandon(self, task: str) -> Talk[str]:
        """Give up waiting for a cancelled task to come to rest."""
        return self._verb("abandon", TASK_ABANDON, task, _name)

    def reprioritise(self, task: str, priority: int) -> Talk[str]:
        """Change the priority of a queued task."""
        return self._verb(
            "reprioritise",
            TASK_REPRIORITISE,
            task,
            lambda named: Reprioritise(task=named, priority=priority),
        )

    def answer(self, task: str, answer: str) -> Talk[str]:
        """Answer the question that a task's tree has put."""
        return self._verb(
            "answer", TASK_ANSWER, task, lambda named: AnswerQuestion(task=named, answer=answer)
        )

    def breakpoint(self, asked: Breakpoint) -> Talk[str]:
        """Have a task pause at a node, or no longer."""
        return self._verb("breakpoint", TASK_BREAKPOINT, asked.task, lambda _: asked)

    def force(self, asked: ForceNode) -> Talk[str]:
        """Have a node end so without its work, for a test run, or no longer."""
        return self._verb("force", TASK_FORCE, asked.task, lambda _: asked)

    def _verb(
        self, verb: str, service: Service[Sent, ControlAnswer], task: str, asked: Callable[[str], Sent]
    ) -> Talk[str]:
        """Ask it of a task, of the running one unless one is named; return its id."""
        running = verb in OF_THE_RUNNING and not task
        named = (yield from self.info()).running if running else task
        if running and not named:
            raise RefusedError(verb, task, "no task is running")
        answer = yield from self.talks.ask(service, asked(named))
        if not answer.accepted:
            raise RefusedError(verb, named, answer.reason)
        return named

    def _own(self, key: str) -> str:
        """Return the key at which the holder of a key asks in its own name."""
        return key if self.identity is None else by_client(self.identity.name, key)

    def _with_id(self, request: Request, client_id: str) -> dict[str, JsonValue]:
        body = request.model_dump(mode="json") if isinstance(request, Message) else dict(request)
        body["id"] = client_id or body.get("id") or self.new_id()
        return body


def _name(task: str) -> NameTask:
    return NameTask(task=task)
