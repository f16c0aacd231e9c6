"""What anybody may ask: the tasks, one task, the history, who serves here, the tree as it is."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Final

from tandem.executive.ledger.port import Ledger, LedgerError
from tandem.executive.service.tasks.task_book import TaskBook
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.endpoint import answering, endpoint
from tandem.skills.ports.keys import Nothing, Service
from tandem.skills.ports.serving import Endpoints
from tandem.skills.ports.site import Site
from tandem.skills.ports.tasks import (
    PAGE,
    TASK_HISTORY,
    TASK_INFO,
    TASK_KINDS,
    TASK_LIST,
    TASK_SITE,
    TASK_STATUS,
    TASK_TIMELINE,
    TREE,
    TREE_NOW,
    AskHistory,
    AskTasks,
    ExecutiveInfo,
    TaskStatus,
    Timeline,
    TreeSnapshot,
    task_status,
)

LAST_STATUS: Final = Service(TASK_STATUS.key, Nothing, TaskStatus, reads=True)
ONE_STATUS: Final = Service(task_status("*").key, Nothing, TaskStatus, reads=True)
LAST_TREE: Final = Service(TREE.key, Nothing, TreeSnapshot, reads=True)
"""A topic's key that is queried answers with what was published there last."""


class Questions:
    """Serves the questions.

    Args:
        bus: where clients are.
        clocks: host time for rates.
        book: the tasks in memory.
        ledger: all tasks.
        info: tells who serves.
        last: returns the task that was told of last, or nothing.
        tree: returns the tree as it is.
        kinds: tells what may be asked for, as JSON.
        site: the place that the executive works in.
        timeline: tells when which node of a task ran.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        book: TaskBook,
        ledger: Ledger,
        *,
        info: Callable[[], ExecutiveInfo],
        last: Callable[[], str],
        tree: Callable[[], bytes],
        kinds: Callable[[], bytes],
        site: Site,
        timeline: Callable[[str], Timeline],
    ) -> None:
        self._book, self._ledger = book, ledger
        self._written: dict[str, tuple[TaskStatus, str, bytes]] = {}
        self._endpoints = Endpoints(
            bus,
            clocks.monotonic,
            (
                answering(TASK_LIST, self._list),
                answering(TASK_INFO, lambda _: info()),
                answering(TASK_KINDS, lambda _: kinds()),
                answering(TASK_SITE, lambda _: site),
                answering(TASK_TIMELINE, lambda asked: timeline(self._meant(asked.task))),
                answering(TREE_NOW, lambda _: tree()),
                answering(LAST_TREE, lambda _: tree()),
                answering(LAST_STATUS, lambda _: self._find(last()) if last() else None),
                endpoint(ONE_STATUS, lambda call: self._find(call.name), keys=self._keys),
                answering(TASK_HISTORY, self._history),
            ),
            fatal=(LedgerError,),
        )

    def step(self) -> bool:
        """Answer who asked; whoever asks for what is not there gets no answer. Return whether more wait."""
        return self._endpoints.step()

    def close(self) -> None:
        """Stop serving."""
        self._endpoints.close()

    def _find(self, task: str) -> TaskStatus | None:
        status = self._book.find(self._meant(task))
        return None if status is None else self._book.explained(status)

    def _meant(self, name: str) -> str:
        """Return the id of the task that somebody names, the newest of those whose client chose this id."""
        return next(reversed(self._book.named(name)), name)

    def _keys(self) -> Iterable[str]:
        tasks, _ = self._book.page(0, PAGE)
        return (task_status(status.task).key for status in reversed(tasks))

    def _list(self, asked: AskTasks) -> bytes:
        return self._page(*self._book.page(asked.before, asked.limit))

    def _history(self, asked: AskHistory) -> bytes:
        found = self._ledger.history(asked)
        # What is in memory is newer than what is on disk, by what need not be on disk.
        return self._page((self._book.get(each.task) or each for each in found.tasks), found.more)

    def _page(self, tasks: Iterable[TaskStatus], more: int) -> bytes:
        """Return a TaskList or History as JSON; a status that has not changed is not written anew."""
        written = b'{"tasks":[%s],"more":%d}' % (b",".join(self._write(each) for each in tasks), more)
        if len(self._written) > self._book.count:  # of tasks that are in memory no longer
            now = self._book.get
            self._written = {task: known for task, known in self._written.items() if now(task) is known[0]}
        return written

    def _write(self, status: TaskStatus) -> bytes:
        known, waits = self._written.get(status.task), self._book.waits(status)
        if known is not None and known[0] is status and known[1] == waits:
            return known[2]
        written = self._book.explained(status).model_dump_json().encode()
        if self._book.get(status.task) is status:  # what was read out of the ledger is another one next time
            self._written[status.task] = (status, waits, written)
        return written
