"""The ledger in an SQLite file: WAL, an fdatasync at each commit, one connection, one owner.

One connection because SQLite before 3.51.3 can damage a file in WAL mode when two write at once, and because
nobody else has any business there: a lock beside the file (``ledger.lock``) goes with its process.
"""

from __future__ import annotations

import fcntl
import os
import sqlite3
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from functools import wraps
from pathlib import Path
from typing import Concatenate, Final, ParamSpec, TypeVar

from pydantic import ValidationError

from tandem.executive.config.data_folder import not_writable
from tandem.executive.config.on_restart import OnRestart
from tandem.executive.ledger.memory import PAST, split
from tandem.executive.ledger.port import Entry, LedgerError, LedgerLockedError, Reading, SentGoal, Transition
from tandem.executive.ledger.rows import Reader, known_part, whole
from tandem.executive.ledger.schema import MIGRATIONS
from tandem.executive.ledger.sender import asked_by
from tandem.executive.ledger.stubs import KEPT_IDS, stub_of
from tandem.executive.ledger.task_memory import TaskMemory
from tandem.skills.ports.problems import in_words as problems_in_words
from tandem.skills.ports.problems import problems_of
from tandem.skills.ports.tasks import AskHistory, History, TaskState, TaskStatus

FILE: Final = "ledger.sqlite"
LOCK: Final = "ledger.lock"

P = ParamSpec("P")
T = TypeVar("T")
_ENTRY: Final = "SELECT number, on_restart, test_run, memory, status FROM tasks"
_OLD: Final = (
    "SELECT number, on_restart, test_run, memory, status FROM tasks "
    "WHERE open = 0 AND forgotten = 0 AND number < ? AND (ended_at < ? OR number IN "
    "(SELECT number FROM tasks WHERE open = 0 AND forgotten = 0 ORDER BY number DESC LIMIT -1 OFFSET ?))"
)
_FORGET: Final = ("DELETE FROM transitions WHERE task = ?", "DELETE FROM goals WHERE task = ?")
_FORGET_IDS: Final = (
    "DELETE FROM tasks WHERE number IN "
    "(SELECT number FROM tasks WHERE forgotten = 1 ORDER BY number DESC LIMIT -1 OFFSET ?)"
)


def _told(
    call: Callable[Concatenate[SqliteLedger, P], T],
) -> Callable[Concatenate[SqliteLedger, P], T]:
    """Turn SQLite's errors into the ledger's; what was not committed is taken back."""

    @wraps(call)
    def method(ledger: SqliteLedger, /, *args: P.args, **kwargs: P.kwargs) -> T:
        try:
            return call(ledger, *args, **kwargs)
        except sqlite3.Error as error:
            ledger.take_back()
            raise LedgerError(in_words(ledger.path, error)) from error

    return method


