"""The parts that a process of the system can play. Imports nothing, so that `tandem --help` is quick."""

from __future__ import annotations

from typing import Final, Literal

LogFormat = Literal["text", "json"]
"""Logs for people, or as lines of JSON."""
Role = Literal[
    "router",
    "hardware",
    "keeper",
    "perception",
    "base",
    "arm_left",
    "arm_right",
    "bimanual",
    "executive",
    "observer",
    "mock",
]
"""``mock`` stands in for hardware and skills in the campaign of crashes; no other system has it."""
ROLES: Final[tuple[Role, ...]] = (
    "router",
    "hardware",
    "keeper",
    "perception",
    "base",
    "arm_left",
    "arm_right",
    "bimanual",
    "executive",
)
"""In the order in which they are started."""
OBSERVER: Final[Role] = "observer"
"""Keeps records for who asks for them; nothing needs it, and it is not started unless asked for."""
