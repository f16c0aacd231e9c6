"""Runs a series beside each other, one process for each core, and tells each run as it ends."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from typing import TypeVar

from tandem.skills.ports.message import Message

Run = TypeVar("Run", bound=Message)


def run_number(work: Callable[[int], Run], first: int, run: int) -> Run:
    """Do the work for run ``first + run``."""
    return work(first + run)


def series(work: Callable[[int], Run], runs: int, *, jobs: int) -> Iterator[Run]:
    """Yield the results of ``work(0)`` to ``work(runs - 1)``, as they end.

    Args:
        work: picklable; each call is independent of the others.
        runs: how many.
        jobs: how many processes; with 1 the runs are made here, in order.
    """
    if jobs == 1:
        yield from (work(run) for run in range(runs))
        return
    context = multiprocessing.get_context("spawn")
    # A new process for each run: what a library keeps between two runs must not reach the next one.
    with ProcessPoolExecutor(jobs, mp_context=context, max_tasks_per_child=1) as pool:
        futures = [pool.submit(work, run) for run in range(runs)]
        for future in as_completed(futures):
            yield future.result()