class SqliteLedger:
    """See ``Ledger``. Opening takes the owner's lock.

    Args:
        folder: where the file is, or is to be; made when it is not there.
        migrations: the tables (``tandem.executive.ledger.schema``).
        robot: ``<site>/<robot>`` whose tasks are kept; the first one to open a ledger owns it. None: whoever
            owns it, to read.

    Raises:
        LedgerLockedError: when another process has it open.
        LedgerError: when it can't be read or written, is of a newer version or of another robot, or is no
            such file.
    """

    lasting: Final = True

    def __init__(
        self,
        folder: Path,
        migrations: tuple[tuple[str, ...], ...] = MIGRATIONS,
        *,
        robot: str | None = None,
    ) -> None:
        self.path = folder / FILE
        self._lock = _lock(folder)
        try:
            self._db = sqlite3.connect(self.path, isolation_level=None)
        except sqlite3.Error as error:
            os.close(self._lock)
            raise LedgerError(in_words(self.path, error)) from error
        try:
            self._open(migrations)
            if robot is not None:
                self._belong_to(robot)
                self._say_whose()
        except sqlite3.Error as error:
            self.close()
            raise LedgerError(in_words(self.path, error)) from error
        except LedgerError:
            self.close()
            raise

    def _open(self, migrations: tuple[tuple[str, ...], ...]) -> None:
        for pragma in ("locking_mode = EXCLUSIVE", "journal_mode = WAL", "synchronous = FULL"):
            self._db.execute(f"PRAGMA {pragma}")
        (version,) = self._db.execute("PRAGMA user_version").fetchone()
        if version > len(migrations):
            raise LedgerError(
                f"{self.path}: the ledger has version {version}, but this program supports versions up to "
                f"{len(migrations)}; nothing was changed; run a newer version, or choose another --data"
            )
        self._write("BEGIN IMMEDIATE")  # a disk that can't be written is told now, not with the first request
        for number in range(version, len(migrations)):
            for statement in migrations[number]:
                self._db.execute(statement)
        self._db.execute(f"PRAGMA user_version = {len(migrations)}")
        self._db.execute("COMMIT")

    @property
    def owner(self) -> str | None:
        """``<site>/<robot>`` whose tasks are kept; None until one has opened the ledger as its own."""
        row = self._db.execute("SELECT name FROM robot").fetchone()
        return None if row is None else str(row[0])

    def _belong_to(self, robot: str) -> None:
        owner = self.owner
        if owner is None:
            self._db.execute("INSERT INTO robot (one, name) VALUES (1, ?)", (robot,))
        elif owner != robot:
            raise LedgerError(
                f"{self.path}: these are tasks of {owner}, and {robot} must not take them up; choose another"
                " --data, or the --site-key and --robot that they are of"
            )

    def _say_whose(self) -> None:
        """Write the owner's name beside the file, which nobody else can read while it is open."""
        owner = (self.owner or "").encode()
        with suppress(OSError):  # told for convenience only: the ledger itself says it, too
            os.ftruncate(self._lock, 0)
            os.pwrite(self._lock, owner, 0)

    @_told
    def enter(self, entry: Entry) -> None:
        """Write a row, and the first transition."""
        status = entry.status
        row = (
            entry.number,
            status.task,
            status.kind,
            str(status.state),
            int(not status.state.terminal),
            status.client_id or None,
            asked_by(status.request),
            status.accepted_at,
            entry.on_restart,
            int(entry.test_run),
            entry.memory.model_dump_json(exclude_defaults=True),
            status.model_dump_json(),
        )
        self._write(
            "INSERT INTO tasks (number, task, kind, state, open, client_id, asked_by, accepted_at, "
            "on_restart, test_run, memory, status) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
            row,
        )
        self._transition(status, status.accepted_at)

    @_told
    def change(self, status: TaskStatus, at: float) -> None:
        """Write the row anew, and the transition if it is one."""
        known = self._db.execute("SELECT state FROM tasks WHERE task = ?", (status.task,)).fetchone()
        if known is None:
            raise LedgerError(f"{self.path}: {status.task} is missing from the ledger")
        ended = status.state.terminal
        self._write(
            "UPDATE tasks SET state = ?, open = ?, ended_at = ?, status = ? WHERE task = ?",
            (str(status.state), int(not ended), status.ended_at, status.model_dump_json(), status.task),
        )
        if known[0] != str(status.state):
            self._transition(status, at)
        if ended:
            self._write(
                "UPDATE goals SET how = 'with its task' WHERE task = ? AND how IS NULL", (status.task,)
            )

    @_told
    def remember(self, task: str, memory: TaskMemory) -> None:
        """Write the row's part."""
        words = memory.model_dump_json(exclude_defaults=True)
        self._write("UPDATE tasks SET memory = ? WHERE task = ?", (words, task))

    @_told
    def goal(self, sent: SentGoal) -> None:
        """Write a row; a goal that is sent again is written once."""
        task, node, attempt = split(sent.goal_id)
        self._write(
            "INSERT OR IGNORE INTO goals (goal_id, task, node, attempt, action) VALUES (?, ?, ?, ?, ?)",
            (sent.goal_id, task, node, attempt, sent.action),
        )

    @_told
    def goal_ended(self, goal_id: str, how: str) -> None:
        """Write how."""
        self._write("UPDATE goals SET how = ? WHERE goal_id = ? AND how IS NULL", (how, goal_id))

    @_told
    def learn(self, kind: str, remaining: Mapping[str, float]) -> None:
        """Write a row a phase; the oldest go."""
        for phase, seconds in remaining.items():
            self._write("INSERT INTO past (kind, phase, remaining) VALUES (?, ?, ?)", (kind, phase, seconds))
            self._write(
                "DELETE FROM past WHERE kind = ? AND phase = ? AND place NOT IN "
                "(SELECT place FROM past WHERE kind = ? AND phase = ? ORDER BY place DESC LIMIT ?)",
                (kind, phase, kind, phase, PAST),
            )

    @_told
    def commit(self) -> None:
        """End the transaction, if there is one: on the disk when the call returns."""
        if self._db.in_transaction:
            self._db.execute("COMMIT")

    @_told
    def open_entries(self) -> tuple[Entry, ...]:
        """Read them, each to the last field: what is gone on with must not be half understood."""
        return self._entries(f"{_ENTRY} WHERE open = 1 ORDER BY number", (), whole)

    @_told
    def entry(self, task: str) -> Entry | None:
        """Read it."""
        return next(iter(self._entries(f"{_ENTRY} WHERE task = ?", (task,))), None)

    @_told
    def of_client(self, client_id: str, by: str) -> Entry | None:
        """Read it."""
        found = self._entries(f"{_ENTRY} WHERE asked_by = ? AND client_id = ?", (by, client_id))
        return next(iter(found), None)

    @_told
    def history(self, asked: AskHistory) -> History:
        """Read them."""
        states = ", ".join(f"'{state}'" for state in asked.states or tuple(TaskState))
        found = self._entries(
            f"{_ENTRY} WHERE forgotten = 0 AND state IN ({states}) AND accepted_at >= ? "
            "AND (? = '' OR task = ? OR client_id = ?) AND (? = 0 OR number < ?) "
            "ORDER BY number DESC LIMIT ?",
            (asked.since, asked.task, asked.task, asked.task, asked.before, asked.before, asked.limit + 1),
        )
        tasks = tuple(entry.status for entry in found[: asked.limit])
        return History(tasks=tasks, more=found[asked.limit - 1].number if len(found) > asked.limit else 0)

    @_told
    def transitions(self, task: str) -> tuple[Transition, ...]:
        """Read them."""
        rows = self._db.execute("SELECT state, at FROM transitions WHERE task = ? ORDER BY rowid", (task,))
        return tuple(Transition(TaskState(state), at) for state, at in rows)

    @_told
    def attempts(self, task: str) -> Mapping[str, int]:
        """Read them."""
        return dict(
            self._db.execute("SELECT node, max(attempt) FROM goals WHERE task = ? GROUP BY node", (task,))
        )

    @_told
    def nodes_done(self, task: str) -> int:
        """Count them."""
        counted = "SELECT count(DISTINCT node) FROM goals WHERE task = ? AND how = 'SUCCEEDED'"
        return int(self._db.execute(counted, (task,)).fetchone()[0])

    @_told
    def open_goals(self) -> tuple[SentGoal, ...]:
        """Read them."""
        rows = self._db.execute("SELECT goal_id, action FROM goals WHERE how IS NULL ORDER BY rowid")
        return tuple(SentGoal(goal_id, action) for goal_id, action in rows)

    @_told
    def past(self, kind: str) -> Mapping[str, tuple[float, ...]]:
        """Read it."""
        found: dict[str, tuple[float, ...]] = {}
        rows = self._db.execute("SELECT phase, remaining FROM past WHERE kind = ? ORDER BY place", (kind,))
        for phase, seconds in rows:
            found[phase] = (*found.get(phase, ()), seconds)
        return found

    @_told
    def last_number(self) -> int:
        """Read it."""
        return int(self._db.execute("SELECT coalesce(max(number), 0) FROM tasks").fetchone()[0])

    @_told
    def prune(self, *, older_than: float, keep: int) -> int:
        """Delete what is too old and what is too much, with all that belongs to it."""
        self.commit()
        newest = self.last_number()  # stays, so that its number never comes again
        old = self._entries(_OLD, (newest, older_than, keep))
        for entry in old:
            for statement in _FORGET:
                self._write(statement, (entry.status.task,))
            if entry.status.client_id:
                stub = stub_of(entry.status).model_dump_json()
                self._write(
                    "UPDATE tasks SET forgotten = 1, status = ? WHERE number = ?", (stub, entry.number)
                )
            else:
                self._write("DELETE FROM tasks WHERE number = ?", (entry.number,))
        self._write(_FORGET_IDS, (KEPT_IDS,))
        self.commit()
        return len(old)

    @_told
    def reading(self) -> Reading | None:
        """Read it."""
        row = self._db.execute("SELECT utc, host, monotonic, doubt FROM clock").fetchone()
        return None if row is None else Reading(*row)

    @_told
    def note(self, reading: Reading) -> None:
        """Write the row anew."""
        self._write(
            "INSERT OR REPLACE INTO clock (one, utc, host, monotonic, doubt) VALUES (1, ?, ?, ?, ?)",
            (reading.utc, reading.host, reading.monotonic, reading.doubt),
        )

    def take_back(self) -> None:
        """Forget what was written and not committed."""
        if self._db.in_transaction:
            self._db.execute("ROLLBACK")

    def close(self) -> None:
        """Close the file, and give the lock back."""
        self._db.close()
        if self._lock >= 0:
            os.close(self._lock)
            self._lock = -1

    def _write(self, statement: str, values: Iterable[str | float | None] = ()) -> int:
        if not self._db.in_transaction and statement != "BEGIN IMMEDIATE":
            self._db.execute("BEGIN IMMEDIATE")
        return self._db.execute(statement, tuple(values)).rowcount

    def _transition(self, status: TaskStatus, at: float) -> None:
        self._write(
            "INSERT INTO transitions (task, state, at) VALUES (?, ?, ?)", (status.task, str(status.state), at)
        )

    def _entries(
        self, statement: str, values: tuple[str | float, ...], read: Reader = known_part
    ) -> tuple[Entry, ...]:
        return tuple(self._entry(*row, read=read) for row in self._db.execute(statement, values))

    def _entry(
        self,
        number: int,
        on_restart: OnRestart | None,
        test_run: int,
        memory: str,
        status: str,
        *,
        read: Reader,
    ) -> Entry:
        try:
            kept, told = read(TaskMemory, memory.encode()), read(TaskStatus, status.encode())
        except ValidationError as error:
            raise LedgerError(
                f"{self.path}: this program can't read all of its task {number}: "
                f"{problems_in_words(problems_of(error))}; nothing was changed; if a newer version wrote it, "
                "run that one until the task has ended, or choose another --data"
            ) from error
        return Entry(told, number, on_restart, bool(test_run), kept)


