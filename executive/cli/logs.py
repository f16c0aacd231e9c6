"""Where a developer finds what happened: a file, or standard error."""

from __future__ import annotations

import logging
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import typer

from tandem.executive.cli.errors import CommandError
from tandem.executive.config.log_format import LogFormat
from tandem.executive.telemetry.logs import formatter

_OF_PLUGINS: Final = "tandem.skills.ports.plugins"
"""The log of their loader, which most commands have no need to import."""


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
        else:
            self._say_what_is_broken()
        for handler in handlers:
            handler.setFormatter(formatter(self.format, "tandem"))
        logging.basicConfig(
            level=logging.DEBUG if self.verbose else logging.INFO,
            handlers=handlers or [logging.NullHandler()],
            force=True,
        )

    @staticmethod
    def _say_what_is_broken() -> None:
        """Say on standard error which plug-ins a command leaves out, once; a process of ours logs it only."""
        log = logging.getLogger(_OF_PLUGINS)
        for handler in [each for each in log.handlers if isinstance(each, _Teller)]:
            log.removeHandler(handler)
        log.addHandler(_Teller())


class _Teller(logging.Handler):
    """Says each warning once, in plain words."""

    def __init__(self) -> None:
        super().__init__(logging.WARNING)
        self._said: set[str] = set()

    def emit(self, record: logging.LogRecord) -> None:
        """Say it on what standard error is now."""
        text = record.getMessage()
        if text not in self._said:
            self._said.add(text)
            typer.secho(text, err=True, fg=typer.colors.YELLOW if sys.stderr.isatty() else None)
