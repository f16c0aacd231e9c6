"""Starts the processes of the system, watches them, starts those again that can be, and ends them all.

Nothing is left behind.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import threading
import time
import uuid
from collections import Counter, deque
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import IO, Final, Self

from tandem.executive.config.process_settings import REFUSED, UNKEPT, WAIT, WorkerSettings
from tandem.executive.system.births import Birth, Births, possible
from tandem.executive.system.deferred_signals import signals_later
from tandem.executive.system.roles.registry import role_of
from tandem.executive.system.roles.role import Kind
from tandem.executive.telemetry.log_files import trim
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.isolation import isolated, python

ENDS_WITHIN: Final = 5.0
"""Seconds that a process has for its own end; then it is killed."""
FOLLOWERS_END_WITHIN: Final = 1.5
"""Seconds in which what a process had started ends by itself, once the process has."""
LAST_WORDS: Final = 12
"""Lines of a dead process's log that are shown."""
RESTARTED: Final[frozenset[Kind]] = frozenset(("skills", "hardware", "executive", "observer", "recorder"))
"""Those that are started again: what they do is taken up. Simulated hardware begins
at its scenario's start."""
ENDS: Final[tuple[Kind, ...]] = ("recorder", "executive", "skills", "observer", "hardware", "router")
"""The order in which they are told to end. To a recorder, a process that goes has died: it goes first."""
NO_USE: Final = (REFUSED, UNKEPT)
"""Exit codes that say that another start would end the same way."""
RESTARTS: Final = 3
"""Times that a process is started again ..."""
RESTARTS_OF_EXECUTIVE: Final = 10
"""The executive's: it gives up a task at which it crashes at the fourth start; two such tasks fit in."""
QUOTED: Final = 2000
"""Characters of a dead process's last words that its successor is told."""
RESTARTS_WITHIN: Final = 60.0
"""... in so many seconds; one that dies more often has a fault that no new start mends."""
TRIM_EVERY: Final = 1.0
"""Seconds between two looks at the size of the logs: within one a process writes some MB at the most."""
SPARE_AFTER: Final = 2.0
"""Seconds after a start at which its spare is made: the start itself needs the processor more."""


@dataclass(frozen=True)
class Death:
    """A process that ended although nobody told it to."""

    role: str
    code: int
    last_words: str

    def head(self) -> str:
        """Return which process it was, and how it ended."""
        how = f"signal {-self.code}" if self.code < 0 else f"exit code {self.code}"
        return f"the {self.role} process ended ({how})"

    def describe(self) -> str:
        """Return it in words for people."""
        said = f"; last output:\n{self.last_words}" if self.last_words else " without output"
        return f"{self.head()}{said}"


@dataclass(eq=False)
class Child:
    """One process and its log."""

    settings: WorkerSettings
    log: Path
    process: subprocess.Popen[bytes] | Birth
    stream: IO[bytes]
    kind: Kind
    """Of its role."""

    @property
    def role(self) -> str:
        """What it plays; of several robots with the robot's name before it, such as ``r2/base``."""
        return self.settings.called

    def last_words(self) -> str:
        """Return the end of its log."""
        lines = self.log.read_text("utf-8", "replace").splitlines()
        return "\n".join(lines[-LAST_WORDS:])


