"""The ``tandem`` command as a user has it: a program in a shell. Nothing here knows what it is made of."""

from __future__ import annotations

import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Final

ROOT: Final = Path(__file__).parents[2]
TANDEM: Final = str(Path(sys.executable).with_name("tandem"))
READY_WITHIN: Final = 120.0
"""Seconds for a start on a machine that others use, too; alone it takes about 5."""
ENDS_WITHIN: Final = 30.0


def free_port() -> int:
    """Return a loopback port that nobody uses."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        number: int = probe.getsockname()[1]
        return number


def environment(more: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return an environment in which nothing names a robot."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith("TANDEM_")}
    return kept | dict(more or {})


@dataclass(frozen=True)
class Done:
    """How a command ended, and what it said."""

    code: int
    out: str
    err: str

    @property
    def said(self) -> str:
        """Everything that reached the screen."""
        return self.out + self.err


def tandem(
    *words: str, env: Mapping[str, str] | None = None, cwd: Path | None = None, within: float = 60.0
) -> Done:
    """Run the command to its end."""
    done = subprocess.run(
        [TANDEM, *words],
        env=environment(env),
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
        timeout=within,
        stdin=subprocess.DEVNULL,
    )
    return Done(done.returncode, done.stdout, done.stderr)


def users_folder(folder: Path) -> Path:
    """Make a folder with packages of the user's that have the names of ours."""
    for name in ("executive", "sim", "skills", "trees"):
        (folder / name).mkdir(parents=True)
        (folder / name / "__init__.py").write_text(
            f"raise SystemExit('the {name} of the user was imported')\n"
        )
    return folder


def commands() -> tuple[str, ...]:
    """Return all commands: the interface's page lists them, and tests/docs compares it with the program."""
    page = (ROOT / "docs" / "interface.md").read_text("utf-8")
    table = page.split("<!-- begin commands -->")[1].split("<!-- end commands -->")[0]
    return tuple(re.findall(r"^\| `tandem ([^`]+)` \|", table, re.MULTILINE))


@dataclass(eq=False)
class Running:
    """A command that goes on, and what it has said so far."""

    process: subprocess.Popen[str]
    lines: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        assert self.process.stdout is not None
        threading.Thread(target=self._read, args=(self.process.stdout,), daemon=True).start()

    def _read(self, stream: IO[str]) -> None:
        self.lines.extend(stream)

    @property
    def said(self) -> str:
        """Everything that reached the screen so far."""
        return "".join(self.lines)

    def await_word(self, word: str, within: float = READY_WITHIN) -> str:
        """Return what was said once the word is in it."""
        deadline, pause = time.monotonic() + within, threading.Event()
        while word not in self.said:
            assert time.monotonic() < deadline, f"no {word!r} within {within:.0f} s:\n{self.said}"
            assert self.process.poll() is None or word in self.said, (
                f"ended with {self.process.returncode} before it said {word!r}:\n{self.said}"
            )
            pause.wait(0.02)
        return self.said

    def end(self, number: signal.Signals = signal.SIGTERM) -> int:
        """Have it end and return its exit code."""
        if self.process.poll() is None:
            self.process.send_signal(number)
        try:
            return self.process.wait(ENDS_WITHIN)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            raise


@contextmanager
def running(*words: str, env: Mapping[str, str] | None = None, cwd: Path | None = None) -> Iterator[Running]:
    """Start the command; end it with the context."""
    with subprocess.Popen(
        [TANDEM, *words],
        env=environment(env),
        cwd=cwd,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as process:
        started = Running(process)
        try:
            yield started
        finally:
            started.end()
