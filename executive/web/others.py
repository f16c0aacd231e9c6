"""The other robots of the site, as each tells where it is and what it does."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from pydantic import JsonValue

from tandem.skills.ports.bus import Commons
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.whereabouts import RobotWhereabouts, whereabouts

SILENT_AFTER: Final = 3.0
"""Seconds without a word after which a robot may be elsewhere; it tells ten times a second."""


class Others:
    """What each robot told last.

    Args:
        commons: where they tell; None: there are no others.
        age: seconds by which what they told grows old: of the host, or of a record.
        own: the robot's own name, which is left out.
    """

    def __init__(self, commons: Commons | None, age: Callable[[], float], own: str) -> None:
        self._age, self._own = age, own
        every = whereabouts("*")
        self._heard = None if commons is None else Heard(commons, every.key, every.decode, depth=8)
        self._last: dict[str, tuple[RobotWhereabouts, float]] = {}

    def take(self) -> dict[str, JsonValue]:
        """Return how each stands, by its name."""
        now = self._age()
        for key, told, _ in () if self._heard is None else self._heard.take():
            if key == whereabouts(told.name).key and told.name != self._own:
                self._last[told.name] = (told, now)
        return {name: _plain(told, now - came) for name, (told, came) in self._last.items()}

    def close(self) -> None:
        """Hear no more."""
        if self._heard is not None:
            self._heard.close()


def _plain(told: RobotWhereabouts, age: float) -> JsonValue:
    at = told.base_in_map
    return {
        "at": None if at is None else [round(at.x, 2), round(at.y, 2), round(at.yaw, 2)],
        "task": told.task,
        "kind": told.kind,
        "phase": told.phase,
        "size": [told.radius, told.height],
        "silent": age > SILENT_AFTER,
    }
