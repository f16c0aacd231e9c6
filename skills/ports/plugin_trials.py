"""Imports what is new in a process of its own: a plug-in that ends its process ends that one only.

What a plug-in does in C, or with ``os._exit``, no ``except`` catches and no alarm ends. So before a process
imports a plug-in that is not known (``plugin_memory``), a child imports it. The child tells on a pipe which
one it takes next. One that falls silent is ended, and another one goes on with the rest.
"""

from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from importlib.metadata import EntryPoint
from typing import IO, TYPE_CHECKING, Final

from tandem.skills.ports.isolation import isolated, python
from tandem.skills.ports.plain_json import read_json
from tandem.skills.ports.plugin_memory import remember

if TYPE_CHECKING:
    from tandem.skills.ports.plugins import Plugin

STARTS_WITHIN: Final = 20.0
"""Seconds that a child has besides: for Python, for our own modules, for a busy machine."""
WORDS: Final = 200
"""Characters that are told of the last line that a plug-in wrote."""


class ChildEndedError(Exception):
    """The child ended, or fell silent and was ended; the text says which."""


def try_out(plugins: Sequence[Plugin], within: float) -> dict[str, str]:
    """Import plug-ins in a child, and remember what became of it.

    Args:
        plugins: those that are not known as they are now.
        within: seconds for the import of one.

    Returns:
        By ``Plugin.key`` how the import ended its process, or that it did not end; nothing for no harm.
    """
    found = _tried(plugins, within)
    tried = {plugin: found.get(plugin.key, "") for plugin in plugins}
    remember(tried)
    return {plugin.key: error for plugin, error in tried.items()}


def _tried(plugins: Sequence[Plugin], within: float) -> dict[str, str]:
    """Return by key what became of the processes that imported those that do harm."""
    harm, rest = dict[str, str](), list(plugins)
    while rest and (ended := _first_harm(rest, within)) is not None:
        at, why = ended
        harm[rest[at].key] = f"its import {why}"
        rest = rest[at + 1 :]
    return harm


def _first_harm(plugins: Sequence[Plugin], within: float) -> tuple[int, str] | None:
    """Import plug-ins in a child. Return the place of the one that ended it, and how; None when none did."""
    at = -1
    entries = [(each.name, each.target, each.group.entry_points) for each in plugins]
    given = json.dumps({"path": sys.path, "entries": entries})
    try:
        for line in told_by_child(__name__, given, lambda last: within if last else STARTS_WITHIN):
            at = int(line)
    except ChildEndedError as ended:
        # When no plug-in was at work yet there is nobody to blame; the import in this process says more.
        return None if at < 0 else (at, str(ended))
    return None


def told_by_child(module: str, given: str, patience: Callable[[bytes], float]) -> Iterator[bytes]:
    """Start a module of ours and give the lines that it tells, until it has told all.

    Args:
        module: it gets the number of the pipe on which it tells, and what it is given, as its arguments. Its
            last line is empty.
        given: for it.
        patience: takes the last line, empty before the first, and returns the seconds within which the next
            one must come.

    Raises:
        ChildEndedError: when it ends before, or when no line comes in time.
    """
    ours, theirs = os.pipe()
    with tempfile.TemporaryFile() as words:
        child = subprocess.Popen(  # noqa: S603 - our own interpreter and our own module
            python("-m", module, str(theirs), given),
            env=isolated(),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=words,
            pass_fds=(theirs,),
            start_new_session=True,
        )
        os.close(theirs)
        try:
            yield from _lines(ours, child, words, patience)
        finally:
            child.kill()
            child.wait()
            os.close(ours)


def _lines(
    pipe: int, child: subprocess.Popen[bytes], words: IO[bytes], patience: Callable[[bytes], float]
) -> Iterator[bytes]:
    text, waits = b"", patience(b"")
    deadline = time.monotonic() + waits
    while select.select([pipe], [], [], max(0.0, deadline - time.monotonic()))[0]:
        came = os.read(pipe, 65_536)
        if not came:
            raise ChildEndedError(f"{_how(child.wait())}{_last_of(words)}")
        *lines, text = (text + came).split(b"\n")
        for line in lines:
            if not line:
                return
            yield line
            waits = patience(line)
        deadline = time.monotonic() + waits
    raise ChildEndedError(f"took longer than {waits:g} s")


def _how(code: int) -> str:
    if code >= 0:
        return f"ended its process (exit code {code})"
    try:
        return f"ended its process ({signal.Signals(-code).name})"
    except ValueError:
        return f"ended its process (signal {-code})"


def _last_of(words: IO[bytes]) -> str:
    """Return the last line that a child wrote, if any: a library that aborts says there why."""
    words.seek(max(0, words.seek(0, os.SEEK_END) - 4096))  # enough for a line
    lines = [line.strip() for line in words.read().decode(errors="replace").splitlines() if line.strip()]
    return f": {''.join(filter(str.isprintable, lines[-1]))[:WORDS]}" if lines else ""


def _try_all(pipe: int, given: str) -> None:
    told = read_json(given)
    sys.path[:] = told["path"]
    for number, (name, target, group) in enumerate(told["entries"]):
        os.write(pipe, b"%d\n" % number)
        try:
            EntryPoint(name, target, group).load()
        except BaseException:  # noqa: BLE001, S112 - where it is needed it raises again, and is told with its place
            continue
    os.write(pipe, b"\n")
    os._exit(0)  # what a plug-in left behind, as threads, may not let a process end


if __name__ == "__main__":
    _try_all(int(sys.argv[1]), sys.argv[2])
