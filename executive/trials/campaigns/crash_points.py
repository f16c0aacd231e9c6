"""Every point where the executive persists, sends or receives, by a name; the process may be killed at one.

Wrapped around its bus and its ledger, and nowhere in the executive itself.
"""

from __future__ import annotations

import os
import re
import signal
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from tandem.executive.ledger.port import Entry, Ledger, Reading, SentGoal, Transition
from tandem.executive.ledger.task_memory import TaskMemory
from tandem.skills.ports.bus import Bus, Desk, Inbox, Pending, Request, Sample
from tandem.skills.ports.forwarding_bus import ForwardingBus
from tandem.skills.ports.message import MAX_REQUEST_BYTES
from tandem.skills.ports.tasks import AskHistory, History, TaskStatus

_TASK = re.compile(r"[a-z_]+-[a-z0-9]+-\d{4,}")


@dataclass(eq=False)
class CrashPoints:
    """Counts the points that are passed, and kills the process at the first time of one.

    Args:
        at: the point's name, such as ``before answer task/cancel``; empty: nowhere. ``asked task/cancel #2
            +5`` is five points after the second time of that one; hearing something does not count there.
        log: file to which each point is written when it is first passed; or, with ``at``, each that counts.
    """

    at: str = ""
    log: Path | None = None
    passed: dict[str, None] = field(default_factory=dict)
    _left: int | None = None
    """Points until the kill, once the point of ``at`` has been passed often enough."""

    def __post_init__(self) -> None:
        """Read ``at``."""
        first, _, after = self.at.partition(" +")
        self._point, _, time = first.partition(" #")
        self._time, self._after = int(time or 1), int(after or 0)

    def passing(self, point: str) -> None:
        """Pass a point."""
        named = _TASK.sub("<task>", point)
        if not self.at and named not in self.passed:
            self.passed[named] = None
            self._note(named)
        if self._left is not None:
            if named.startswith("heard "):
                return
            self._left -= 1
            self._note(named)
        elif named == self._point:
            self._time -= 1
            self._left = None if self._time else self._after
        if self._left == 0:
            os.kill(os.getpid(), signal.SIGKILL)

    def _note(self, named: str) -> None:
        if self.log is not None:
            with self.log.open("a", encoding="utf-8") as file:
                file.write(f"{named}\n")


@dataclass(frozen=True)
class _Request:
    """One query; to answer it is a point."""

    inner: Request
    points: CrashPoints

    @property
    def key(self) -> str:
        return self.inner.key

    @property
    def selector(self) -> str:
        return self.inner.selector

    @property
    def size(self) -> int:
        return self.inner.size

    @property
    def payload(self) -> bytes:
        return self.inner.payload

    def covers(self, key: str) -> bool:
        return self.inner.covers(key)

    def reply(self, payload: bytes) -> None:
        self.points.passing(f"before answer {self.key}")
        self.inner.reply(payload)
        self.points.passing(f"after answer {self.key}")

    def reply_each(self, answers: Mapping[str, bytes]) -> None:
        self.inner.reply_each(answers)

    def refuse(self, payload: bytes) -> None:
        self.inner.refuse(payload)

    def end(self) -> None:
        self.inner.end()


@dataclass(frozen=True)
class _Desk:
    inner: Desk
    points: CrashPoints

    def drain(self) -> list[Request]:
        taken: list[Request] = [_Request(each, self.points) for each in self.inner.drain()]
        for each in taken:
            self.points.passing(f"asked {each.key}")
        return taken

    def close(self) -> None:
        self.inner.close()


@dataclass(frozen=True)
class _Inbox:
    inner: Inbox
    points: CrashPoints

    def drain(self) -> list[Sample]:
        taken = self.inner.drain()
        for each in taken:
            self.points.passing(f"heard {each.key}")
        return taken

    def close(self) -> None:
        self.inner.close()


