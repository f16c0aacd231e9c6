"""What the processes of a system are, what each needs to know, and how one refuses to start."""

from __future__ import annotations

from typing import Final, Literal

from skills.ports.message import Message
from skills.wire.pulse import SILENT_AFTER

LogFormat = Literal["text", "json"]
"""Logs for people, or as lines of JSON."""
Role = Literal[
    "router", "hardware", "keeper", "perception", "base", "arm_left", "arm_right", "executive", "observer"
]
ROLES: Final[tuple[Role, ...]] = (
    "router",
    "hardware",
    "keeper",
    "perception",
    "base",
    "arm_left",
    "arm_right",
    "executive",
)
"""In the order in which they are started."""
OBSERVER: Final[Role] = "observer"
"""Keeps records for who asks for them; nothing needs it, and it is not started unless asked for."""


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
    log_format: LogFormat = "text"
    metrics: str = ""
    """The observer's: host and port where it serves metrics for Prometheus; empty: nowhere."""
    traces: str = ""
    """The observer's: address of a collector of OpenTelemetry traces; empty: none."""
    silent_after: float = SILENT_AFTER
    """Host seconds without a beat after which another process is said not to go on."""
    listen: tuple[str, ...] = ()
    """Endpoints at which the router listens besides its own."""
    keys: str | None = None
    """Folder of keys, with which every process shows who it is; None: nobody asks."""
    holder: str = ""
    """The robot's name in that folder."""


class RefusalError(RuntimeError):
    """A process that must not start here; the message says why. Exit code 4."""
