"""Following a task: each status or tree as it comes, and asking when nothing comes."""

from __future__ import annotations

from collections import deque
from typing import Final, Generic, TypeVar

from tandem.executive.client.errors import NotConnectedError, TimedOutError
from tandem.executive.client.questions import Questions
from tandem.executive.client.talks import Talk
from tandem.skills.ports.keys import Latest, Topic
from tandem.skills.ports.message import Message
from tandem.skills.ports.tasks import TASK_STATUS, TREE, TaskStatus, TreeSnapshot

ASK_EVERY: Final = 2.0
"""Seconds without news after which the executive is asked: a status may be lost with a lost link."""
DEPTH: Final = 1024
"""Messages that may wait to be read; the oldest go."""

M = TypeVar("M", bound=Message)


class _Following(Generic[M]):
    """Hears a topic from when it is made, so that nothing is missed between two calls of ``next``.

    Silence is not the task's end: an executive that is started again takes the task up. So a question without
    an answer is put again, until nothing has been heard for ``Talks.lost_after``.
    """

    def __init__(self, questions: Questions, topic: Topic[M], task: str, timeout: float | None) -> None:
        self._questions, self._task, self._timeout = questions, task, timeout
        self._monotonic = questions.talks.monotonic
        self._news = Latest(questions.talks.bus, topic, depth=DEPTH)
        self._ready: deque[M] = deque()
        self._began = self._heard_at = self._monotonic()
        self._quiet_since = float("-inf")  # the first thing is to ask how it stands

    def close(self) -> None:
        """Stop hearing."""
        self._news.close()

    def _rest(self) -> Talk[None]:
        """Wait for news, for the time to ask, or for the end of the time allowed."""
        now = self._monotonic()
        ends = [self._quiet_since + ASK_EVERY]
        if self._timeout is not None:
            if now >= self._began + self._timeout:
                raise TimedOutError(self._task, self._timeout)
            ends.append(self._began + self._timeout)
        yield max(0.0, min(ends) - now)

    def _due(self) -> bool:
        return self._monotonic() - self._quiet_since >= ASK_EVERY

    def _note_word(self) -> None:
        self._quiet_since = self._heard_at = self._monotonic()

    def _bear(self, silence: NotConnectedError) -> None:
        """Go on without an answer, unless it has been silent for too long."""
        if self._monotonic() - self._heard_at >= self._questions.talks.lost_after:
            raise silence
        self._quiet_since = self._monotonic()


class Following(_Following[TaskStatus]):
    """The statuses of one task: how it stands, then each change, until it has ended.

    Args:
        questions: ask how it stands.
        task: whose.
        timeout: host seconds that it may take; None: as long as it does.
    """

    def __init__(self, questions: Questions, task: str, timeout: float | None) -> None:
        # Not the task's own key: a key that is subscribed to for each task costs the router memory for ever.
        super().__init__(questions, TASK_STATUS, task, timeout)
        self._last: TaskStatus | None = None

    def next(self) -> Talk[TaskStatus | None]:
        """Return the next status that differs from the last; None after a terminal one.

        Raises:
            TimedOutError: when the task has not ended in time.
            NotConnectedError: when nothing has been heard for ``Talks.lost_after``.
            UnknownTaskError: when there is no such task.
        """
        if self._last is not None and self._last.state.terminal:
            return None
        while True:
            self._hear()
            if not self._ready and self._due():
                yield from self._ask()
            while self._ready:
                status = self._ready.popleft()
                if status != self._last:
                    self._last = status
                    return status
            yield from self._rest()

    def _ask(self) -> Talk[None]:
        try:
            status = yield from self._questions.status(self._task)
        except NotConnectedError as silence:
            self._hear()
            if not self._ready:
                self._bear(silence)
            return
        # What came meanwhile may be newer than the answer, and what is to be heard anyway is in order.
        self._hear()
        self._note_word()
        if not self._ready:
            self._ready.append(status)

    def _hear(self) -> None:
        news = [each for each in self._news.take() if each.task == self._task]
        if news:
            self._note_word()
            self._ready.extend(news)


class FollowingTree(_Following[TreeSnapshot]):
    """The trees of one task as they change, until it has ended.

    Args:
        questions: ask how it stands.
        task: whose.
        timeout: host seconds that it may take; None: as long as it does.
    """

    def __init__(self, questions: Questions, task: str, timeout: float | None) -> None:
        super().__init__(questions, TREE, task, timeout)
        self._statuses = Latest(questions.talks.bus, TASK_STATUS, depth=DEPTH)
        self._over = False
        self._shown: TreeSnapshot | None = None

    def next(self) -> Talk[TreeSnapshot | None]:
        """Return the next tree; None when the task has ended.

        Raises:
            TimedOutError: when the task has not ended in time.
            NotConnectedError: when nothing has been heard for ``Talks.lost_after``.
            UnknownTaskError: when there is no such task.
        """
        while True:
            self._hear()
            if not self._ready and not self._over and self._due():
                yield from self._ask()
            while self._ready:
                tree = self._ready.popleft()
                if tree != self._shown:
                    self._shown = tree
                    return tree
            if self._over:
                return None
            yield from self._rest()

    def close(self) -> None:
        """Stop hearing."""
        super().close()
        self._statuses.close()

    def _ask(self) -> Talk[None]:
        try:
            status = yield from self._questions.status(self._task)
            tree = yield from self._questions.tree()
        except NotConnectedError as silence:
            self._hear()
            if not (self._ready or self._over):
                self._bear(silence)
            return
        self._hear()
        self._note_word()
        self._over = self._over or status.state.terminal
        if tree.task == self._task and not self._ready:
            self._ready.append(tree)

    def _hear(self) -> None:
        # The last tree is told before the end: hear of the end first, and the tree is there.
        ends = [each for each in self._statuses.take() if each.task == self._task and each.state.terminal]
        news = [each for each in self._news.take() if each.task == self._task]
        if news:
            self._note_word()
            self._ready.extend(news)
        self._over = self._over or bool(ends)
