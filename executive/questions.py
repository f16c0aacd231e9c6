"""What anybody may ask: the tasks, one task, the history, who serves here, the tree as it is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from pydantic import ValidationError

from executive.ledger.port import Ledger
from executive.task_book import TaskBook
from skills.ports.bus import Bus, Request
from skills.ports.message import Message
from skills.ports.tasks import (
    TASK_HISTORY,
    TASK_INFO,
    TASK_LIST,
    TASK_STATUS,
    TREE,
    TREE_NOW,
    AskHistory,
    ExecutiveInfo,
    History,
    TaskList,
    TaskStatus,
    TreeSnapshot,
    task_status,
)

ONE: Final = task_status("*").key


class Questions:
    """The desks. A topic's key that is queried answers with what was published there last.

    Args:
        bus: where clients are.
        book: the tasks in memory.
        ledger: all tasks.
        info: tells who serves.
        tree: returns the tree as it is.
    """

    def __init__(
        self,
        bus: Bus,
        book: TaskBook,
        ledger: Ledger,
        *,
        info: Callable[[], ExecutiveInfo],
        tree: Callable[[], TreeSnapshot],
    ) -> None:
        self.last = ""
        """The task that was told of last."""
        self._book, self._ledger, self._info, self._tree = book, ledger, info, tree
        answers: Mapping[str, Callable[[Request], Message | None]] = {
            TASK_LIST.key: lambda _: TaskList(tasks=book.all()),
            TASK_INFO.key: lambda _: info(),
            TREE_NOW.key: lambda _: tree(),
            TREE.key: lambda _: tree(),
            TASK_STATUS.key: lambda _: self._one(self.last) if self.last else None,
            ONE: lambda asked: self._one(asked.key.split("/")[1]),
            TASK_HISTORY.key: self._history,
        }
        self._desks = [(bus.serve(key), answer) for key, answer in answers.items()]

    def step(self) -> None:
        """Answer all who asked; whoever asks for what is not there gets no answer."""
        for desk, answer in self._desks:
            for request in desk.drain():
                message = answer(request)
                if message is not None:
                    request.reply(message.model_dump_json().encode())

    def close(self) -> None:
        """Stop serving."""
        for desk, _ in self._desks:
            desk.close()

    def _one(self, task: str) -> TaskStatus | None:
        status = self._book.find(task)
        return None if status is None else self._book.explained(status)

    def _history(self, request: Request) -> History:
        try:
            asked = AskHistory.model_validate_json(request.payload or b"{}")
        except ValidationError:
            return History(tasks=())
        found = self._ledger.history(asked)
        # What is in memory is newer than what is on disk, by what need not be on disk.
        return found.model_copy(
            update={
                "tasks": tuple(
                    self._book.explained(self._book.get(each.task) or each) for each in found.tasks
                )
            }
        )
