"""The executive: takes requests, keeps them, runs one at a time, and tells everyone what happens.

Loads nothing heavy (a test proves it), so that it is back in a blink after a crash.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from typing import Final

from executive.halt import Halt
from executive.leftovers import Leftovers
from executive.pictures import Album, Tries
from executive.pulse import Pulse
from executive.requests import Asked, Refused, read_request
from executive.run import Run
from executive.task_log import TaskLog
from executive.task_queue import TaskBook
from executive.verbs import Verbs
from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from skills.ports.failure import Failure, FailureKind
from skills.ports.keys import Topic
from skills.ports.message import Message
from skills.ports.site import Site
from skills.ports.tasks import (
    REQUEST,
    TASK_ANSWERS,
    TASK_CANCEL,
    TASK_INFO,
    TASK_LIST,
    TASK_PAUSE,
    TASK_RESUME,
    TASK_STATUS,
    TASK_STEP,
    TREE,
    TREE_NOW,
    ControlAnswer,
    ExecutiveInfo,
    Problem,
    Progress,
    TaskAnswer,
    TaskList,
    TaskState,
    TaskStatus,
    TreeNode,
    TreeSnapshot,
)
from trees.clients import Clients
from trees.context import TreeContext
from trees.knowledge import Knowledge
from trees.task import TaskType

NAME: Final = "executive"
"""What it is announced as; goals of skills come to rest when this name is gone."""
PROGRESS_STEP: Final = 0.01
"""A status is published when the fraction has grown by this much."""
AT_ONCE: Final = 64
"""Documents that one step reads; the rest waits for the next."""

_LOG = logging.getLogger(__name__)
_NO_TREE: Final = TreeNode(path="idle", name="idle", kind="action", type="Nothing")


class Executive:
    """The service, as a node.

    Args:
        bus: where clients and skills are.
        clocks: robot time for trees, UTC for when a request came.
        site: what is known beforehand.
        tasks: the kinds of request, by name (``trees.registry.discover()``).
        start: part of each task's id (``executive.task_queue.start_id``); empty in lockstep.
        version: of this program, told to who asks.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        site: Site,
        tasks: Mapping[str, TaskType[Message]],
        *,
        start: str = "",
        version: str = "",
    ) -> None:
        self.knowledge = Knowledge(bus, clocks, site)
        self.clients = Clients(bus, clocks, NAME)
        self.book = TaskBook(start)
        self._bus, self._clocks, self._kinds, self._version = bus, clocks, dict(tasks), version
        self._running: Run | None = None
        self._last_tree = TreeSnapshot(task="", kind="", tick=0, root=_NO_TREE)
        self._puts = bus.subscribe(REQUEST)
        self._asks = bus.serve(REQUEST)
        self._lists = bus.serve(TASK_LIST.key)
        self._infos = bus.serve(TASK_INFO.key)
        self._trees = bus.serve(TREE_NOW.key)
        takes = {
            TASK_CANCEL.key: self._cancel,
            TASK_PAUSE.key: lambda task: self._hold(task, Run.pause),
            TASK_RESUME.key: lambda task: self._hold(task, Run.resume),
            TASK_STEP.key: lambda task: self._hold(task, Run.step_leaf),
        }
        self._verbs, self._album = Verbs(bus, takes), Album(bus)
        self._desks = (self._asks, self._lists, self._infos, self._trees, self._verbs, self._album)
        self._tries: list[Tries] = []  # of the running task, and of those before whose picture is under way
        self._pulse, self._task_log = Pulse(bus, clocks), TaskLog()
        self._leftovers = Leftovers(bus, clocks, self.clients, self.knowledge)
        self._unread: list[tuple[bytes, Callable[[bytes], None] | None]] = []
        self._closed = False
        bus.announce(NAME)

    @property
    def name(self) -> str:
        """For logs."""
        return NAME

    @property
    def idle(self) -> bool:
        """Whether no task runs or waits."""
        return self._running is None and not self.book.waiting

    def step(self) -> bool:
        """Answer whoever asks, then move the running task on."""
        self._take_requests()
        self._verbs.step()
        self._move_on()
        self._note_tries()
        self._album.step()
        self._answer_questions()
        running = "" if self._running is None else self._running.context.task
        self._pulse.step(running, len(self.book.waiting))
        next_one = self._running is None and bool(self.book.waiting) and self._leftovers.none
        return bool(self._unread) or next_one

    def close(self) -> None:
        """Stop the tree, whose leaves cancel their goals, and leave. Closing twice is allowed."""
        if self._closed:
            return
        self._closed = True
        for task in self.book.waiting:
            self._withdraw(task)
        if self._running is not None:
            self._cancel_running(self._running)
        for end in (self._puts, *self._desks):
            end.close()
        self.clients.close()
        self.knowledge.close()

    # Requests.

    def _take_requests(self) -> None:
        self._unread.extend((sample.payload, None) for sample in self._puts.drain())
        self._unread.extend((request.payload, request.reply) for request in self._asks.drain())
        now, self._unread = self._unread[:AT_ONCE], self._unread[AT_ONCE:]
        for payload, reply in now:
            answer = self._consider(payload)
            if reply is not None:
                reply(answer.model_dump_json().encode())
            TASK_ANSWERS.publish(self._bus, answer)
            status = self.book.get(answer.task)
            if status is not None and status.state is TaskState.QUEUED:
                self._tell(status)

    def _consider(self, payload: bytes) -> TaskAnswer:
        try:
            asked = read_request(payload, self._kinds, self.knowledge.site)
        except Exception as error:  # noqa: BLE001 - a check's mistake costs its request, not the service
            _LOG.exception("a request's check raised")
            text = f"a request that can be checked; its check raised {type(error).__name__}"
            asked = Refused((Problem(path="(the document)", expected=text),))
        if isinstance(asked, Refused):
            return TaskAnswer(accepted=False, problems=asked.problems, client_id=asked.client_id)
        return self.book.accept(asked, self._clocks.utc())

    def _cancel(self, task: str) -> ControlAnswer:
        status = self.book.get(task)
        if status is not None and status.state is TaskState.QUEUED:
            self._withdraw(task)
            return ControlAnswer(accepted=True)
        run = self._running_as(status, task)
        if isinstance(run, ControlAnswer):
            return run
        if run.ending is not None and not run.canceling:
            return ControlAnswer(accepted=False, reason=f"the task is about to end: {run.ending.state}")
        self._cancel_running(run)
        return ControlAnswer(accepted=True)

    def _hold(self, task: str, verb: Callable[[Run], str]) -> ControlAnswer:
        status = self.book.get(task)
        if status is not None and status.state is TaskState.QUEUED:
            return ControlAnswer(accepted=False, reason="the task has not begun")
        run = self._running_as(status, task)
        if isinstance(run, ControlAnswer):
            return run
        why = verb(run)
        self._tell_progress(run)
        return ControlAnswer(accepted=not why, reason=why)

    def _running_as(self, status: TaskStatus | None, task: str) -> Run | ControlAnswer:
        """Return the run of a task that has begun, or why there is none."""
        if status is None:
            return ControlAnswer(accepted=False, reason=f"no task {task[:80]!r} is known")
        if status.state.terminal or self._running is None:
            return ControlAnswer(accepted=False, reason=f"the task has ended: {status.state}")
        return self._running

    def _withdraw(self, task: str) -> None:
        self.book.withdraw(task)
        self._tell(self.book.end(task, TaskState.CANCELED, self._clocks.robot()))

    def _cancel_running(self, run: Run) -> None:
        run.cancel()
        self._tell_progress(run)
        self._show(run)

    # The running task.

    def _move_on(self) -> None:
        if self._running is None:
            self._leftovers.step()
            if self._leftovers.none:
                self._start_next()
        run = self._running
        if run is None:
            return
        run.step()
        self._show(run)
        self._tell_progress(run)
        if run.ended is not None:
            self._running = None
            self._note_tries()
            ended = self.book.end(run.context.task, run.ended.state, self._clocks.robot(), run.ended.failure)
            self._tell(ended)

    def _start_next(self) -> None:
        turn = self.book.take()
        if turn is None:
            return
        task, asked = turn
        self._tell(self.book.begin(task, self._clocks.robot()))
        try:
            self._running = self._build(task, asked)
        except Exception as error:  # noqa: BLE001 - a builder's mistake costs its task, not the service
            _LOG.exception("a tree could not be built", extra={"task": task})
            what = f"{type(error).__name__}: {error}"
            text = f"building the tree raised {what}; the executive's log has the trace"
            failure = Failure(kind=FailureKind.SKILL_CRASHED, message=text, where=asked.kind.name)
            self._tell(self.book.end(task, TaskState.FAILED, self._clocks.robot(), failure))

    def _build(self, task: str, asked: Asked) -> Run:
        context = TreeContext(task, self.clients, self.knowledge, self._clocks)
        root = asked.kind.build(asked.request, context)
        self._tries.append(Tries(self._bus, self._clocks, context, self._album))
        halt = Halt(self._bus, self._clocks)
        return Run(context, root, asked.kind.name, clocks=self._clocks, halt=halt, ticked=self._pulse.ticked)

    def _tell(self, status: TaskStatus) -> None:
        self._task_log.note(status)
        TASK_STATUS.publish(self._bus, status)
        task_status(status.task).publish(self._bus, status)

    def _tell_progress(self, run: Run) -> None:
        status = self.book.get(run.context.task)
        if status is None:
            return
        if status.state is not run.state or _worth_telling(status.progress, run.progress):
            now = self._clocks.robot()
            self._tell(self.book.move_on(run.context.task, run.state, run.progress, now))

    def _note_tries(self) -> None:
        for tries in self._tries:
            if not tries.step():
                continue
            task = tries.context.task
            status = self.book.get(task)
            if status is not None:
                # An ended task is told once; who asks for the list later sees the picture that came late.
                status = self.book.tried(task, tries.tried)
                if not status.state.terminal:
                    self._tell(status)
        running = None if self._running is None else self._running.context
        self._tries = [each for each in self._tries if each.context is running or each.pending]

    def _show(self, run: Run) -> None:
        tree = run.changed_tree()
        if tree is not None:
            self._last_tree = tree
            TREE.publish(self._bus, tree)

    # Questions.

    def _answer_questions(self) -> None:
        for request in self._lists.drain():
            request.reply(TaskList(tasks=self.book.all()).model_dump_json().encode())
        for request in self._infos.drain():
            request.reply(self._info().model_dump_json().encode())
        for request in self._trees.drain():
            tree = self._last_tree if self._running is None else self._running.tree()
            request.reply(tree.model_dump_json().encode())

    def _info(self) -> ExecutiveInfo:
        return ExecutiveInfo(
            name=NAME,
            version=self._version,
            tasks=tuple(self._kinds),
            running="" if self._running is None else self._running.context.task,
            queued=len(self.book.waiting),
        )


def task_status(task: str) -> Topic[TaskStatus]:
    """Return the topic of one task's status."""
    return Topic(f"task/{task}/status", TaskStatus)


def _worth_telling(told: Progress, now: Progress) -> bool:
    grown = now.fraction - told.fraction
    return now.phase != told.phase or grown >= PROGRESS_STEP or (now.fraction == 1.0 and grown > 0.0)
