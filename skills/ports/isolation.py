"""Python programs of ours see the installed packages, and nothing of the folder that the user is in.

``python -m`` and ``python -c`` put the current folder first in ``sys.path``, and so does each process that
multiprocessing spawns: a user's folder called ``sim`` or ``skills`` would replace ours. ``-P`` (Python 3.11)
prevents it for a process, ``PYTHONSAFEPATH`` for those that it starts.
"""

from __future__ import annotations

import os
import sys
from collections.abc import MutableMapping
from typing import Final

VARIABLE: Final = "PYTHONSAFEPATH"


def python(*words: str) -> list[str]:
    """Return the command line of a Python program of ours: ``python("-m", "tandem...", ...)``."""
    return [sys.executable, "-P", *words]


def isolated() -> dict[str, str]:
    """Return this process's environment for a program of ours, whose own children are isolated, too."""
    return {**os.environ, VARIABLE: "1"}


def isolate_children(environment: MutableMapping[str, str]) -> None:
    """Have all processes that this one starts from now on isolated; for a program's entry point."""
    environment[VARIABLE] = "1"
