"""Two ways to run what can't be sliced: a worker process, or in place with a declared cost."""

from __future__ import annotations

import multiprocessing
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import dataclass
from typing import Generic

from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.compute import Argument, Job, Result
from tandem.skills.wire.forked_worker import ForkedWorker


@dataclass(frozen=True)
class ProcessJob(Generic[Result]):
    """Work in a worker process."""

    future: Future[Result]

    def done(self) -> bool:
        """Say whether the result is there."""
        return self.future.done()

    def result(self) -> Result:
        """Return the result, or raise what the function raised."""
        return self.future.result()


class ProcessCompute:
    """One worker process: one that was forked, while it lives, else one that is spawned with the next work.

    Args:
        wake: called when a result is there.
        worker: was forked before this process had threads.
        once: whether the worker ends when it has nothing to do: more will hardly come.
    """

    def __init__(
        self, wake: Callable[[], None], worker: ForkedWorker | None = None, *, once: bool = False
    ) -> None:
        self._wake, self._worker, self._once = wake, worker, once
        self._pool: Executor | None = None
        self._under_way = 0
        self._lock = threading.RLock()
        """Results come in another thread; what is cancelled ends in the one that cancels."""

    def submit(
        self,
        function: Callable[[Argument], Result],
        argument: Argument,
        *,
        cost: float,  # noqa: ARG002 - real work costs what it costs
    ) -> Job[Result]:
        """Start the work."""
        worker = self._worker
        with self._lock:
            if worker is not None and not worker.there:
                worker = self._worker = None
                self._end_pool()
            if self._pool is None:
                self._pool = _spawned() if worker is None else ThreadPoolExecutor(1)
            self._under_way += 1
            future = self._pool.submit(
                *((function, argument) if worker is None else (worker.run, function, argument))
            )
        future.add_done_callback(self._ended)
        return ProcessJob(future)

    def close(self) -> None:
        """End the worker, whatever it is at: a process that is told to end must not wait for its work."""
        with self._lock:
            if self._worker is not None:
                self._worker.kill()
            spawned = self._worker is None and self._pool is not None
            self._end_pool()
        if spawned:
            for child in multiprocessing.active_children():  # the pool's worker: this process starts no other
                child.terminate()

    def _ended(self, _: Future[Result]) -> None:
        with self._lock:
            self._under_way -= 1
            if self._once and not self._under_way:
                if self._worker is not None:
                    self._worker.kill()
                self._end_pool()
        self._wake()

    def _end_pool(self) -> None:
        pool, self._pool = self._pool, None
        if pool is not None:
            pool.shutdown(wait=False, cancel_futures=True)


def _spawned() -> Executor:
    return ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn"))


@dataclass(frozen=True)
class ChargedJob(Generic[Result]):
    """Work that was done in place and is handed out when its cost has passed."""

    clocks: Clocks
    ready_at: float
    value: Result | None
    error: Exception | None

    def done(self) -> bool:
        """Say whether the declared cost has passed."""
        return robot_seconds(self.clocks) >= self.ready_at - 1e-9

    def result(self) -> Result:
        """Return the result, or raise what the function raised."""
        if self.error is not None:
            raise self.error
        assert self.value is not None
        return self.value


class InlineCompute:
    """Does the work at once and charges robot time: lockstep, and tests."""

    def __init__(self, clocks: Clocks) -> None:
        """Remember the clock that is charged."""
        self._clocks = clocks

    def submit(
        self,
        function: Callable[[Argument], Result],
        argument: Argument,
        *,
        cost: float,
    ) -> Job[Result]:
        """Do the work; its result comes ``cost`` robot seconds later."""
        ready_at = robot_seconds(self._clocks) + cost
        try:
            return ChargedJob(self._clocks, ready_at, function(argument), None)
        except Exception as error:  # noqa: BLE001 - handed on to whoever asks for the result, as a pool does
            return ChargedJob(self._clocks, ready_at, None, error)

    def close(self) -> None:
        """Nothing to end."""
