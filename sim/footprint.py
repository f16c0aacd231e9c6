"""The room that the simulated robot takes: a disc on the floor, and its height."""

from __future__ import annotations

from typing import Final

FOOTPRINT_RADIUS: Final = 0.37
"""Metres. The arms at home reach 0.364 m from the base's axis; the base itself 0.30 m."""
HEIGHT: Final = 1.6
"""Metres, with the torso up."""