def _lock(folder: Path) -> int:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    except OSError as error:
        raise LedgerError(not_writable(Path(error.filename or folder), error)) from error
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(lock)
        raise LedgerLockedError(
            f"{folder}: another executive has this ledger; stop it first, or choose another --data"
        ) from error
    return lock


def owner_of(folder: Path) -> str | None:
    """Return ``<site>/<robot>`` whose ledger a folder has, also while it is open; None when nothing tells."""
    try:
        said = (folder / LOCK).read_text("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
    return said or None


def in_words(path: Path, error: sqlite3.Error) -> str:
    """Return what SQLite said, with what to do about it."""
    name = getattr(error, "sqlite_errorname", "") or ""
    for start, advice in _ADVICE.items():
        if name.startswith(start):
            return f"{path}: {advice} ({error})"
    return f"{path}: SQLite error: {error}"


_ADVICE: Final = {
    "SQLITE_FULL": "the disk is full; accepted requests are safe: free some space and start again",
    "SQLITE_READONLY": "cannot write the file; make its disk and folder writable, or choose another --data",
    "SQLITE_CANTOPEN": "cannot open the file; check the permissions of its folder, or choose another --data",
    "SQLITE_CORRUPT": "the file is damaged and was left as it is; restore a backup, or choose another --data",
    "SQLITE_NOTADB": "not a ledger; the file was left as it is; restore a backup, or choose another --data",
    "SQLITE_IOERR": "the disk failed; accepted requests are safe: check the disk and start again",
}
