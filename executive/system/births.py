"""The supervisor's side of the nursery: it asks for processes, which are its own children like all others.

It never waits for an answer: who was asked for is polled like who is there, and comes to be meanwhile.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import select
import signal
import socket
import subprocess
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator
from typing import IO, Final

from tandem.executive.system.deferred_signals import signals_later
from tandem.executive.system.process_usage import processor_seconds
from tandem.skills.ports.isolation import isolated, python

ROOM: Final = 8192
"""Characters that the nursery's command line has for that of a process which is born."""
BORN_WITHIN: Final = 20.0
"""Host seconds in which a nursery answers, or at least computes: on a busy machine it may be loading for as
long. Otherwise it is killed, and whoever waits for it is started without it."""
WORKS: Final = 0.1
"""Processor seconds of that time from which on it computes: what hangs takes none."""
PATIENCE: Final = 3
"""Times that it may compute for so long without an answer; loading takes some 3 s of a processor."""
AT_ONCE: Final = 8
"""Births that are asked for before the first is answered: Linux takes 11 messages that nobody has read."""
PR_SET_CHILD_SUBREAPER: Final = 36
"""From linux/prctl.h."""
ONE_THREAD: Final = {"OPENBLAS_NUM_THREADS": "1"}
"""numpy would start threads as it is loaded, and what has threads must not be forked. A robot's matrices are
small: more than one thread does them no sooner."""


class Born:
    """A process that a nursery has made; as far as it is needed like ``subprocess.Popen``."""

    def __init__(self, pid: int) -> None:
        self.pid = pid
        self.returncode: int | None = None

    def poll(self) -> int | None:
        """Return the exit code, negative for a signal; None while it runs."""
        if self.returncode is None:
            try:
                pid, status = os.waitpid(self.pid, os.WNOHANG)
            except ChildProcessError:
                self.returncode = 0  # somebody else has waited for it: how it ended is not known
            else:
                self.returncode = os.waitstatus_to_exitcode(status) if pid else None
        return self.returncode

    def wait(self, timeout: float | None = None) -> int:
        """Wait for its end.

        Raises:
            subprocess.TimeoutExpired: it still runs after ``timeout`` seconds.
        """
        if self.poll() is None:
            end = os.pidfd_open(self.pid)
            try:
                select.select([end], [], [], timeout)
            finally:
                os.close(end)
        if self.poll() is None:
            raise subprocess.TimeoutExpired(f"process {self.pid}", timeout or 0.0)
        return self.returncode or 0

    def terminate(self) -> None:
        """Tell it to end."""
        self._signal(signal.SIGTERM)

    def kill(self) -> None:
        """Kill it."""
        self._signal(signal.SIGKILL)

    def _signal(self, number: int) -> None:
        if self.poll() is None:
            os.kill(self.pid, number)


class Birth:
    """A process that a nursery is asked for, and then what came of it; like ``subprocess.Popen``.

    Args:
        births: whom it is asked of.
        settings: the process's.
        stream: where its words go; open until it is born or not wanted any more.
        otherwise: starts it without the nursery, where that fails.
    """

    def __init__(
        self,
        births: Births,
        settings: str,
        stream: IO[bytes],
        otherwise: Callable[[], subprocess.Popen[bytes]],
    ) -> None:
        self.settings, self.stream = settings, stream
        self._births, self._otherwise = births, otherwise
        self._process: subprocess.Popen[bytes] | Born | None = None
        self._ended: int | None = None
        """How it ended, when it was ended before it was born."""
        self._told: signal.Signals | None = None
        """A signal that came before it was born."""

    @property
    def born(self) -> bool:
        """Whether the nursery has made it."""
        return isinstance(self._process, Born)

    @property
    def pid(self) -> int | None:
        """Its process id; None until it is there."""
        return None if self._process is None else self._process.pid

    @property
    def returncode(self) -> int | None:
        """How it ended, as it was last polled."""
        return self._ended if self._process is None else self._process.returncode

    def poll(self) -> int | None:
        """Return the exit code, negative for a signal; None while it runs, and until it is born."""
        if self._process is None:
            self._births.step()
        return self._ended if self._process is None else self._process.poll()

    def wait(self, timeout: float | None = None) -> int:
        """Wait for its end.

        Raises:
            subprocess.TimeoutExpired: it is not born, or still runs, after ``timeout`` seconds.
        """
        deadline = None if timeout is None else time.monotonic() + timeout
        while self.poll() is None and self._process is None:
            left = BORN_WITHIN if deadline is None else deadline - time.monotonic()
            if left <= 0.0:
                raise subprocess.TimeoutExpired("a birth", timeout or 0.0)
            self._births.await_answer(left)
        if self._process is None:
            return self._ended or 0
        return self._process.wait(None if deadline is None else max(0.0, deadline - time.monotonic()))

    def terminate(self) -> None:
        """Tell it to end; one that is not born yet is told then."""
        self._tell(signal.SIGTERM)

    def kill(self) -> None:
        """Kill it; one that is not born yet dies then."""
        self._tell(signal.SIGKILL)

    def come(self, number: int) -> None:
        """Be this process from now on; 0: be started without the nursery."""
        if number:
            self._process = Born(number)
            if self._told is not None:
                self._tell(self._told)
        elif self._told is not None:
            self.never()
        else:
            self._process = self._otherwise()

    def never(self) -> None:
        """Have ended before it began."""
        self._ended = -(self._told or signal.SIGTERM)

    def _tell(self, number: signal.Signals) -> None:
        if self._process is None:
            self._told = number
        elif self._process.poll() is None:
            os.kill(self._process.pid, number)


