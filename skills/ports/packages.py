"""Where the files of a robot description are: ``package://`` addresses as paths of this installation."""

from __future__ import annotations

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

    Raises:
        FileNotFoundError: naming the address and the folders that were searched.
    """
    if not uri.startswith(PREFIX):
        return Path(uri)
    for folder in share_directories():
        path = folder / uri.removeprefix(PREFIX)
        if path.exists():
            return path
    searched = ", ".join(str(folder) for folder in share_directories())
    raise FileNotFoundError(f"{uri}: not found in {searched}; is example-robot-data installed?")
