"""The files that a robot's URDF names, and no others."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

from tandem.skills.ports.packages import PREFIX, resolve

MEDIA: Final = {
    ".dae": "model/vnd.collada+xml",
    ".stl": "model/stl",
    ".obj": "text/plain",
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".jpeg": "image/jpeg",
    ".tif": "image/tiff",
}
_NAMED: Final = re.compile(r'filename="([^"]+)"')


def named_in(urdf: str) -> frozenset[str]:
    """Return the ``package://`` addresses of a URDF, without that prefix."""
    found = (each.removeprefix(PREFIX) for each in _NAMED.findall(urdf) if each.startswith(PREFIX))
    return frozenset(found)


def mesh(path: str, named: frozenset[str]) -> Path | None:
    """Return the file of an address that the URDF names, or a picture beside one; None for any other.

    Args:
        path: behind ``package://``.
        named: the addresses of the URDF.
    """
    folder = path.rpartition("/")[0]
    texture = Path(path).suffix.lower() in {".png", ".jpg", ".jpeg", ".tif"}
    beside = texture and any(each.rpartition("/")[0] == folder for each in named)
    if ".." in path.split("/") or Path(path).suffix.lower() not in MEDIA or not (path in named or beside):
        return None
    try:
        return resolve(PREFIX + path)
    except FileNotFoundError:
        return None
