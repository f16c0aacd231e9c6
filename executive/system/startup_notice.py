"""What a start will take up, told before anything moves: read from the ledger while nobody has it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Final, Literal

from tandem.executive.config.on_restart import OnRestart
from tandem.executive.ledger.port import Entry
from tandem.executive.ledger.sqlite import FILE, SqliteLedger
from tandem.skills.ports.tasks import TaskState

Fate = Literal["queued", "resumed", "cancelled", "paused", "asked", "interrupted"]
"""What becomes of a task that has not ended."""
SAID: Final[dict[Fate, str]] = {
    "queued": "is queued",
    "resumed": "resumes",
    "cancelled": "is being cancelled",
    "paused": "is paused; continue it with `tandem resume`",
    "asked": "asks an operator whether to continue; `tandem tasks` shows the question",
    "interrupted": "ends as INTERRUPTED (--on-restart interrupt)",
}
MOVES: Final = "the robot is about to move"
_HELD: Final = frozenset({TaskState.PAUSING, TaskState.PAUSED})
_UNDER_WAY: Final[dict[OnRestart, Fate]] = {"resume": "resumed", "ask": "asked", "interrupt": "interrupted"}


def open_tasks(folder: Path, robot: str) -> tuple[Entry, ...]:
    """Return the tasks of a ledger that have not ended, in the order of their arrival.

    Args:
        folder: where the ledger is; without one there is no task.
        robot: ``<site>/<robot>`` that is to take them up.

    Raises:
        LedgerLockedError: when another process has it.
        LedgerError: when it can't be read, or is another robot's.
    """
    if not (folder / FILE).exists():
        return ()
    ledger = SqliteLedger(folder, robot=robot)
    try:
        return ledger.open_entries()
    finally:
        ledger.close()


def lines(entries: Sequence[Entry], default: OnRestart) -> tuple[str, ...]:
    """Return a line for each task, and a last one when the robot will move by itself.

    Args:
        entries: the tasks that have not ended.
        default: what becomes of a task under way whose request says nothing of it.
    """
    fates = [_fate(entry, default) for entry in entries]
    told = tuple(f"{_name(entry)} {SAID[fate]}" for entry, fate in zip(entries, fates, strict=True))
    waits = bool({"paused", "asked"}.intersection(fates))  # nothing is taken from the queue meanwhile
    moves = bool({"resumed", "cancelled"}.intersection(fates)) or ("queued" in fates and not waits)
    return (*told, MOVES) if moves else told


def _fate(entry: Entry, default: OnRestart) -> Fate:
    state, wish = entry.status.state, entry.on_restart or default
    if state is TaskState.QUEUED:
        return "queued"
    if state is TaskState.CANCELING:
        return "cancelled"
    return "paused" if state in _HELD and wish == "resume" else _UNDER_WAY[wish]


def _name(entry: Entry) -> str:
    asked = {name: value for name, value in entry.status.request.items() if name not in {"task", "id"}}
    return f"{entry.status.task} {json.dumps(asked)}"
