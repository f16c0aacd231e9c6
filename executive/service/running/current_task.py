"""The task whose turn it is: its run, and what is told and written down of it."""

from __future__ import annotations

import logging
from dataclasses import dataclass
from typing import Final

from py_trees.common import Status

from tandem.executive.ledger.task_memory import Held, TaskMemory
from tandem.executive.service.intake.request_parser import Asked
from tandem.executive.service.running.tree_run import Run
from tandem.executive.service.tasks.resuming import QUESTION, How
from tandem.executive.service.tasks.task_book import TaskBook
from tandem.executive.service.tasks.time_left import Expectation
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.tasks import Progress, TaskState, TaskStatus
from tandem.skills.ports.whereabouts import Following

_LOG = logging.getLogger(__name__)
PROGRESS_STEP: Final = 0.01
"""A status is published when the fraction has grown by this much."""


@dataclass(eq=False)
class CurrentTask:
    """One task under way.

    Args:
        run: its tree at work.
        asked: what it was asked for, should it have to wait again.
        book: where it stands there.
        clocks: robot time, UTC.
        expectation: what is left of it, as a rule.
        follows: which robot it follows.
    """

    run: Run
    asked: Asked
    book: TaskBook
    clocks: Clocks
    expectation: Expectation
    follows: Following | None = None
    _began: float | None = None

    @property
    def task(self) -> str:
        """Its id."""
        return self.run.context.task

    def take_up(self, how: How) -> None:
        """Bring a run that has just been built to where it stood before a restart."""
        self._restore(self.book.entry(self.task).memory)
        if how == "cancel":
            self.run.cancel()
        elif how == "step":
            self.run.step_on(self.book.entry(self.task).memory.step)
        elif how != "go on":
            self.run.pause()
        if how == "ask":
            self.run.context.dialogue.question = QUESTION

    def _restore(self, memory: TaskMemory) -> None:
        run, gates = self.run, self.run.gates
        run.wind_down.stage = memory.winding
        for held in memory.breakpoints:
            node = gates.find(held.node)
            if isinstance(node, str):
                _LOG.warning("breakpoint ignored: %s", node, extra={"task": self.task})
            else:
                gates.hold(node, before=held.before)
        for path, status in memory.forced.items():
            node = gates.find(path)
            if isinstance(node, str):
                _LOG.warning("forced node ignored: %s", node, extra={"task": self.task})
            else:
                gates.force(node, Status(status))

    def remember(self) -> None:
        """Note what a restart must know of it; on disk after the book's ``keep``."""
        run, context = self.run, self.run.context
        ending = run.ending
        update: dict[str, object] = {
            "notes": dict(context.notes.all),
            "answers": {**context.dialogue.before, **context.dialogue.answers},
            "step": run.stepping,
            "go_on": run.told_to_go_on and run.ticks == 0,
            "winding": run.wind_down.stage,
            "given_up": ending.failure if ending and ending.state is TaskState.INTERRUPTED else None,
        }
        if not run.canceling:
            update["breakpoints"] = tuple(Held(node=node, before=before) for node, before in run.gates.held())
            update["forced"] = run.gates.forced()
        self.book.remember(self.task, self.book.entry(self.task).memory.model_copy(update=update))

    def progress(self) -> TaskStatus | None:
        """Return the task's status if there is something to be told; to be kept first."""
        run = self.run
        status = self.book.get(self.task)
        if status is None or run.ended is not None:
            return None
        now = run.context.seconds
        self.expectation.enter(run.progress.phase, now)
        facts: dict[str, object] = {
            "progress": run.progress,
            "running": run.running,
            "question": run.context.dialogue.question,
            "time_left": self.expectation.left(now),
            "started": status.started or self.clocks.robot(),
        }
        if status.state is not run.state or status.progress.phase != run.progress.phase:
            return self.book.change(self.task, run.state, **facts)
        told = (status.running, status.question)
        if _worth_telling(status.progress, run.progress) or told != (
            run.running,
            run.context.dialogue.question,
        ):
            return self.book.note(self.task, **facts)
        return None

    def end(self) -> TaskStatus:
        """Write down how it has ended, or that it waits again; it is on disk after the book's ``keep``."""
        ending = self.run.ended
        assert ending is not None, "it has not ended"
        if ending.state is TaskState.QUEUED:
            status = self.book.change(self.task, TaskState.QUEUED, running=(), time_left=None, question=None)
            self.book.put(self.task, self.asked)
            return status
        self.progress_at_end()
        if ending.state is TaskState.SUCCEEDED and self.book.entry(self.task).status.begun == 1:
            self.book.learn(self.asked.kind.name, self.expectation.lesson(self.run.context.seconds))
        return self.book.end(self.task, ending.state, self.clocks.robot(), ending.failure, self.run.result)

    def progress_at_end(self) -> None:
        """Note how far it came."""
        self.book.note(self.task, progress=self.run.progress)


def _worth_telling(told: Progress, now: Progress) -> bool:
    grown = now.fraction - told.fraction
    return now.phase != told.phase or grown >= PROGRESS_STEP or (now.fraction == 1.0 and grown > 0.0)
