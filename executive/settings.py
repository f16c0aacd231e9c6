"""What the processes of a system are, what each needs to know, and how one refuses to start."""

from __future__ import annotations

from typing import Final, Literal

from skills.ports.message import Message

Role = Literal[
    "router", "hardware", "keeper", "perception", "base", "arm_left", "arm_right", "bimanual", "executive"
]
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


class WorkerSettings(Message):
    """What one process needs to know."""

    role: Role
    endpoint: str
    prefix: str
    site: str
    """Name or path of the site file."""
    scenario: str = "Demo"
    faults: str | None = None
    """Path of a file of faults on purpose, besides the scenario's own."""
    seed: int = 1
    speed: float | None = 1.0
    """Simulated seconds in a second; None: as fast as all followers go."""
    gui: bool = False
    journal: str | None = None
    """File in which the keeper keeps what no sensor can restore."""
    verbose: bool = False


class RefusalError(RuntimeError):
    """A process that must not start here; the message says why. Exit code 4."""
