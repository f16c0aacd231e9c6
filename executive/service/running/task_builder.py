"""From a request to a task under way: checked against the robot that is there, its tree built, its run made.

What a kind of task does wrong here costs its task, and not the service.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from dataclasses import dataclass

from tandem.executive.ledger.port import Ledger
from tandem.executive.service.intake.request_parser import Asked
from tandem.executive.service.running.current_task import CurrentTask
from tandem.executive.service.running.emergency_stop import EmergencyStop
from tandem.executive.service.running.tree_run import Run
from tandem.executive.service.tasks.queue_holds import Holds
from tandem.executive.service.tasks.task_book import TaskBook
from tandem.executive.service.tasks.time_left import Expectation
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.problems import in_words
from tandem.trees.clients import Clients
from tandem.trees.context import TreeContext
from tandem.trees.dialogue import Dialogue
from tandem.trees.knowledge import Knowledge
from tandem.trees.task_notes import TaskNotes

_LOG = logging.getLogger(__name__)


@dataclass(eq=False)
class TaskBuilder:
    """Builds tasks, one at a time.

    Args:
        bus: where the hardware's stop is.
        clocks: robot time for trees.
        knowledge: what is known of robot and world.
        clients: of the skills.
        book: where each task stands there, and what it remembers.
        ledger: has the attempts of before, and how long past tasks took.
        holds: what a task has to wait for before its first tick.
        ticked: told how many seconds of the host each tick took.
    """

    bus: Bus
    clocks: Clocks
    knowledge: Knowledge
    clients: Clients
    book: TaskBook
    ledger: Ledger
    holds: Holds
    ticked: Callable[[float], None]

    def build(self, task: str, asked: Asked) -> CurrentTask | Failure:
        """Return the task, ready for its first tick, or why it fails."""
        told = self._unfit(task, asked)
        if told:
            return Failure(kind=FailureKind.INVALID_GOAL, message=told, where=asked.kind.name)
        try:
            return self._current(task, asked)
        except Exception as error:  # noqa: BLE001 - a builder's mistake costs its task, not the service
            _LOG.exception("could not build a tree", extra={"task": task})
            what = f"{type(error).__name__}: {error}"
            text = f"building the tree raised {what}; see the executive's log for the traceback"
            return Failure(kind=FailureKind.SKILL_CRASHED, message=text, where=asked.kind.name)

    def _unfit(self, task: str, asked: Asked) -> str:
        """Return why the robot can't do it, which may have said who it is after the request was accepted."""
        try:
            return in_words(asked.kind.against(asked.request, self.knowledge.description))
        except Exception as error:  # noqa: BLE001 - a kind's mistake costs its task, not the service
            _LOG.exception("checking a request against the robot raised", extra={"task": task})
            return f"the check of {asked.kind.name} raised {type(error).__name__}: {error}"

    def _current(self, task: str, asked: Asked) -> CurrentTask:
        context = self._context(task)
        root = asked.kind.tree(asked.request, context)
        run = Run(
            context,
            root,
            asked.kind,
            clocks=self.clocks,
            halt=EmergencyStop(self.bus, self.clocks),
            ticked=self.ticked,
            waits=lambda: self.holds.robot(asked.kind),
        )
        expectation = Expectation(self.ledger.past(asked.kind.name))
        follows = asked.kind.following(asked.request)
        return CurrentTask(run, asked, self.book, self.clocks, expectation, follows)

    def _context(self, task: str) -> TreeContext:
        """Return what the tree is built with: the hands that it was made for before a restart, its notes."""
        memory = self.book.entry(task).memory
        if self.knowledge.description is None and memory.hands:
            self.knowledge.assume_hands(memory.hands)
        memory = memory.model_copy(update={"hands": self.knowledge.hands})
        self.book.remember(task, memory)
        context = TreeContext(
            task,
            self.clients,
            self.knowledge,
            self.clocks,
            notes=TaskNotes(dict(memory.notes), self.ledger.attempts(task)),
            dialogue=Dialogue(before=dict(memory.answers)),
        )
        status = self.book.get(task)
        context.enter("", 0.0 if status is None else status.progress.fraction)
        return context
