"""Files that are named after the UTC at which they were begun, and which of them are the oldest.

A host's clock may have been wrong when a file was begun, or be wrong now: it starts at some date of the past
without a battery, and is set by NTP later. So what the names say is not taken for more than it is: files that
seem to be of the future come first, as they were begun before now in any case, and a gap that is too long to
be believed makes nothing older.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

STAMP: Final = r"(\d{8}T\d{6}Z)"
"""What such a name begins with, as a regular expression."""
_FORM: Final = "%Y%m%dT%H%M%SZ"
_STAMP: Final = re.compile(STAMP)
GAP: Final = 30 * 86_400.0
"""Seconds between two files, or the last one and now, that are believed: a robot may rest for a holiday. Of a
longer one the clock is as likely the cause."""


def stamp_of(utc: float) -> str:
    """Return the words for a moment (UTC seconds)."""
    return f"{datetime.fromtimestamp(utc, UTC):{_FORM}}"


def began_of(path: Path) -> float | None:
    """Return the UTC seconds that a file is named after, to a second; None: after none."""
    found = _STAMP.match(path.name)
    if found is None:
        return None
    try:
        return datetime.strptime(found[1], _FORM).replace(tzinfo=UTC).timestamp()
    except ValueError:
        return None  # of month 13, say


def oldest_first(paths: Iterable[Path], now: float) -> dict[Path, float]:
    """Return how old files are at least (s), the oldest first; without those that are named after no moment.

    Args:
        paths: of the files.
        now: UTC seconds by a clock that may be wrong.
    """
    dated = [(began, path) for path in paths if (began := began_of(path)) is not None]
    dated.sort(key=lambda each: (each[0] <= now, each[0], len(each[1].name), each[1].name))
    ages: dict[Path, float] = {}
    age, later = 0.0, now
    for began, path in reversed(dated):
        if 0.0 <= later - began <= GAP:
            age += later - began
        ages[path], later = age, began
    return dict(reversed(ages.items()))
