"""Hears what happens on the bus and tells it to those who keep records: metrics, traces.

A node of a process of its own (the role ``observer``): nothing of the system needs it, and it may die or be
slow without harm to anybody.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Final, Protocol

from tandem.skills.ports.action import GoalStatus
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.reflex import ReflexState, reflex_state
from tandem.skills.ports.refusals import REFUSALS, Refusals
from tandem.skills.ports.tasks import (
    TASK_LIST,
    TASK_PULSE,
    TASK_STATUS,
    TREE,
    AskTasks,
    ExecutivePulse,
    TaskStatus,
    TreeSnapshot,
)

DEPTH: Final = 4096
"""Messages that may wait; a record with a gap is better than one that grows without end."""
GOALS: Final = "skill/**/status"
EXECUTIVE: Final = "executive"
"""What it is announced as."""
ASK_EVERY: Final = 2.0
"""Seconds of the host."""


class Record(Protocol):
    """Who keeps one."""

    def on_task(self, status: TaskStatus) -> None:
        """Take in a task's status."""
        ...

    def on_known(self, tasks: tuple[TaskStatus, ...]) -> None:
        """Take in the tasks that were there before."""
        ...

    def on_tree(self, tree: TreeSnapshot) -> None:
        """Take in a tree."""
        ...

    def on_goal(self, action: str, status: GoalStatus) -> None:
        """Take in the status of a skill's goal; ``action`` such as ``base/drive``."""
        ...

    def on_reflex(self, reflex: ReflexState) -> None:
        """Take in how a reflex is."""
        ...

    def on_pulse(self, pulse: ExecutivePulse) -> None:
        """Take in the executive's pulse."""
        ...

    def on_refused(self, refusals: Refusals) -> None:
        """Take in what a process has refused so far."""
        ...

    def on_alive(self, names: frozenset[str]) -> None:
        """Take in who is announced now."""
        ...

    def close(self) -> None:
        """Write down what has not been yet."""
        ...


class Observer:
    """A ``Node``.

    Args:
        bus: where things happen.
        clocks: the host's clock, for when to ask again.
        records: who is told, in this order.
    """

    def __init__(self, bus: Bus, clocks: Clocks, records: Sequence[Record]) -> None:
        self._bus, self._clocks, self._records = bus, clocks, tuple(records)
        self._pulses = Latest(bus, TASK_PULSE, depth=DEPTH)
        self._tasks = Latest(bus, TASK_STATUS, depth=DEPTH)
        self._trees = Latest(bus, TREE, depth=DEPTH)
        self._refusals = Latest(bus, REFUSALS, depth=DEPTH)
        self._goals = Heard(bus, GOALS, GoalStatus.model_validate_json, depth=DEPTH)
        self._reflexes = Heard(bus, reflex_state("*").key, ReflexState.model_validate_json, depth=DEPTH)
        self._ended: list[TaskStatus] = []  # told last: what belongs to a task comes before its end
        self._known: Pending | None = None
        self._asked_at: float | None = None
        self._there = False

    @property
    def name(self) -> str:
        """For logs."""
        return "observer"

    def step(self) -> bool:
        """Tell what has arrived."""
        for pulse in self._pulses.take():
            self._each(partial(_tell_pulse, pulse))
        for task in self._tasks.take():
            self._task(task)
        for tree in self._trees.take():
            self._each(partial(_tell_tree, tree))
        for key, goal, _ in self._goals.take():
            action = key.removeprefix("skill/").removesuffix("/status")
            self._each(partial(_tell_goal, action, goal))
        for _, reflex, _ in self._reflexes.take():
            self._each(partial(_tell_reflex, reflex))
        for refusals in self._refusals.take():
            self._each(partial(_tell_refusals, refusals))
        for record in self._records:
            for status in self._ended:
                record.on_task(status)
        self._ended.clear()
        alive = self._bus.alive()
        self._each(lambda record: record.on_alive(alive))
        self._take_known(there=EXECUTIVE in alive)
        return False

    def close(self) -> None:
        """Stop hearing, and have the records closed."""
        for heard in (self._pulses, self._tasks, self._trees, self._refusals, self._goals, self._reflexes):
            heard.close()
        self._each(lambda record: record.close())

    def _take_known(self, *, there: bool) -> None:
        """Ask an executive that has come which tasks there are, until it has said so."""
        came, self._there = there and not self._there, there
        now = self._clocks.monotonic()
        if came or (self._asked_at is not None and now - self._asked_at > ASK_EVERY):
            self._known, self._asked_at = TASK_LIST.query(self._bus, AskTasks()), now
        answer = None if self._known is None else self._known.poll()
        if answer is not None:
            self._known = self._asked_at = None
            tasks = TASK_LIST.decode_answer(answer).tasks
            self._each(lambda record: record.on_known(tasks))

    def _task(self, status: TaskStatus) -> None:
        if status.state.terminal:
            self._ended.append(status)
        else:
            self._each(lambda record: record.on_task(status))

    def _each(self, tell: Callable[[Record], None]) -> None:
        for record in self._records:
            tell(record)


def _tell_pulse(pulse: ExecutivePulse, record: Record) -> None:
    record.on_pulse(pulse)


def _tell_tree(tree: TreeSnapshot, record: Record) -> None:
    record.on_tree(tree)


def _tell_reflex(reflex: ReflexState, record: Record) -> None:
    record.on_reflex(reflex)


def _tell_refusals(refusals: Refusals, record: Record) -> None:
    record.on_refused(refusals)


def _tell_goal(action: str, status: GoalStatus, record: Record) -> None:
    record.on_goal(action, status)
