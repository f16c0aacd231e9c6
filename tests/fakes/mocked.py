"""A router, an executive and a robot whose skills are mocked, in a process of their own."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).parents[2]


@contextmanager
def mocked_system(
    endpoint: str, *, skill_seconds: float = 0.0, parts: str = "robot,executive"
) -> Iterator[None]:
    """Run it at a loopback endpoint until the context is left."""
    program = str(ROOT / "tests" / "executive" / "mock_system.py")
    port = endpoint.rsplit(":", 1)[1]
    with subprocess.Popen(
        [sys.executable, program, port, str(skill_seconds), parts],
        cwd=ROOT,
        env={"PYTHONPATH": "."},
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        try:
            assert process.stdout.readline() == "ready\n"
            yield
        finally:
            process.kill()
