"""What both ways to compute keep to: in place and charged, and in a worker process."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from tandem.skills.ports.compute import Compute
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.workers import InlineCompute, ProcessCompute
from tandem.skills.wire.zenoh_ends import Waker


@dataclass
class Desk:
    """A compute, and a way to wait that suits it."""

    compute: Compute
    until: Callable[[Callable[[], bool]], bool]


@pytest.fixture(scope="module", params=["inline", "process"])
def desk(request: pytest.FixtureRequest) -> Iterator[Desk]:
    if request.param == "inline":
        clocks = SteppedClocks()

        def pass_time(condition: Callable[[], bool]) -> bool:
            clocks.advance(0.1)
            return condition()

        yield Desk(InlineCompute(clocks), pass_time)
        return
    waker = Waker()
    worker = ProcessCompute(waker.wake)

    def wait(condition: Callable[[], bool]) -> bool:
        deadline = time.monotonic() + 20.0
        while not (held := condition()) and time.monotonic() < deadline:
            waker.wait(1.0)
        return held

    yield Desk(worker, wait)
    worker.close()


def test_work_is_not_done_when_it_is_handed_in(desk: Desk) -> None:
    job = desk.compute.submit(math.factorial, 20_000, cost=0.05)
    assert not job.done()
    assert desk.until(job.done)
    assert job.result() == math.factorial(20_000)


def test_what_the_work_raises_is_raised_to_who_asks_for_the_result(desk: Desk) -> None:
    job = desk.compute.submit(math.sqrt, -1.0, cost=0.05)
    assert desk.until(job.done)
    with pytest.raises(ValueError, match="math domain error"):
        job.result()
    again = desk.compute.submit(math.sqrt, 4.0, cost=0.05)
    assert desk.until(again.done)
    assert again.result() == 2.0


def test_jobs_under_way_together_keep_their_results_apart(desk: Desk) -> None:
    jobs = [desk.compute.submit(math.sqrt, float(number), cost=0.05) for number in range(5)]
    assert desk.until(lambda: all(job.done() for job in jobs))
    assert [job.result() for job in jobs] == [math.sqrt(number) for number in range(5)]


def test_a_result_can_be_asked_for_twice(desk: Desk) -> None:
    job = desk.compute.submit(math.sqrt, 9.0, cost=0.05)
    assert desk.until(job.done)
    assert job.result() == job.result() == 3.0


def test_in_place_costs_the_declared_robot_time_and_no_less() -> None:
    clocks = SteppedClocks()
    job = InlineCompute(clocks).submit(math.sqrt, 4.0, cost=0.05)
    clocks.advance(0.04)
    assert not job.done()
    clocks.advance(0.01)
    assert job.done()


def test_closing_ends_the_worker_process() -> None:
    waker = Waker()
    worker = ProcessCompute(waker.wake)
    job = worker.submit(_process_id, None, cost=0.0)
    while not job.done():
        waker.wait(1.0)
    worker.close()
    deadline = time.monotonic() + 5.0
    while _alive(job.result()) and time.monotonic() < deadline:
        waker.wait(0.02)
    assert not _alive(job.result())


def _process_id(_: None) -> int:
    return os.getpid()


def _alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True