@dataclass(eq=False)
class Supervisor:
    """The parent of all processes. Use as a context: leaving it ends them all.

    Args:
        folder: where the logs go, one file a role.
    """

    folder: Path
    children: list[Child] = field(default_factory=list)
    lineage: str = field(default_factory=lambda: uuid.uuid4().hex[:12])
    """Tells the processes that are started here from those of others (``skills.ports.lease.Claim``)."""
    _generations: Counter[str] = field(default_factory=Counter)
    """How many processes of each role have been started."""
    _restarted: dict[str, deque[float]] = field(default_factory=dict)
    _orphans: dict[int, float] = field(default_factory=dict)
    """Groups of dead processes that may still have followers, and when these are killed."""
    _spares: dict[str, subprocess.Popen[bytes]] = field(default_factory=dict)
    """Processes by role that have loaded all that their role needs, and wait to be told their settings."""
    _spare_at: dict[str, float] = field(default_factory=dict)
    """Roles that shall have a spare, and when the next is made (monotonic seconds)."""
    _births: Births | None = None
    """Has processes born by a fork."""
    _logs: set[Path] = field(default_factory=set)
    """Logs that were begun here."""
    _trim_at: float = 0.0
    """When the size of the logs is looked at next (monotonic seconds)."""

    def __enter__(self) -> Self:
        """Start with no process."""
        self.folder.mkdir(parents=True, exist_ok=True)
        return self

    def __exit__(self, *_: object) -> None:
        """End all."""
        self.end()

    def warm(self, births: Births | None = None) -> None:
        """Load what all processes need in one of which they are born from now on, where that can be.

        ``births``: one that has begun to; it is closed in the end.
        """
        self._births = births
        if births is None and possible():
            with self._log("nursery").open("ab") as stream, signals_later():
                self._births = Births(stream)

    def start(self, settings: WorkerSettings) -> Child:
        """Start one process, in a session of its own: a Ctrl-C reaches the parent alone."""
        role, kind = settings.called, _kind_of(settings)
        log = self._log(role)
        stream = log.open("ab")
        self._generations[role] += 1
        born = {"lineage": self.lineage, "generation": self._generations[role]}
        told = settings.model_copy(update={"parent": os.getpid(), **born})
        with signals_later():
            process = self._spare_of(role, told) or self._begin(told, stream)
            child = Child(settings, log, process, stream, kind)
            self.children.append(child)
        if role in self._spare_at:
            self._spare_at[role] = time.monotonic() + SPARE_AFTER
        return child

    def _spare_of(self, role: str, told: WorkerSettings) -> subprocess.Popen[bytes] | None:
        spare = self._spares.pop(role, None)
        return None if spare is None or not _tell_settings(spare, told) else spare

    def _begin(self, told: WorkerSettings, stream: IO[bytes]) -> subprocess.Popen[bytes] | Birth:
        settings = told.model_dump_json()
        launch = partial(_launch, [settings], stream, subprocess.DEVNULL)
        if self._births is None or not self._births.alive:
            return launch()
        return self._births.bear(settings, stream, launch)

    def logs(self) -> frozenset[Path]:
        """Return the logs of the processes that were started here."""
        return frozenset(self._logs)

    def _log(self, role: str) -> Path:
        """Return a role's log; what an earlier run has left there becomes ``<role>.log.1``."""
        log = self.folder / f"{role.replace('/', '-')}.log"
        if log not in self._logs:
            self._logs.add(log)
            if log.exists():
                log.replace(log.with_name(f"{log.name}.1"))
        return log

    def keep_spare(self, role: str) -> None:
        """Have a spare of a role from soon on, made by ``tidy``: the next start needs not load anything.

        Where processes are born of one that is warm, that one loads it, and there is no other.
        """
        if self._births is not None and self._births.alive:
            self._births.load_ahead(role.rpartition("/")[2])
            return
        self._spare_at[role] = time.monotonic() + SPARE_AFTER

    def spare(self, role: str) -> int | None:
        """Return the process id of a role's spare; None while there is none."""
        spare = self._spares.get(role)
        return None if spare is None else spare.pid

    def _make_spares(self) -> None:
        now = time.monotonic()
        for role, at in self._spare_at.items():
            if now >= at and role not in self._spares:
                with self._log(role).open("ab") as stream, signals_later():
                    self._spares[role] = _launch([WAIT, role.rpartition("/")[2]], stream, subprocess.PIPE)

    def child(self, role: str) -> Child:
        """Return the newest process of a role; KeyError names those that there are."""
        for child in reversed(self.children):
            if child.role == role:
                return child
        raise KeyError(f"no process {role!r}; expected one of {', '.join(c.role for c in self.children)}")

    def deaths(self) -> tuple[Death, ...]:
        """Return the processes that have ended by themselves."""
        return tuple(
            Death(child.role, code, child.last_words())
            for child in self.children
            if (code := child.process.poll()) is not None
        )

    def restart(
        self, role: str, stop: StopState | None = None, stops: Mapping[str, StopState] = MappingProxyType({})
    ) -> bool:
        """Start a dead process again, as it was; return whether it may be.

        Hardware begins with the ``stop`` that was set, and the ``stops`` of the other robots of its world:
        a crash must not release them.
        """
        child, now = self.child(role), time.monotonic()
        bound = RESTARTS_OF_EXECUTIVE if child.settings.role == "executive" else RESTARTS
        times = self._restarted.setdefault(role, deque(maxlen=bound))
        often = len(times) == bound and now - times[0] < RESTARTS_WITHIN
        if child.kind not in RESTARTED or often or child.process.returncode in NO_USE:
            return False
        times.append(now)
        self.children.remove(child)
        child.stream.close()
        if child.process.pid is not None:
            self._orphans[child.process.pid] = now + FOLLOWERS_END_WITHIN
            _tell_group(child.process.pid, signal.SIGTERM)
        died = Death(role, child.process.returncode or 0, child.last_words()).describe()[-QUOTED:]
        fresh: dict[str, object] = {"arguments": {}, "died": died, "stop": stop, "stops": dict(stops)}
        self.start(child.settings.model_copy(update=fresh))
        return True

    def give_up(self, role: str) -> None:
        """Do without a process that nothing needs; end it if it goes on."""
        child = self.child(role)
        if child.process.poll() is None:
            child.process.kill()
            child.process.wait()
        self.children.remove(child)
        child.stream.close()

    def tidy(self) -> None:
        """End the followers of processes that were replaced, make spares, trim long logs. Never waits."""
        now = time.monotonic()
        for group, end in tuple(self._orphans.items()):
            if not _tell_group(group, signal.SIGKILL if now > end else 0):
                del self._orphans[group]
        self._make_spares()
        if now >= self._trim_at:
            self._trim_at = now + TRIM_EVERY
            for log in {child.log for child in self.children}:
                trim(log)

    def end(self) -> None:
        """Tell all to end and kill those that don't: the executive first, so that its goals come to rest.

        Its leaves cancel their goals while the skills still live; the hardware outlives the skills, and the
        router everybody.
        """
        if self._births is not None:
            self._births.close()
            self._births = None
        for spare in self._spares.values():
            _dismiss(spare)
        self._spares.clear()
        self._spare_at.clear()
        for kind in ENDS:
            going = [child for child in self.children if child.kind == kind]
            for child in going:
                if child.process.poll() is None:
                    child.process.terminate()
            deadline = time.monotonic() + ENDS_WITHIN
            for child in going:
                _end(child, deadline)
        self.children.clear()
        for group in self._orphans:
            _end_group(group)
        self._orphans.clear()


