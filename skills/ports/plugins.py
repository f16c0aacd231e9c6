"""What other packages add: the one loader of entry points, and what becomes of a plug-in that is broken.

A package declares a plug-in in its ``pyproject.toml`` under ``[project.entry-points."tandem.tasks"]`` and the
like. A plug-in that raises, hangs at import, ends its process, is of the wrong kind or claims a taken name is
left out and named with its error; the others are loaded. See docs/plugins.md.
"""

from __future__ import annotations

import logging
import re
import signal
import sys
import threading
import traceback
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from importlib.metadata import EntryPoint, EntryPoints, entry_points
from pathlib import Path
from types import FrameType, MappingProxyType
from typing import Final, Generic, Never, TypeVar

Value = TypeVar("Value")
Found_co = TypeVar("Found_co", covariant=True)

LOADS_WITHIN: Final = 10.0
"""Seconds that the import of one plug-in may take. The heaviest libraries in use (torch) take about 4 on a
slow computer; a plug-in should import such a library where it uses it."""
NAME: Final = re.compile(r"[a-z][a-z0-9_]{0,63}")
"""A plug-in's name: it becomes a word of commands, of keys on the bus and of file names."""
UNTRIED: Final[Mapping[str, str]] = MappingProxyType({})
"""Nobody has tried the plug-ins before: ``load`` does it, each new one in a process of its own first."""
OURS: Final = "tandem-executive"
"""The package whose entry points are Tandem's own."""
_LOG = logging.getLogger(__name__)


class Group(StrEnum):
    """What there may be plug-ins of; the entry points stand under ``tandem.<group>``."""

    TASKS = "tasks"
    ROLES = "roles"
    SKILLS = "skills"
    ROBOTS = "robots"
    SITES = "sites"
    NODES = "nodes"
    DETECTORS = "detectors"
    REFLEXES = "reflexes"

    @property
    def entry_points(self) -> str:
        """Return the name of the group in a ``pyproject.toml``."""
        return f"tandem.{self.value}"


@dataclass(frozen=True, order=True)
class Plugin:
    """An entry point that a package declares."""

    group: Group
    name: str
    package: str
    version: str
    target: str
    """The object that it names: ``module:attribute``."""

    @property
    def key(self) -> str:
        """Return what names it in settings: ``group/name@package``."""
        return f"{self.group.value}/{self.name}@{self.package}"

    def __str__(self) -> str:
        """Return it in words: ``tasks/count (my-app 0.1.0)``."""
        return f"{self.group.value}/{self.name} ({self.package} {self.version})"

    def load(self) -> object:
        """Import it and return its object; whatever the plug-in raises comes through."""
        loaded: object = EntryPoint(self.name, self.target, self.group.entry_points).load()
        return loaded


@dataclass(frozen=True)
class Broken:
    """A plug-in that was left out, and why, in one line."""

    plugin: Plugin
    error: str

    def __str__(self) -> str:
        """Return both."""
        return f"plug-in {self.plugin} is left out: {self.error}"


@dataclass(frozen=True)
class Loaded(Generic[Found_co]):
    """The plug-ins of a group: by name those that work, and those that don't."""

    found: Mapping[str, Found_co]
    broken: tuple[Broken, ...]
    origins: Mapping[str, Plugin]
    """Where those that work come from, by name."""


def installed(group: Group) -> tuple[Plugin, ...]:
    """Return what packages declare in a group, in the order of names. Imports nothing of theirs."""
    found = []
    folders = tuple((folder, _changed(folder)) for folder in sys.path)
    for entry in _declared(group, folders):
        package = "unknown" if entry.dist is None else entry.dist.name
        version = "" if entry.dist is None else entry.dist.version
        found.append(Plugin(group, entry.name, package, version, entry.value))
    return tuple(sorted(found))


def _changed(folder: str) -> int:
    """Return when a package was last added to a folder or taken from it (ns); 0 where there is none."""
    try:
        return Path(folder).stat().st_mtime_ns
    except OSError:
        return 0


@lru_cache(maxsize=16)  # twice as many as there are groups
def _declared(group: Group, folders: tuple[tuple[str, int], ...]) -> EntryPoints:  # noqa: ARG001 - for the cache
    """Return what all packages declare in a group, read anew when a package comes or goes.

    Each look reads files of every package, and a command looks for each group and each name that it resolves.
    """
    return entry_points(group=group.entry_points)