class CrashBus(ForwardingBus):
    """A bus that passes a point at each message.

    Args:
        inner: the bus that messages travel on.
        points: what is passed.
    """

    def __init__(self, inner: Bus, points: CrashPoints) -> None:
        super().__init__(inner)
        self._points = points

    def publish(self, key: str, payload: bytes) -> None:
        """Send."""
        self._points.passing(f"before put {key}")
        super().publish(key, payload)
        self._points.passing(f"after put {key}")

    def subscribe(self, key: str, *, depth: int = 256) -> Inbox:
        """Receive."""
        return _Inbox(super().subscribe(key, depth=depth), self._points)

    def query(self, key: str, payload: bytes, *, timeout: float = 2.0) -> Pending:
        """Ask."""
        self._points.passing(f"before query {key}")
        pending = super().query(key, payload, timeout=timeout)
        self._points.passing(f"after query {key}")
        return pending

    def serve(self, key: str, *, limit: int = MAX_REQUEST_BYTES) -> Desk:
        """Answer."""
        return _Desk(super().serve(key, limit=limit), self._points)


@dataclass(eq=False)
class CrashLedger:
    """A ledger that passes a point before and after each commit, named after what is committed."""

    inner: Ledger
    points: CrashPoints
    _written: dict[str, None] = field(default_factory=dict)

    @property
    def lasting(self) -> bool:
        """As the ledger."""
        return self.inner.lasting

    def enter(self, entry: Entry) -> None:
        """As the ledger."""
        self._written["request"] = None
        self.inner.enter(entry)

    def change(self, status: TaskStatus, at: float) -> None:
        """As the ledger."""
        self._written[str(status.state)] = None
        self.inner.change(status, at)

    def remember(self, task: str, memory: TaskMemory) -> None:
        """As the ledger."""
        self._written["memory"] = None
        self.inner.remember(task, memory)

    def goal(self, sent: SentGoal) -> None:
        """As the ledger."""
        self._written[f"goal of {sent.action}"] = None
        self.inner.goal(sent)

    def goal_ended(self, goal_id: str, how: str) -> None:
        """As the ledger."""
        self.inner.goal_ended(goal_id, how)

    def learn(self, kind: str, remaining: Mapping[str, float]) -> None:
        """As the ledger."""
        self.inner.learn(kind, remaining)

    def commit(self) -> None:
        """As the ledger."""
        if not self._written:
            self.inner.commit()
            return
        # What a task remembers goes along with most commits: it is named where it is all there is.
        what = " and ".join(each for each in self._written if each != "memory") or "memory"
        self.points.passing(f"before keeping {what}")
        self.inner.commit()
        self._written.clear()
        self.points.passing(f"after keeping {what}")

    def open_entries(self) -> tuple[Entry, ...]:
        """As the ledger."""
        return self.inner.open_entries()

    def entry(self, task: str) -> Entry | None:
        """As the ledger."""
        return self.inner.entry(task)

    def of_client(self, client_id: str, by: str) -> Entry | None:
        """As the ledger."""
        return self.inner.of_client(client_id, by)

    def history(self, asked: AskHistory) -> History:
        """As the ledger."""
        return self.inner.history(asked)

    def transitions(self, task: str) -> tuple[Transition, ...]:
        """As the ledger."""
        return self.inner.transitions(task)

    def attempts(self, task: str) -> Mapping[str, int]:
        """As the ledger."""
        return self.inner.attempts(task)

    def nodes_done(self, task: str) -> int:
        """As the ledger."""
        return self.inner.nodes_done(task)

    def open_goals(self) -> tuple[SentGoal, ...]:
        """As the ledger."""
        return self.inner.open_goals()

    def past(self, kind: str) -> Mapping[str, tuple[float, ...]]:
        """As the ledger."""
        return self.inner.past(kind)

    def last_number(self) -> int:
        """As the ledger."""
        return self.inner.last_number()

    def reading(self) -> Reading | None:
        """As the ledger."""
        return self.inner.reading()

    def note(self, reading: Reading) -> None:
        """As the ledger."""
        self.inner.note(reading)

    def prune(self, *, older_than: float, keep: int) -> int:
        """As the ledger."""
        return self.inner.prune(older_than=older_than, keep=keep)

    def close(self) -> None:
        """As the ledger."""
        self.inner.close()