class Births:
    """A nursery. Close it when no more shall be born; those that were go on.

    Args:
        log: where its words go.
    """

    def __init__(self, log: IO[bytes] | int) -> None:
        self._line, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._line.setblocking(False)
        self._queue: deque[Birth] = deque()
        """Those that are to be asked for."""
        self._asked: deque[Birth] = deque()
        """Those that were asked for, in the order in which they are answered."""
        self._answer_by = 0.0
        """When the next answer must have come (monotonic seconds)."""
        self._computed, self._patience = 0.0, PATIENCE
        with theirs:
            self._process = subprocess.Popen(  # noqa: S603 - our own interpreter and our own module
                python("-m", "tandem.executive.system.nursery", " " * ROOM),
                env={**ONE_THREAD, **isolated()},
                stdin=theirs.fileno(),
                stdout=log,
                stderr=subprocess.STDOUT,
                start_new_session=True,
            )

    @property
    def pid(self) -> int:
        """Its process id."""
        return self._process.pid

    @property
    def alive(self) -> bool:
        """Whether it can be asked."""
        return self._process.poll() is None

    def bear(
        self, settings: str, stream: IO[bytes], otherwise: Callable[[], subprocess.Popen[bytes]]
    ) -> Birth:
        """Have a process born with these settings; poll what is returned. See ``Birth``."""
        birth = Birth(self, settings, stream, otherwise)
        if not self._queue and not self._asked:
            self._wait_anew()
        self._queue.append(birth)
        self.step()
        return birth

    def step(self) -> None:
        """Take in who was born, ask for who is next, give up a nursery that takes too long. Never waits."""
        with signals_later():
            self._hear()
            self._ask()
            if (self._asked or self._queue) and (not self.alive or self._hangs()):
                self._give_up()
            _adopt(bool(self._asked))

    def await_answer(self, seconds: float) -> None:
        """Wait for a word of the nursery, or for so long."""
        select.select([self._line], [], [], min(seconds, max(0.0, self._answer_by - time.monotonic())))

    def load_ahead(self, role: str) -> None:
        """Load what a role needs, so that its next process begins at once."""
        with contextlib.suppress(OSError):
            self._line.send(role.encode())

    def close(self) -> None:
        """End it, and who is not born yet never is. Closing twice is allowed."""
        if self._line.fileno() < 0:
            return
        for birth in self._queue:
            birth.never()
        self._queue.clear()
        for birth in self._asked:
            birth.terminate()
        with signals_later():
            self._give_up()
        self._line.close()

    def _ask(self) -> None:
        while self._queue and len(self._asked) < AT_ONCE and self.alive:
            birth = self._queue[0]
            _adopt(True)
            try:
                socket.send_fds(self._line, [birth.settings.encode()], [birth.stream.fileno()])
            except BlockingIOError:
                return
            except OSError:
                self._process.kill()  # it has closed its end
                self._process.wait()
                return
            self._asked.append(self._queue.popleft())

    def _hear(self) -> None:
        while self._asked:
            try:
                said = self._line.recv(32)
            except OSError:
                return  # nothing yet
            if not said:
                return
            self._asked.popleft().come(int(said))
            self._wait_anew()

    def _wait_anew(self) -> None:
        self._answer_by, self._patience = time.monotonic() + BORN_WITHIN, PATIENCE

    def _hangs(self) -> bool:
        """Say whether it has neither answered nor computed for too long; it may do the latter a few times."""
        if time.monotonic() < self._answer_by:
            return False
        before, self._computed = self._computed, processor_seconds(self._process.pid)
        self._answer_by, self._patience = time.monotonic() + BORN_WITHIN, self._patience - 1
        return self._patience < 0 or self._computed - before < WORKS

    def _give_up(self) -> None:
        """Kill it. Whoever is born by then says so; who would say it later can't, and ends (``nursery``)."""
        self._process.kill()
        self._process.wait()
        with contextlib.suppress(OSError):
            self._line.shutdown(socket.SHUT_RD)
        self._hear()
        self._without()
        _adopt(False)

    def _without(self) -> None:
        """Start those without a nursery that wait for it."""
        while self._asked or self._queue:
            (self._asked or self._queue).popleft().come(0)


@contextlib.contextmanager
def begun() -> Iterator[Births | None]:
    """Begin a nursery before anything else is known, so that it is ready in time; None where that can't be.

    It says nothing: what it can't load, the process that needs it can't either, and says so.
    """
    if not possible():
        yield None
        return
    made = Births(subprocess.DEVNULL)
    try:
        yield made
    finally:
        made.close()


def possible() -> bool:
    """Say whether this system can do it."""
    return sys.platform == "linux" and hasattr(os, "pidfd_open")


def _adopt(yes: bool) -> None:  # noqa: FBT001 - as the system's call has it
    """Take in processes whose parent ends from now on, below this one, as its own children; or no longer."""
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, int(yes), 0, 0, 0)