def _kind_of(settings: WorkerSettings) -> Kind:
    """Return the kind of a process's role; one that nobody declares refuses to start by itself."""
    try:
        return role_of(settings).kind
    except LookupError:
        return "skills"


def _launch(words: list[str], stream: IO[bytes], stdin: int) -> subprocess.Popen[bytes]:
    return subprocess.Popen(  # noqa: S603 - our own interpreter and our own module
        python("-m", "tandem.executive.system.worker", *words),
        env=isolated(),
        stdin=stdin,
        stdout=stream,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )


def _tell_settings(spare: subprocess.Popen[bytes], settings: WorkerSettings) -> bool:
    """Have a spare begin; False when it has ended."""
    assert spare.stdin is not None, "a spare was started with a pipe"
    try:
        spare.stdin.write(settings.model_dump_json().encode() + b"\n")
        spare.stdin.close()
    except OSError:
        _dismiss(spare)
        return False
    return True


def _dismiss(spare: subprocess.Popen[bytes]) -> None:
    """End a spare that nobody needs; it ends by itself, too, when its parent is gone."""
    spare.kill()
    spare.wait()
    if spare.stdin is not None and not spare.stdin.closed:
        with contextlib.suppress(OSError):
            spare.stdin.close()


def _end(child: Child, deadline: float) -> None:
    try:
        child.process.wait(max(0.0, deadline - time.monotonic()))
    except subprocess.TimeoutExpired:
        child.process.kill()
        child.process.wait()
    if child.process.pid is not None:
        _end_group(child.process.pid)
    child.stream.close()


def _tell_group(group: int, number: int) -> bool:
    """Send a signal to what is left of a group; return whether anything is."""
    try:
        os.killpg(group, number)
    except ProcessLookupError:
        return False
    return True


def _end_group(group: int) -> None:
    """End what a process had started and left behind, such as its worker when it was killed itself.

    Each process leads a group of its own. Its followers first get the time to tidy up after themselves.
    """
    for number in (0, signal.SIGTERM, signal.SIGKILL):
        if _is_empty_after(group, number):
            return


def _is_empty_after(group: int, number: int) -> bool:
    deadline, pause = time.monotonic() + FOLLOWERS_END_WITHIN, threading.Event()
    try:
        os.killpg(group, number)
        while time.monotonic() < deadline:
            os.killpg(group, 0)
            pause.wait(0.01)  # nobody tells when the last of a group has ended
    except ProcessLookupError:
        return True
    return False
