"""Occupied space, as the page draws it: at most once a second, and nothing where a site measures none."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from pydantic import JsonValue

from tandem.skills.ports.occupancy import Occupancy

EVERY: Final = 1.0
"""Host seconds between two maps: each has up to 53 kB (``MOST_CELLS``), for each viewer."""
_DRAWN: Final = ("origin", "shape", "resolution", "cells")


class OccupiedSpace:
    """The cells of the planning scene. The keeper tells it each second, and at each change of anything in it.

    Args:
        monotonic: seconds of the host.
    """

    def __init__(self, monotonic: Callable[[], float]) -> None:
        self._monotonic = monotonic
        self._newest: dict[str, JsonValue] | None = None
        self._told: dict[str, JsonValue] | None = None
        self._told_at = float("-inf")

    def hear(self, occupied: Occupancy | None) -> None:
        """Take in the cells of a scene; None: none are measured."""
        self._newest = None if occupied is None else occupied.model_dump(mode="json", include=set(_DRAWN))

    def due(self) -> bool:
        """Say whether there are other cells than were told, and it is time to tell them."""
        return self._newest != self._told and self._monotonic() - self._told_at >= EVERY

    def take(self) -> dict[str, JsonValue] | None:
        """Return the newest cells; those that came in between are left out."""
        self._told, self._told_at = self._newest, self._monotonic()
        return self._told
