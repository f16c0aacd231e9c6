"""Arms, grippers and base are resources: whoever moves one holds it, and two leaves never both have it."""

from __future__ import annotations

from collections.abc import Iterable


class Resources:
    """Who holds what. Released by a skill's terminal status, never by the leaf's end alone."""

    def __init__(self) -> None:
        """Start with all free."""
        self._holders: dict[str, str] = {}

    def claim(self, names: Iterable[str], holder: str) -> bool:
        """Take all of them, or none; return whether they are the holder's now."""
        wanted = tuple(names)
        if any(self._holders.get(name, holder) != holder for name in wanted):
            return False
        self._holders.update(dict.fromkeys(wanted, holder))
        return True

    def release(self, holder: str) -> None:
        """Give back all that the holder has."""
        self._holders = {name: each for name, each in self._holders.items() if each != holder}

    def holder(self, name: str) -> str | None:
        """Return who holds it, or None."""
        return self._holders.get(name)
