"""Where figures come from: the command, the commit, the date and the machine."""

from __future__ import annotations

import os
import platform
import re
import subprocess
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Final

from tandem.skills.ports.message import Message

PACKAGES: Final = (
    "tandem-executive",
    "py-trees",
    "pybullet",
    "pybullet-arm64",
    "ompl",
    "eclipse-zenoh",
    "pydantic",
    "pin",
    "coal",
)
"""Whose versions change what comes out."""
OUTPUTS: Final = ("--report", "--figures")
"""Options that say where results are written."""
GIT_WITHIN: Final = 10.0
"""Host seconds for a question to git."""


class Provenance(Message):
    """Where a result comes from."""

    command: str
    """As it was typed, without the files that it writes: they are of one machine and change nothing."""
    commit: str
    """Hash of the checkout's commit; empty where the program runs from no checkout."""
    changed: bool
    """Whether files of the checkout differed from that commit."""
    date: str
    """UTC, as ``2026-11-26``."""
    machine: str
    """Processor, cores and system."""
    load: float
    """Load average over one minute when the command began to write."""
    python: str
    packages: dict[str, str]

    def line(self) -> str:
        """Return it as one line of Markdown, without the packages."""
        commit = f"commit `{self.commit[:10]}`" if self.commit else "no checkout"
        changes = ", with local changes" if self.changed else ""
        return f"`{self.command}`: {commit}{changes}, {self.date}; {self.machine}; Python {self.python}"


def provenance(words: Sequence[str], utc: float) -> Provenance:
    """Return where a result comes from that this process has made.

    Args:
        words: the command line, the program's path first.
        utc: now, in seconds.
    """
    commit, changed = checkout()
    return Provenance(
        command=" ".join((Path(words[0]).name, *_without_outputs(words[1:]))),
        commit=commit,
        changed=changed,
        date=datetime.fromtimestamp(utc, UTC).date().isoformat(),
        machine=f"{processor()}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}",
        load=round(os.getloadavg()[0], 2),
        python=platform.python_version(),
        packages=installed_packages(),
    )


def _without_outputs(words: Sequence[str]) -> Iterator[str]:
    rest = iter(words)
    for word in rest:
        if word in OUTPUTS:
            next(rest, "")
        elif not word.startswith(tuple(f"{option}=" for option in OUTPUTS)):
            yield word


def installed(package: str) -> str:
    """Return a package's version, "" when it is not installed."""
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def installed_packages() -> dict[str, str]:
    """Return the versions of those of ``PACKAGES`` that are installed: of pybullet's two builds, one is."""
    return {name: there for name in PACKAGES if (there := installed(name))}


def processor() -> str:
    """Return the processor's name, as the kernel tells it."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return platform.processor()
    found = re.search(r"^model name\s*: (.*)$", text, re.MULTILINE)
    return found[1] if found else platform.processor()


def checkout() -> tuple[str, bool]:
    """Return our checkout's commit and whether files differ from it; ("", False) where there is none."""
    folder = Path(__file__).resolve().parents[2]
    try:
        commit = _git(folder, "rev-parse", "HEAD")
        return commit, bool(_git(folder, "status", "--porcelain", "--untracked-files=no"))
    except (OSError, subprocess.SubprocessError):
        return "", False


def _git(folder: Path, *words: str) -> str:
    done = subprocess.run(  # noqa: S603 - git, with our own words
        ["git", "-C", str(folder), *words],  # noqa: S607 - the user's git, wherever it is
        capture_output=True,
        text=True,
        check=True,
        timeout=GIT_WITHIN,
    )
    return done.stdout.strip()
