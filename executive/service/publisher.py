"""What the executive tells: statuses, once they are on disk, and the tree, as it changes."""

from __future__ import annotations

import logging

from tandem.executive.ledger.port import Ledger
from tandem.executive.service.running.current_task import CurrentTask
from tandem.executive.service.running.timeline import Spans
from tandem.executive.service.running.tree_run import NO_NODE
from tandem.executive.service.tasks.task_book import TURN, TaskBook
from tandem.executive.service.tasks.task_log import TaskLog
from tandem.executive.service.tasks.task_queue import Waiting
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.tasks import (
    TASK_STATUS,
    TREE,
    TaskStatus,
    Timeline,
    TreeSnapshot,
    task_status,
)

_LOG = logging.getLogger(__name__)


class Publisher:
    """Tells everyone what happens to the tasks.

    Args:
        bus: where clients are.
        clocks: robot time of the spans.
        book: the tasks in memory; what is told of one is on disk first.
        ledger: the spans of earlier tasks.
    """

    def __init__(self, bus: Bus, clocks: Clocks, book: TaskBook, ledger: Ledger) -> None:
        self._bus, self._clocks, self._book, self._ledger = bus, clocks, book, ledger
        self.last = ""
        """The task that was told of last."""
        self.waits_for = ""
        """What the first of those that wait waits for."""
        self._first = ""
        self._log, self._spans = TaskLog(), Spans()
        self._last_tree = TreeSnapshot(task="", kind="", tick=0, root=NO_NODE).model_dump_json().encode()

    def tell(self, status: TaskStatus) -> None:
        """Publish a status once it is on disk."""
        self._book.keep()
        status = self._book.explained(status)
        self.last = status.task
        self._log.note(status)
        TASK_STATUS.publish(self._bus, status)
        task_status(status.task).publish(self._bus, status)

    def begin(self, turn: CurrentTask) -> None:
        """Go on with the spans of a task whose tree has just been built."""
        self._spans = Spans(self._book.entry(turn.task).memory.spans)

    def changed(self, turn: CurrentTask) -> None:
        """Tell of the task under way what has changed: its tree, its progress."""
        turn.remember()
        tree = turn.run.changed_tree()
        if tree is not None:
            self._last_tree = tree
            TREE.publish_written(self._bus, tree)
            now = self._clocks.robot()
            if now is not None:
                self._spans.see(turn.run.take_changed(), now)
        status = turn.progress()
        if status is not None:
            self.tell(status)

    def keep_spans(self, task: str) -> None:
        """Write down when which node ran, to be committed with the task's end."""
        memory = self._book.entry(task).memory
        spans = self._spans.end(self._clocks.robot())
        self._book.remember(task, memory.model_copy(update={"spans": spans}))

    def tell_first(self, first: Waiting | None) -> None:
        """Tell what the first of those that wait waits for, when that has changed."""
        now = ("", "") if first is None else (first.task, self._book.waits_for(first).removesuffix(TURN))
        before, was_held = self._first, self.waits_for
        if now == (before, was_held):
            return
        self._first, self.waits_for = now
        status = None if first is None else self._book.get(first.task)
        if status is not None and (self.waits_for or (was_held and before == status.task)):
            _LOG.info("a task waits", extra={"task": status.task, "waits_for": self.waits_for})
            self.tell(status)

    def tree(self, turn: CurrentTask | None) -> bytes:
        """Return the tree of the task under way as it is, or the last one: a ``TreeSnapshot`` in JSON."""
        return self._last_tree if turn is None else turn.run.tree()

    def timeline(self, task: str, turn: CurrentTask | None) -> Timeline:
        """Return when which node of a task ran."""
        if turn is not None and turn.task == task:
            return Timeline(task=task, spans=self._spans.all())
        entry = self._ledger.entry(task)
        return Timeline(task=task, spans=() if entry is None else entry.memory.spans)
