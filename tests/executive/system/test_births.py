"""Processes that are born by a fork of one that has loaded what they need."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.system.births import Born, possible
from tandem.executive.system.processes import Supervisor
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


def test_who_is_born_is_a_child_that_shows_its_settings(supervisor: Supervisor) -> None:
    born = supervisor.start(router()).process
    assert isinstance(born, Born)
    assert '"role":"router"' in children(os.getpid())[born.pid]
    born.kill()
    assert born.wait(5.0) == -signal.SIGKILL
    assert [death.code for death in supervisor.deaths()] == [-signal.SIGKILL]
    supervisor.end()
    assert left_behind([born.pid]) == ()
    assert not [words for words in children(os.getpid()).values() if "nursery" in words]


def test_without_the_nursery_processes_are_started_all_the_same(supervisor: Supervisor) -> None:
    (nursery,) = (pid for pid, words in children(os.getpid()).items() if "nursery" in words)
    os.kill(nursery, signal.SIGKILL)
    child = supervisor.start(router())
    assert not isinstance(child.process, Born)
    assert child.process.poll() is None
