"""How many threads zenoh has in a process. It reads the environment when its first session is opened."""

from __future__ import annotations

from collections.abc import MutableMapping
from typing import Final

VARIABLE: Final = "ZENOH_RUNTIME"
FEW: Final = "(rx: (worker_threads: 1), acc: (handover: net), app: (handover: net))"
"""One receives, one sends, one does the rest. A process has one link: of zenoh's own two that receive, each
message wakes both."""


def few_threads(environment: MutableMapping[str, str]) -> None:
    """Have zenoh start few threads, unless the user has said how many; for a program's entry point."""
    environment.setdefault(VARIABLE, FEW)
