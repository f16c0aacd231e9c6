"""Brings the lines of all processes' logs together while they are written."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import IO


@dataclass(eq=False)
class LogRelay:
    """Reads what has been added to the logs of a folder, and writes it on, line by line.

    Args:
        folder: where each process writes a log of its own (``*.log``).
        sinks: where the lines go.
    """

    folder: Path
    sinks: tuple[IO[str], ...]
    _read: dict[Path, int] = field(default_factory=dict)

    def step(self, *, last: bool = False) -> None:
        """Write on what is whole; with ``last`` also what is not."""
        if not self.sinks:
            return
        for log in sorted(self.folder.glob("*.log")):
            self._relay(log, last=last)

    def _relay(self, log: Path, *, last: bool) -> None:
        start = self._read.get(log, 0)
        if log.stat().st_size == start:
            return
        with log.open("rb") as stream:
            stream.seek(start)
            text = stream.read()
        whole = text if last else text[: text.rfind(b"\n") + 1]
        self._read[log] = start + len(whole)
        if whole:
            for sink in self.sinks:
                sink.write(whole.decode("utf-8", "replace"))
                sink.flush()
