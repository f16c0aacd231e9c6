"""Where a developer finds what happened: a file, or standard error."""

from __future__ import annotations

import logging
import sys
from dataclasses import dataclass
from pathlib import Path

from tandem.executive.cli.errors import CommandError
from tandem.executive.config.log_format import LogFormat
from tandem.executive.telemetry.logs import formatter


@dataclass(frozen=True)
class LogOptions:
    """What was said about logs before the command's name."""

    file: Path | None = None
    verbose: bool = False
    format: LogFormat = "text"

    def apply(self) -> None:
        """Send the logs there; nowhere, when nothing was said.

        Raises:
            CommandError: when the file can't be written.
        """
        handlers: list[logging.Handler] = []
        if self.file is not None:
            try:
                self.file.parent.mkdir(parents=True, exist_ok=True)
                handlers.append(logging.FileHandler(self.file, encoding="utf-8"))
            except OSError as error:
                raise CommandError(f"--log {self.file}: cannot write: {error.strerror}") from error
        if self.verbose:
            handlers.append(logging.StreamHandler(sys.stderr))
        for handler in handlers:
            handler.setFormatter(formatter(self.format, "tandem"))
        logging.basicConfig(
            level=logging.DEBUG if self.verbose else logging.INFO,
            handlers=handlers or [logging.NullHandler()],
            force=True,
        )
