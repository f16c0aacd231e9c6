"""The ledger in memory: for lockstep and tests. It ends with its process, and forgets old tasks."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import replace
from typing import Final

from tandem.executive.ledger.port import Entry, Reading, SentGoal, Transition
from tandem.executive.ledger.sender import asked_by
from tandem.executive.ledger.stubs import stub_of
from tandem.executive.ledger.task_memory import TaskMemory
from tandem.skills.ports.action import GoalState
from tandem.skills.ports.tasks import AskHistory, History, TaskStatus

KEPT_IDS: Final = 2000
"""Clients' ids that are kept beyond the history, in memory."""
PAST: Final = 20
"""Past durations of a kind's phase that count."""


class MemoryLedger:
    """See ``Ledger``. What is written counts at once; ``commit`` has nothing to do."""

    lasting: Final = False

    def __init__(self) -> None:
        self._entries: dict[str, Entry] = {}
        self._transitions: dict[str, list[Transition]] = {}
        self._clients: dict[tuple[str, str], str] = {}  # by who asked and the client's id
        self._attempts: dict[str, dict[str, int]] = {}
        self._goals: dict[str, SentGoal] = {}
        self._past: dict[str, dict[str, deque[float]]] = {}
        self._number = 0
        self._forgotten: dict[tuple[str, str], Entry] = {}  # likewise
        self._reading: Reading | None = None
        self._done: dict[str, set[str]] = {}

    def enter(self, entry: Entry) -> None:
        """Keep it."""
        task = entry.status.task
        self._entries[task] = entry
        self._number = max(self._number, entry.number)
        self._transitions[task] = [Transition(entry.status.state, entry.status.accepted_at)]
        if entry.status.client_id:
            self._clients[_named(entry.status)] = task

    def change(self, status: TaskStatus, at: float) -> None:
        """Keep it."""
        entry = self._entries[status.task]
        if entry.status.state is not status.state:
            self._transitions[status.task].append(Transition(status.state, at))
        self._entries[status.task] = replace(entry, status=status)
        if status.state.terminal:
            self._goals = {
                goal_id: sent for goal_id, sent in self._goals.items() if task_of(goal_id) != status.task
            }

    def remember(self, task: str, memory: TaskMemory) -> None:
        """Keep it."""
        self._entries[task] = replace(self._entries[task], memory=memory)

    def goal(self, sent: SentGoal) -> None:
        """Keep it."""
        self._goals[sent.goal_id] = sent
        task, node, attempt = split(sent.goal_id)
        self._attempts.setdefault(task, {})[node] = attempt

    def goal_ended(self, goal_id: str, how: str) -> None:
        """Forget it, but for the node if it ended well."""
        self._goals.pop(goal_id, None)
        if how == GoalState.SUCCEEDED:
            task, node, _ = split(goal_id)
            self._done.setdefault(task, set()).add(node)

    def learn(self, kind: str, remaining: Mapping[str, float]) -> None:
        """Keep the newest."""
        phases = self._past.setdefault(kind, {})
        for phase, seconds in remaining.items():
            phases.setdefault(phase, deque(maxlen=PAST)).append(seconds)

    def commit(self) -> None:
        """Do nothing."""

    def open_entries(self) -> tuple[Entry, ...]:
        """Return what has not ended."""
        return tuple(each for each in self._entries.values() if not each.status.state.terminal)

    def entry(self, task: str) -> Entry | None:
        """Return it."""
        return self._entries.get(task)

    def of_client(self, client_id: str, by: str) -> Entry | None:
        """Return it."""
        named = (by, client_id)
        return self._entries.get(self._clients.get(named, "")) or self._forgotten.get(named)

    def history(self, asked: AskHistory) -> History:
        """Look through all."""
        found = [
            each
            for each in reversed(self._entries.values())
            if (not asked.states or each.status.state in asked.states)
            and each.status.accepted_at >= asked.since
            and asked.task in {"", each.status.task, each.status.client_id}
            and (asked.before == 0 or each.number < asked.before)
        ]
        tasks = tuple(each.status for each in found[: asked.limit])
        return History(tasks=tasks, more=found[asked.limit - 1].number if len(found) > asked.limit else 0)

    def transitions(self, task: str) -> tuple[Transition, ...]:
        """Return them."""
        return tuple(self._transitions.get(task, ()))

    def attempts(self, task: str) -> Mapping[str, int]:
        """Return them."""
        return dict(self._attempts.get(task, {}))

    def nodes_done(self, task: str) -> int:
        """Return how many are kept."""
        return len(self._done.get(task, ()))

    def open_goals(self) -> tuple[SentGoal, ...]:
        """Return them."""
        return tuple(self._goals.values())

    def past(self, kind: str) -> Mapping[str, tuple[float, ...]]:
        """Return what is kept."""
        return {phase: tuple(kept) for phase, kept in self._past.get(kind, {}).items()}

    def last_number(self) -> int:
        """Return it."""
        return self._number

    def prune(self, *, older_than: float, keep: int) -> int:
        """Forget them."""
        ended = [each.status for each in self._entries.values() if each.status.state.terminal]
        over = max(0, len(ended) - keep)
        old = [
            each for place, each in enumerate(ended) if place < over or (each.ended_at or 0.0) < older_than
        ]
        for status in old:
            if status.client_id:
                stub = replace(self._entries[status.task], status=stub_of(status))
                self._forgotten[_named(status)] = stub
            for kept in (self._entries, self._transitions, self._attempts, self._done):
                kept.pop(status.task, None)
            self._clients.pop(_named(status), None)
        while len(self._forgotten) > KEPT_IDS:
            del self._forgotten[next(iter(self._forgotten))]
        return len(old)

    def reading(self) -> Reading | None:
        """Return it."""
        return self._reading

    def note(self, reading: Reading) -> None:
        """Keep it."""
        self._reading = reading

    def close(self) -> None:
        """Do nothing."""


def _named(status: TaskStatus) -> tuple[str, str]:
    return asked_by(status.request), status.client_id


def split(goal_id: str) -> tuple[str, str, int]:
    """Return a goal's task, node and attempt; the node's name may have slashes."""
    task, _, rest = goal_id.partition("/")
    node, _, attempt = rest.rpartition("/")
    return task, node, int(attempt) if attempt.isdigit() else 0


def task_of(goal_id: str) -> str:
    """Return a goal's task."""
    return goal_id.partition("/")[0]