def load(
    group: Group,
    checked: Callable[[str, object], Value],
    *,
    taken: Collection[str] = (),
    left_out: Mapping[str, str] = UNTRIED,
    within: float = LOADS_WITHIN,
) -> Loaded[Value]:
    """Load the plug-ins of a group. Never raises for what a plug-in does.

    Args:
        group: which.
        checked: takes the name and the object of an entry point, and returns the object when it is of the
            right kind; ``TypeError`` says what was expected. It calls nothing of the plug-in's.
        taken: names that the group has without plug-ins.
        left_out: errors by ``Plugin.key`` of those that are known not to load; they are not tried again, and
            neither are the others. UNTRIED: those that are new are tried in a process of their own
            (``plugin_trials``), and what is broken is logged as a warning.
        within: seconds for the import of one. In this process only the main thread can keep it.
    """
    found: dict[str, Value] = {}
    broken, origins = list[Broken](), dict[str, Plugin]()
    known = _harm_of(group, within) if left_out is UNTRIED else left_out
    for plugin in installed(group):
        error = known.get(plugin.key) or _misnamed(plugin, taken, origins)
        if not error:
            try:
                with _time_limit(within):
                    value = plugin.load()
            except KeyboardInterrupt:
                raise
            except BaseException as raised:  # noqa: BLE001 - it may raise SystemExit and worse
                error = in_words(raised)
            else:
                error = _refused(plugin, value, checked, found)
        if error:
            broken.append(Broken(plugin, error))
        else:
            origins[plugin.name] = plugin
    for each in broken if left_out is UNTRIED else ():
        _LOG.warning("%s", each)
    return Loaded(MappingProxyType(found), tuple(broken), MappingProxyType(origins))


def _harm_of(group: Group, within: float) -> Mapping[str, str]:
    """Return why plug-ins of a group must not be imported in this process, by key; try those that are new."""
    others = [plugin for plugin in installed(group) if plugin.package != OURS]
    if not others:
        return UNTRIED
    from tandem.skills.ports.plugin_memory import remembered  # noqa: PLC0415 - only where there are plug-ins

    known = remembered(others)
    if new := [plugin for plugin in others if plugin.key not in known]:
        from tandem.skills.ports.plugin_trials import try_out  # noqa: PLC0415 - costs 10 ms

        known |= try_out(new, within)
    return {
        plugin.key: f"{why}; mend {plugin.package} or uninstall it, and try it with `tandem plugins`"
        for plugin in others
        if (why := known[plugin.key])
    }


def _misnamed(plugin: Plugin, taken: Collection[str], origins: Mapping[str, Plugin]) -> str:
    """Return what is wrong with a plug-in's name; nothing when nothing is."""
    if NAME.fullmatch(plugin.name) is None:
        return "expected a name of small letters, digits and _, that begins with a letter"
    if plugin.name in taken:
        return f"the name {plugin.name!r} is taken: Tandem's own; choose another one"
    if plugin.name in origins:
        other = origins[plugin.name]
        return (
            f"the name {plugin.name!r} is taken: by {other.package} {other.version}; give one of the two "
            "another name in its pyproject.toml and install it again, or uninstall one"
        )
    return ""


def _refused(
    plugin: Plugin, value: object, checked: Callable[[str, object], Value], found: dict[str, Value]
) -> str:
    """Return why a plug-in's object is not of the right kind; nothing when it is, and is added."""
    try:
        found[plugin.name] = checked(plugin.name, value)
    except TypeError as wrong:
        return str(wrong)
    return ""


class _TooLongError(BaseException):
    """The import takes too long. No ``Exception``: a plug-in that catches these goes on hanging."""


def in_words(raised: BaseException) -> str:
    """Return an error of a plug-in in one line, with the place in its code."""
    if isinstance(raised, _TooLongError):
        return str(raised)
    words = " ".join(str(raised).split())
    said = f"{type(raised).__name__}: {words}" if words else type(raised).__name__
    frames = traceback.extract_tb(raised.__traceback__)
    last = frames[-1] if frames else None
    ours = last is None or last.filename == __file__ or last.filename.startswith("<frozen")
    place = "" if ours or last is None else f" ({last.filename}:{last.lineno})"
    return f"{said}{place}"


@contextmanager
def _time_limit(seconds: float) -> Iterator[None]:
    """Raise in the code within when it takes longer. Loops in C don't hear it."""
    if threading.current_thread() is not threading.main_thread() or signal.getitimer(signal.ITIMER_REAL)[0]:
        yield
        return

    def end(_number: int, _frame: FrameType | None) -> Never:
        raise _TooLongError(f"its import took longer than {seconds:g} s")

    before = signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
