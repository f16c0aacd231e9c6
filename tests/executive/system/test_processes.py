"""Processes that are started: by a spare, and while somebody presses Ctrl-C."""

from __future__ import annotations

import os
import signal
from pathlib import Path

import pytest

from tandem.executive.config.process_settings import WAIT, WorkerSettings
from tandem.executive.system import processes
from tandem.executive.system.processes import Supervisor
from tests.acceptance.live import children, left_behind
from tests.fakes.ports import free_endpoint

pytestmark = pytest.mark.processes


def settings() -> WorkerSettings:
    return WorkerSettings(role="router", endpoint=free_endpoint(), prefix="test/tiago", site="lab")


def test_a_spare_is_made_after_a_while_and_takes_the_next_start(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(processes, "SPARE_AFTER", 0.0)
    with Supervisor(tmp_path) as supervisor:
        supervisor.keep_spare("router")
        supervisor.tidy()
        (spare,) = (pid for pid, words in children(os.getpid()).items() if WAIT in words)
        assert supervisor.start(settings()).process.pid == spare
    assert left_behind([spare]) == ()


def test_a_spare_that_has_died_is_not_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes, "SPARE_AFTER", 0.0)
    with Supervisor(tmp_path) as supervisor:
        supervisor.keep_spare("router")
        supervisor.tidy()
        (spare,) = (pid for pid, words in children(os.getpid()).items() if WAIT in words)
        os.kill(spare, signal.SIGKILL)
        os.waitpid(spare, 0)
        assert supervisor.start(settings()).process.pid != spare


def test_a_ctrl_c_in_the_middle_of_a_start_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    launch, started = processes._launch, list[int]()

    def interrupted(*words: object) -> object:
        process = launch(*words)  # type: ignore[arg-type]
        started.append(process.pid)
        os.kill(os.getpid(), signal.SIGINT)
        return process

    monkeypatch.setattr(processes, "_launch", interrupted)
    with pytest.raises(KeyboardInterrupt), Supervisor(tmp_path) as supervisor:
        supervisor.start(settings())
    assert len(started) == 1
    assert left_behind(started) == ()
