"""Two ways to run what can't be sliced: a worker process, or in place with a declared cost."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import dataclass
from typing import Generic

from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.compute import Argument, Job, Result


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
    """One worker process, started with the first work. ``wake`` is called when a result is there."""

    def __init__(self, wake: Callable[[], None]) -> None:
        """Remember whom to wake."""
        self._wake = wake
        self._pool: ProcessPoolExecutor | None = None

    def submit(
        self,
        function: Callable[[Argument], Result],
        argument: Argument,
        *,
        cost: float,  # noqa: ARG002 - real work costs what it costs
    ) -> Job[Result]:
        """Start the work."""
        if self._pool is None:
            self._pool = ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn"))
        future = self._pool.submit(function, argument)
        future.add_done_callback(lambda _: self._wake())
        return ProcessJob(future)

    def close(self) -> None:
        """End the worker, whatever it is at: a process that is told to end must not wait for its work."""
        if self._pool is not None:
            self._pool.shutdown(wait=False, cancel_futures=True)
            self._pool = None
            for child in multiprocessing.active_children():  # the pool's worker: this process starts no other
                child.terminate()


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
