"""Remembers which plug-ins can be imported without harm: by the files that an import reads.

What was tried once costs later commands one small file to read, and a look at the plug-in's own files. The
memory is a cache, ``$XDG_CACHE_HOME/tandem/plugins.json`` or ~/.cache/tandem/plugins.json: without it, or
where it can't be written, plug-ins are tried again.
"""

from __future__ import annotations

import importlib.util
import json
import os
import sys
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Final

from tandem.skills.ports.plain_json import read_json

if TYPE_CHECKING:
    from tandem.skills.ports.plugins import Plugin

FILES: Final = 2000
"""Files of a package that are looked at, in 10 ms or less. A package with more is one that is installed, not
one that somebody edits: the folder that it was installed into tells of a change."""
INSTALLED: Final = frozenset({"site-packages", "dist-packages"})
"""Folders into which packages are installed: they change when any package comes, goes or is upgraded."""
SOURCES: Final = frozenset({".py", ".so", ".pyd"})
"""Kinds of file that an import reads."""


def path_of_memory(environment: Mapping[str, str]) -> Path:
    """Return the file of the memory."""
    told = environment.get("XDG_CACHE_HOME", "")
    home = Path(told) if told else Path(environment.get("HOME", "~")).expanduser() / ".cache"
    return home / "tandem" / "plugins.json"


def remembered(plugins: Iterable[Plugin]) -> dict[str, str]:
    """Return what is known of those plug-ins that were tried as they are now.

    Returns:
        By ``Plugin.key`` why the import ended its process or did not end; nothing for one that did no harm.
    """
    known = _read(path_of_memory(os.environ))
    found = {}
    for plugin in plugins:
        stamp, error = known.get(_name(plugin), ("", ""))
        if stamp and stamp == stamp_of(plugin):
            found[plugin.key] = error
    return found


def remember(tried: Mapping[Plugin, str]) -> None:
    """Keep what was found, with the stamps of the files. Does nothing where it can't be written.

    Args:
        tried: each plug-in with why its import ended its process or did not end; nothing for no harm.
    """
    path = path_of_memory(os.environ)
    new = {_name(plugin): (stamp_of(plugin), error) for plugin, error in tried.items()}
    with suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        written = path.with_suffix(f".{os.getpid()}")
        written.write_text(json.dumps({**_read(path), **new}), "utf-8")
        written.replace(path)  # at once: another command may read it meanwhile


def stamp_of(plugin: Plugin) -> str:
    """Return a text that is another one after a change of what the import of a plug-in reads.

    It tells of the version, of the package's own sources, wherever ``pip install -e`` found them, and of the
    folders of installed packages, because a package that the plug-in imports may have changed.
    """
    folders = [folder for folder in sys.path if Path(folder).name in INSTALLED]
    files = sorted(islice(_sources(plugin.target.partition(".")[0].partition(":")[0]), FILES))
    changed = _number_of((*(_changed(folder) for folder in folders), *(_changed(file) for file in files)))
    return f"{plugin.version} {plugin.target} {sys.hexversion:x} {len(files)} {changed:x}"


def _number_of(parts: Iterable[str]) -> int:
    """Return a number of 32 bits that stands for texts: a change is noticed, and nothing is kept secret."""
    import zlib  # noqa: PLC0415 - only where there are plug-ins

    return zlib.crc32("\n".join(parts).encode())


def _changed(file: str) -> str:
    try:
        stat = Path(file).stat()
    except OSError:
        return file
    return f"{file} {stat.st_mtime_ns} {stat.st_size if Path(file).suffix else 0}"


def _sources(module: str) -> Iterator[str]:
    """Give the files of a module outside all packages, or of a package. Imports nothing."""
    try:
        spec = importlib.util.find_spec(module)
    except (ImportError, ValueError):
        return
    if spec is None:
        return
    if spec.origin is not None:
        yield spec.origin
    for root in spec.submodule_search_locations or ():
        for folder, _, names in os.walk(root):
            yield from (f"{folder}/{name}" for name in names if Path(name).suffix in SOURCES)


def _name(plugin: Plugin) -> str:
    """Return what a plug-in is called in the memory, which all environments of a user share."""
    return f"{sys.prefix} {plugin.key}"


def _read(path: Path) -> dict[str, tuple[str, str]]:
    """Return what a memory holds, by the plug-ins' names in it; nothing where it can't be read."""
    try:
        held = read_json(path.read_bytes())
    except (OSError, ValueError):
        return {}
    return {
        str(name): (each[0], each[1])
        for name, each in (held.items() if isinstance(held, dict) else ())
        if isinstance(each, list) and len(each) == 2 and all(isinstance(part, str) for part in each)  # noqa: PLR2004
    }
