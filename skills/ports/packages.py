"""Where the files of a robot description are: ``package://`` addresses as paths of this installation."""

from __future__ import annotations

import importlib.util
import sysconfig
from pathlib import Path
from typing import Final

PREFIX: Final = "package://"


def share_directories() -> tuple[Path, ...]:
    """Return the folders in which packages of robot descriptions are looked for."""
    site = Path(sysconfig.get_paths()["purelib"])
    return (site / "cmeel.prefix" / "share",)


def resolve(uri: str) -> Path:
    """Return the file behind ``package://<package>/<path>``; a plain path is returned as it is.

    The package is one of robot descriptions, or else a Python package that is installed.

    Raises:
        FileNotFoundError: naming the address and the folders that were searched.
    """
    if not uri.startswith(PREFIX):
        return Path(uri)
    name, _, inside = uri.removeprefix(PREFIX).partition("/")
    folders = [*(folder / name for folder in share_directories()), *_of_python(name)]
    for folder in folders:
        path = folder / inside
        if path.exists():
            return path
    searched = ", ".join(str(folder) for folder in folders)
    raise FileNotFoundError(
        f"{uri}: not found in {searched}; is example-robot-data, or the package {name!r}, installed?"
    )


def _of_python(name: str) -> tuple[Path, ...]:
    """Return the folders of a top-level Python package, without importing it."""
    if not name.isidentifier():
        return ()
    found = importlib.util.find_spec(name)
    return tuple(map(Path, found.submodule_search_locations or ())) if found else ()
