"""The verbs on a task: which state takes which, and what it does. docs/service.md has the table."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, Protocol, TypeVar, cast

from py_trees.common import Status

from tandem.executive.service.running.current_task import CurrentTask
from tandem.executive.service.running.endings import not_taken_up
from tandem.executive.service.running.tree_run import Run
from tandem.executive.service.tasks.resuming import GO_ON, QUESTION
from tandem.executive.service.tasks.task_book import TaskBook
from tandem.executive.service.verbs.verb_service import Verb
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import (
    TASK_ABANDON,
    TASK_ANSWER,
    TASK_BREAKPOINT,
    TASK_CANCEL,
    TASK_FORCE,
    TASK_PAUSE,
    TASK_REPRIORITISE,
    TASK_RESUME,
    TASK_STEP,
    AnswerQuestion,
    Breakpoint,
    CancelTask,
    ControlAnswer,
    ForceNode,
    Reprioritise,
    StepTask,
    TaskState,
    TaskStatus,
)

TAKEN: Final = ControlAnswer(accepted=True)


class _OfTask(Protocol):
    """The document of a verb on a task."""

    @property
    def task(self) -> str: ...


M = TypeVar("M", bound=Message)


class Control:
    """Takes the verbs.

    Args:
        book: all tasks.
        clocks: robot time.
        turn: returns the task under way, if any.
        tell: puts a status on disk and publishes it.
    """

    def __init__(
        self,
        book: TaskBook,
        clocks: Clocks,
        turn: Callable[[], CurrentTask | None],
        tell: Callable[[TaskStatus], None],
    ) -> None:
        self._book, self._clocks, self._current, self._tell = book, clocks, turn, tell
        self.changed: Callable[[CurrentTask], None] = lambda _: None
        """Called after a verb has changed the task under way."""

    def verbs(self) -> tuple[Verb[Message], ...]:
        """Return all of them."""
        made = (
            Verb(TASK_CANCEL, self.cancel),
            Verb(TASK_PAUSE, lambda asked: self._hold(asked.task, Run.pause)),
            Verb(TASK_RESUME, lambda asked: self._hold(asked.task, Run.resume)),
            Verb(TASK_STEP, self._step),
            Verb(TASK_ABANDON, lambda asked: self._hold(asked.task, Run.abandon)),
            Verb(TASK_REPRIORITISE, self.reprioritise),
            Verb(TASK_ANSWER, self.answer),
            Verb(TASK_BREAKPOINT, self.breakpoint),
            Verb(TASK_FORCE, self.force),
        )
        # One list of verbs with documents of different models; a verb reads its own.
        return tuple(self._by_any_id(each) for each in cast("tuple[Verb[Message], ...]", made))

    def of_client(self, asked: M, by: str | None = None) -> M | ControlAnswer:
        """Return a verb's document with the task's own id in place of the ``id`` that its client chose.

        Args:
            asked: what a client has sent; its model has a field ``task``.
            by: the client whose ids count; None: anybody's.
        """
        name = cast("_OfTask", asked).task
        found = self._book.named(name, by)
        if len(found) > 1:
            return _refused(f"{len(found)} requests have the id {name[:80]!r}; name one: {', '.join(found)}")
        return asked.model_copy(update={"task": found[0]}) if found else asked

    def _by_any_id(self, verb: Verb[Message]) -> Verb[Message]:
        def take(asked: Message) -> ControlAnswer:
            known = self.of_client(asked)
            return known if isinstance(known, ControlAnswer) else verb.take(known)

        return Verb(verb.service, take)

    def cancel(self, asked: CancelTask) -> ControlAnswer:
        """Take it out of the queue, or bring it to rest."""
        status = self._book.get(asked.task)
        if status is not None and status.state is TaskState.QUEUED:
            self._tell(self._book.withdraw(asked.task, TaskState.CANCELED, self._clocks.robot()))
            return TAKEN
        turn = self._under_way(asked.task)
        if isinstance(turn, ControlAnswer):
            return turn
        run = turn.run
        if run.ending is not None and not run.canceling and not run.yielding:
            return _refused(f"the task is about to end: {run.ending.state}")
        run.cancel()
        self.changed(turn)
        return TAKEN

    def reprioritise(self, asked: Reprioritise) -> ControlAnswer:
        """Give a queued task another place."""
        status = self._book.find(asked.task)
        if status is None:
            return _refused(f"unknown task {asked.task[:80]!r}")
        if status.state is not TaskState.QUEUED:
            return _refused(f"only a queued task can be reprioritised; this one is {status.state}")
        self._tell(self._book.rank(asked.task, asked.priority))
        return TAKEN

    def answer(self, asked: AnswerQuestion) -> ControlAnswer:
        """Hand an operator's answer to the tree, or to the question whether to go on after a restart."""
        turn = self._under_way(asked.task)
        if isinstance(turn, ControlAnswer):
            return turn
        context = turn.run.context
        question = context.dialogue.question
        if question is None or turn.run.ending is not None:
            return _refused("the task is not asking anything")
        if asked.answer not in question.choices:
            return _refused(f"expected one of {', '.join(question.choices)}; found {asked.answer!r}")
        context.dialogue.question = None
        if question is not QUESTION:
            context.dialogue.answers[question.node] = asked.answer
            turn.run.look_again()
        elif asked.answer == GO_ON:
            turn.run.told_to_go_on = True
            turn.run.resume()
        else:
            turn.run.interrupt(not_taken_up(turn.asked.kind.name, "an operator chose to give it up"))
        self.changed(turn)
        return TAKEN

    def breakpoint(self, asked: Breakpoint) -> ControlAnswer:
        """Put a breakpoint before or after a node of the task under way, or take it away."""
        turn = self._under_way(asked.task)
        if isinstance(turn, ControlAnswer):
            return turn
        node = turn.run.held_up_by() or turn.run.gates.find(asked.node)
        if isinstance(node, str):
            return _refused(node)
        turn.run.gates.hold(node, before=asked.when == "before", on=asked.on)
        return TAKEN

    def force(self, asked: ForceNode) -> ControlAnswer:
        """Have a node of a test run end with a status."""
        turn = self._under_way(asked.task)
        if isinstance(turn, ControlAnswer):
            return turn
        if not self._book.entry(asked.task).test_run:
            return _refused('the task is not a test run; request it with "test_run": true')
        node = turn.run.held_up_by() or turn.run.gates.find(asked.node)
        if isinstance(node, str):
            return _refused(node)
        turn.run.gates.force(node, None if asked.status is None else Status(asked.status))
        turn.run.look_again()
        return TAKEN

    def _step(self, asked: StepTask) -> ControlAnswer:
        return self._hold(asked.task, lambda run: run.step_by(asked.by))

    def _hold(self, task: str, verb: Callable[[Run], str]) -> ControlAnswer:
        turn = self._under_way(task)
        if isinstance(turn, ControlAnswer):
            return turn
        why = verb(turn.run)
        self.changed(turn)
        return ControlAnswer(accepted=not why, reason=why)

    def _under_way(self, task: str) -> CurrentTask | ControlAnswer:
        """Return the task's turn, or why it has none."""
        turn = self._current()
        if turn is not None and turn.task == task and turn.run.ended is None:
            return turn
        status = self._book.find(task)
        if status is None:
            return _refused(f"unknown task {task[:80]!r}")
        if status.state is TaskState.QUEUED:
            return _refused("the task has not started")
        return _refused(f"the task has ended: {status.state}")


def _refused(reason: str) -> ControlAnswer:
    return ControlAnswer(accepted=False, reason=reason)
