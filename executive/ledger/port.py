"""The ledger: what is written down before anybody hears of it. One contract, two ledgers.

Writing changes nothing for good until ``commit``; all that was written since the last one becomes durable
at once, or none of it. ``tests/contracts/test_ledger.py`` holds both ledgers to the same tests.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol

from tandem.executive.config.on_restart import OnRestart
from tandem.executive.ledger.task_memory import TaskMemory
from tandem.skills.ports.tasks import AskHistory, History, TaskState, TaskStatus


class LedgerError(RuntimeError):
    """The ledger can't be opened, read or written; the message says which file, why, and what to do.

    Nothing that was committed is lost by it. Exit code 5.
    """


class LedgerLockedError(LedgerError):
    """Another process owns the ledger. Exit code 4."""


@dataclass(frozen=True)
class Entry:
    """One accepted request."""

    status: TaskStatus
    number: int
    """Its place in the order of arrival; never given twice."""
    on_restart: OnRestart | None = None
    """As the request asks; None: as the service is configured."""
    test_run: bool = False
    """Whether its nodes may be forced."""
    memory: TaskMemory = field(default_factory=TaskMemory)
    """What a restart must know of it beside its status."""


@dataclass(frozen=True)
class Transition:
    """One change of a task's state."""

    state: TaskState
    at: float
    """UTC seconds."""


@dataclass(frozen=True)
class SentGoal:
    """A goal that was written down before it was sent: ``task/node/attempt`` and its action."""

    goal_id: str
    action: str


@dataclass(frozen=True)
class Reading:
    """The clocks as the ledger last knew them."""

    utc: float
    """Seconds since 1970, as plausible as they were."""
    host: str
    """Names the start of the host in which ``monotonic`` counts; empty: not known."""
    monotonic: float
    """Seconds of the host's monotonic clock at that moment."""
    doubt: float = 0.0
    """Host seconds at work for which ``utc`` is not to be trusted with the age of what is stored."""


class Ledger(Protocol):
    """Every method raises ``LedgerError`` when the disk does not do what it should."""

    @property
    def lasting(self) -> bool:
        """Whether what is committed is still there after the process."""
        ...

    def enter(self, entry: Entry) -> None:
        """Write an accepted request down."""
        ...

    def change(self, status: TaskStatus, at: float) -> None:
        """Write how a task stands now; another state is a transition ``at`` UTC seconds.

        A task that has reached an end closes its goals.
        """
        ...

    def remember(self, task: str, memory: TaskMemory) -> None:
        """Write what a restart must know of a task."""
        ...

    def goal(self, sent: SentGoal) -> None:
        """Write a goal down, which is to be sent once this is committed."""
        ...

    def goal_ended(self, goal_id: str, how: str) -> None:
        """Write how it ended."""
        ...

    def learn(self, kind: str, remaining: Mapping[str, float]) -> None:
        """Write how many robot seconds a task of a kind took from the beginning of each phase to its end."""
        ...

    def commit(self) -> None:
        """Make durable what was written; when it can't be, nothing of it stays."""
        ...

    def open_entries(self) -> tuple[Entry, ...]:
        """Return the tasks that have not ended, in the order of their arrival."""
        ...

    def entry(self, task: str) -> Entry | None:
        """Return a task by its id."""
        ...

    def of_client(self, client_id: str, by: str) -> Entry | None:
        """Return the task of a client's own id; ``by``: the client's name, empty without one.

        Also one that is forgotten but for that.
        """
        ...

    def history(self, asked: AskHistory) -> History:
        """Return tasks, the newest first."""
        ...

    def transitions(self, task: str) -> tuple[Transition, ...]:
        """Return a task's states, the oldest first."""
        ...

    def attempts(self, task: str) -> Mapping[str, int]:
        """Return the number of the last goal of each node of a task."""
        ...

    def nodes_done(self, task: str) -> int:
        """Return how many nodes of a task have had a goal that ended well."""
        ...

    def open_goals(self) -> tuple[SentGoal, ...]:
        """Return the goals of which no end is written, in the order in which they were sent."""
        ...

    def past(self, kind: str) -> Mapping[str, tuple[float, ...]]:
        """Return what was learnt of a kind, by phase: robot seconds to the end, the newest few."""
        ...

    def last_number(self) -> int:
        """Return the highest number of an entry, 0 without any."""
        ...

    def reading(self) -> Reading | None:
        """Return the clocks as they were noted last; None in a new ledger."""
        ...

    def note(self, reading: Reading) -> None:
        """Note the clocks."""
        ...

    def prune(self, *, older_than: float, keep: int) -> int:
        """Forget tasks that ended before UTC seconds, and the oldest of more than ``keep`` ended ones.

        Of one with a client's id it stays known that it was asked for and how it ended, so that the same
        request does not run again; whatever a clock says, only the number of those is bounded. Commits;
        returns how many were forgotten. A task that has not ended stays.
        """
        ...

    def close(self) -> None:
        """Let go; what was not committed is gone. Closing twice is allowed."""
        ...
