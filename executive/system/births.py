"""The supervisor's side of the nursery: it asks for processes, which are its own children like all others."""

from __future__ import annotations

import contextlib
import ctypes
import os
import select
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from typing import IO, Final

from tandem.executive.system.isolation import isolated, python

ROOM: Final = 8192
"""Characters that the nursery's command line has for that of a process which is born."""
BORN_WITHIN: Final = 20.0
"""Host seconds in which a nursery answers; it may be loading for several of them on a busy machine."""
PR_SET_CHILD_SUBREAPER: Final = 36
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


class Births:
    """A nursery. Close it when no more shall be born; those that were go on.

    Args:
        log: where its words go.
    """

    def __init__(self, log: IO[bytes] | int) -> None:
        self._line, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._line.settimeout(BORN_WITHIN)
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

    def bear(self, settings: str, stream: IO[bytes]) -> Born | None:
        """Have a process born with these settings; None where that can't be."""
        if not self.alive:
            return None
        try:
            with _adopting():
                socket.send_fds(self._line, [settings.encode()], [stream.fileno()])
                number = int(self._line.recv(32) or b"0")
        except OSError:
            self._process.kill()  # late answers would be taken for those of others
            return None
        return Born(number) if number else None

    def load_ahead(self, role: str) -> None:
        """Load what a role needs, so that its next process begins at once."""
        with contextlib.suppress(OSError):
            self._line.send(role.encode())

    def close(self) -> None:
        """End it. Closing twice is allowed."""
        self._line.close()
        self._process.kill()
        self._process.wait()


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


@contextlib.contextmanager
def _adopting() -> Iterator[None]:
    """Take in processes whose parent ends meanwhile, below this one: they become its children."""
    prctl = ctypes.CDLL(None).prctl
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    try:
        yield
    finally:
        prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0)
