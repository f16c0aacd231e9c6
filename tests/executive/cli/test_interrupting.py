"""A command with processes ends once, whatever tells it to and however often."""

from __future__ import annotations

import signal
from collections.abc import Iterator

import pytest

from tandem.executive.cli.interrupting import ENDING, ends_once


@pytest.fixture(autouse=True)
def handlers() -> Iterator[None]:
    before = {each: signal.getsignal(each) for each in ENDING}
    yield
    for each, known in before.items():
        signal.signal(each, known)


@pytest.mark.parametrize("first", ENDING)
def test_the_first_signal_ends_and_the_others_leave_the_end_alone(first: signal.Signals) -> None:
    """After a second Ctrl-C "all processes are stopped" stood there, and eight were running."""
    tidied = []

    def work() -> None:
        try:
            signal.raise_signal(first)
        finally:
            for each in ENDING:
                signal.raise_signal(each)
                tidied.append(each)

    with pytest.raises(KeyboardInterrupt), ends_once():
        work()
    assert tidied == list(ENDING)


def test_a_terminal_that_goes_ends_nothing_that_was_told_to_outlive_it() -> None:
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    with ends_once():
        signal.raise_signal(signal.SIGHUP)


def test_what_ends_by_itself_leaves_the_signals_as_they_were() -> None:
    before = [signal.getsignal(each) for each in ENDING]
    with ends_once():
        pass
    assert [signal.getsignal(each) for each in ENDING] == before
