"""A worker that is forked while its process has one thread."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = [
    pytest.mark.processes,
    pytest.mark.skipif(sys.platform != "linux", reason="forks on Linux alone"),
]


def said(*words: str) -> dict[str, object]:
    argv = [sys.executable, "-m", "tests.skills.wire.forks_a_worker", *words]
    ran = subprocess.run(argv, check=True, capture_output=True, text=True, timeout=120.0)
    told: dict[str, object] = json.loads(ran.stdout)
    return told


def test_it_does_the_work_and_one_is_spawned_when_it_has_died() -> None:
    told = said()
    assert told["together"] == ["0.0", "1.0", str(2.0**0.5)]
    assert told["by"] == str(told["forked"])
    assert told["large"] == "2000000"
    assert (told["raised"], told["odd"]) == ("ValueError", "RuntimeError")
    assert told["died"] == "WorkerDiedError"
    assert told["after"] not in ("", str(told["forked"]), "WorkerDiedError", "BrokenProcessPool")


def test_one_that_is_wanted_once_ends_with_its_work() -> None:
    told = said("once")
    assert told["together"] == ["0.0", "1.0", str(2.0**0.5)]
    assert not Path(f"/proc/{told['forked']}").exists()
    assert told["by"] not in ("", str(told["forked"]))


def test_a_process_that_has_threads_forks_none() -> None:
    with subprocess.Popen(  # what runs tests may have one thread
        [sys.executable, "-c", THREADED], stdout=subprocess.PIPE, text=True
    ) as ran:
        assert ran.stdout is not None
        assert ran.stdout.read().strip() == "None"


THREADED = """
import threading
from tandem.skills.wire.forked_worker import fork_worker
done = threading.Event()
threading.Thread(target=done.wait).start()
print(fork_worker(print))
done.set()
"""
