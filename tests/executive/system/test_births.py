"""Processes that are born by a fork of one that has loaded what they need."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.system.births import AT_ONCE, Birth, possible
from tandem.executive.system.processes import Child, Supervisor
from tests.acceptance.live import children, left_behind
from tests.fakes.ports import free_endpoint

pytestmark = [
    pytest.mark.processes,
    pytest.mark.xdist_group("processes"),
    pytest.mark.skipif(not possible(), reason="only Linux lets a process adopt"),
]


@pytest.fixture
def supervisor(tmp_path: Path) -> Iterator[Supervisor]:
    with Supervisor(tmp_path) as made:
        made.warm()
        yield made


def router() -> WorkerSettings:
    return WorkerSettings(role="router", endpoint=free_endpoint(), prefix="test/tiago", site="lab")


def come(supervisor: Supervisor, child: Child) -> int:
    """Look after the processes until this one is there; return its id."""
    deadline = time.monotonic() + 30.0
    while child.process.pid is None:
        assert time.monotonic() < deadline, "it is not born"
        supervisor.deaths()
    return child.process.pid


def nursery() -> int:
    """Return its id: what was forked a moment ago shows its own words once it has begun."""
    deadline = time.monotonic() + 30.0
    while not (found := [pid for pid, words in children(os.getpid()).items() if "nursery" in words]):
        assert time.monotonic() < deadline, "there is none"
    return found[0]


def test_who_is_born_is_a_child_that_shows_its_settings(supervisor: Supervisor) -> None:
    child = supervisor.start(router())
    pid = come(supervisor, child)
    assert isinstance(child.process, Birth)
    assert child.process.born
    assert '"role":"router"' in children(os.getpid())[pid]
    child.process.kill()
    assert child.process.wait(5.0) == -signal.SIGKILL
    assert [death.code for death in supervisor.deaths()] == [-signal.SIGKILL]
    supervisor.end()
    assert left_behind([pid]) == ()
    assert not [words for words in children(os.getpid()).values() if "nursery" in words]


def test_more_are_born_than_may_be_asked_for_at_once(supervisor: Supervisor) -> None:
    started = [supervisor.start(router()) for _ in range(AT_ONCE + 2)]
    pids = {come(supervisor, child) for child in started}
    assert len(pids) == len(started)
    assert all(isinstance(child.process, Birth) and child.process.born for child in started)


def test_without_the_nursery_processes_are_started_all_the_same(supervisor: Supervisor) -> None:
    os.kill(nursery(), signal.SIGKILL)
    child = supervisor.start(router())
    assert come(supervisor, child) in children(os.getpid())
    assert child.process.poll() is None


def test_a_nursery_that_hangs_holds_nobody_up_and_is_given_up(
    supervisor: Supervisor,
) -> None:
    hangs = nursery()
    os.kill(hangs, signal.SIGSTOP)
    first, second = supervisor.start(router()), supervisor.start(router())
    assert supervisor.deaths() == ()
    assert (first.process.pid, second.process.pid) == (None, None)
    third = supervisor.start(router())
    assert third.process.pid is None
    first.process.terminate()
    assert supervisor._births is not None
    for _ in range(2):  # it may have computed before the first look
        supervisor._births._answer_by = 0.0  # the seconds have passed
        supervisor.deaths()
    assert [(death.code, death.role) for death in supervisor.deaths()] == [(-signal.SIGTERM, "router")]
    assert hangs not in children(os.getpid())
    assert {come(supervisor, second), come(supervisor, third)} <= children(os.getpid()).keys()


def test_who_is_not_born_when_all_end_never_is(supervisor: Supervisor) -> None:
    os.kill(nursery(), signal.SIGSTOP)
    child = supervisor.start(router())
    supervisor.end()
    assert child.process.poll() == -signal.SIGTERM
    assert not [words for words in children(os.getpid()).values() if "worker" in words]
