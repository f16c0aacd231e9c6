"""A Ctrl-C in the middle of a lockstep period waits for its end."""

from __future__ import annotations

import signal
from types import SimpleNamespace

import pytest

from tandem.executive.system.systems import LockstepSystem


def test_a_period_is_whole_when_a_ctrl_c_ends_the_run() -> None:
    done: list[str] = []

    def step() -> None:
        signal.raise_signal(signal.SIGINT)
        done.append("whole")

    system = object.__new__(LockstepSystem)
    system.lockstep = SimpleNamespace(step=step)  # type: ignore[assignment]
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            system.advance()
    finally:
        signal.signal(signal.SIGINT, before)
    assert done == ["whole"]
