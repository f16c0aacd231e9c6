from __future__ import annotations

import os
import threading

import pytest

from tandem.executive.system.process_usage import anonymous_memory, processor_seconds, shared_memory, usage

NOBODY = 2**22 + 1
"""Above the highest number that Linux gives to a process."""


def test_memory_that_stands_for_no_file_is_counted() -> None:
    before = anonymous_memory(os.getpid())
    kept = b"x" * 50_000_000
    assert anonymous_memory(os.getpid()) - before > 0.9 * len(kept)


def test_handles_and_threads_are_counted() -> None:
    end, before = threading.Event(), usage(os.getpid())
    thread = threading.Thread(target=end.wait)
    thread.start()
    read, write = os.pipe()
    found = usage(os.getpid())
    end.set()
    thread.join()
    os.close(read)
    os.close(write)
    assert (found.handles - before.handles, found.threads - before.threads) == (2, 1)


def test_a_process_at_work_has_used_processor_and_memory() -> None:
    assert processor_seconds(os.getpid()) > 0.0
    assert shared_memory(os.getpid()) > 1.0


def test_of_a_process_that_has_ended_nothing_is_told() -> None:
    assert processor_seconds(NOBODY) == 0.0
    assert shared_memory(NOBODY) != shared_memory(NOBODY)
    with pytest.raises(OSError, match=r"No such file"):
        usage(NOBODY)
