"""A worker that is forked while its process has one thread: it shares what was loaded until then.

A worker that is spawned loads Python, numpy and all else once more: 50 to 60 MB, and half a second.
"""

from __future__ import annotations

import gc
import os
import pickle
import signal
import sys
from collections.abc import Callable
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path

from tandem.skills.ports.compute import Argument, Result


class WorkerDiedError(RuntimeError):
    """The worker has ended at its work."""


class ForkedWorker:
    """The parent's side. It does one piece of work at a time; ``run`` waits for it, so call it in a thread.

    Args:
        pid: the worker's process.
        line: to the worker.
    """

    def __init__(self, pid: int, line: Connection) -> None:
        self.pid, self._line = pid, line
        self.there = True
        """Whether it can be given work."""

    def run(self, function: Callable[[Argument], Result], argument: Argument) -> Result:
        """Have the work done; return the result, or raise what the function raised.

        Raises:
            WorkerDiedError: nothing will come from this worker any more.
        """
        work = pickle.dumps((function, argument), pickle.HIGHEST_PROTOCOL)
        try:
            self._line.send_bytes(work)
            answer = self._line.recv_bytes()
        except (OSError, EOFError) as error:
            self.there = False
            raise WorkerDiedError("the worker process has ended") from error
        value, failed = pickle.loads(answer)  # noqa: S301 - our own worker, on a line that nobody else has
        if failed is not None:
            raise failed
        result: Result = value
        return result

    def kill(self) -> None:
        """End it, whatever it is at. Killing twice is allowed."""
        self.there = False
        if self.pid:
            os.kill(self.pid, signal.SIGKILL)
            os.waitpid(self.pid, 0)
            self.pid = 0
            # Not closed: a thread may be reading, which hears that nobody is there any more.


def fork_worker(begin: Callable[[], None]) -> ForkedWorker | None:
    """Fork a worker off this process; None where that is not sound: it has threads, or is not on Linux.

    ``begin`` is called in the worker before its work.
    """
    if sys.platform != "linux" or len(tuple(Path("/proc/self/task").iterdir())) > 1:
        return None
    ours, theirs = Pipe()
    gc.collect()
    gc.freeze()  # a collection would write to what is shared, in either of them
    pid = os.fork()
    if pid:
        theirs.close()
        return ForkedWorker(pid, ours)
    try:
        ours.close()
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        begin()
        _serve(theirs)
    finally:
        os._exit(0)  # what the parent would tidy up at its end is not this process's


def _serve(line: Connection) -> None:
    """Work until nobody asks any more."""
    while True:
        try:
            work = line.recv_bytes()
        except (OSError, EOFError):
            return
        line.send_bytes(_answer(work))


def _answer(work: bytes) -> bytes:
    try:
        function, argument = pickle.loads(work)  # noqa: S301 - the parent's own
        return pickle.dumps((function(argument), None), pickle.HIGHEST_PROTOCOL)
    except Exception as error:  # noqa: BLE001 - handed on to whoever asks for the result, as a pool does
        return _told(error)


def _told(error: Exception) -> bytes:
    try:
        said = pickle.dumps((None, error), pickle.HIGHEST_PROTOCOL)
        pickle.loads(said)  # noqa: S301 - one that takes more than its words can be written, and not be read
    except Exception:  # noqa: BLE001 - whatever it is that keeps an error from being sent
        return pickle.dumps((None, RuntimeError(f"{type(error).__name__}: {error}")))
    return said
