"""What the processes of a system are, what each needs to know, and how one refuses to start."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Final

from pydantic import Field

from tandem.executive.config.log_format import LogFormat
from tandem.executive.config.on_restart import OnRestart
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.message import Message
from tandem.skills.wire.pulse import SILENT_AFTER


class WorkerSettings(Message):
    """What one process needs to know."""

    role: Annotated[str, Field(pattern="^[a-z][a-z0-9_]{0,63}$")]
    unit: Annotated[str, Field(pattern="^([a-z][a-z0-9_]{0,63}/[a-z][a-z0-9_]{0,63})?$")] = ""
    """What it is called among the processes of several robots, such as ``r2/base``; empty: as its role."""
    played_by: Annotated[str, Field(pattern=r"^([a-z0-9_.]+:[A-Za-z0-9_]+)?$", max_length=200)] = ""
    """``module:attribute`` of the ``Role`` that plays it; empty: the one that ships or is plugged in."""
    left_out: Mapping[str, str] = {}
    """Errors of plug-ins that are known not to load (``tandem.skills.ports.plugins``)."""
    arguments: Mapping[str, str] = {}
    """What only the role's own code reads."""
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
    data: str | None = None
    """Folder of the executive's ledger and of the skills' goal journals; None: nothing is kept."""
    on_restart: OnRestart = "resume"
    """What becomes of a task that was under way when the executive ended, unless its request says so."""
    died: str = ""
    """How the process whose place it takes ended, with its last words; empty: nobody knows, or it did not."""
    lineage: Annotated[str, Field(pattern="^[0-9a-z]{0,32}$")] = ""
    """Random name of who starts the role's processes one after the other; empty: one of its own."""
    generation: Annotated[int, Field(ge=0, le=999_999_999)] = 0
    """Counts them: each takes the place of the one before, which is known to be dead."""
    stop: StopState | None = None
    """The hardware's: the stop that was set when the one before it died; it begins with it."""
    stops: Mapping[str, StopState] = {}
    """Likewise of the other robots of its world, by name."""
    verbose: bool = False
    log_format: LogFormat = "text"
    metrics: str = ""
    """The observer's: host and port where it serves metrics for Prometheus; empty: nowhere."""
    traces: str = ""
    """The observer's: address of a collector of OpenTelemetry traces; empty: none."""
    web: str = ""
    """The page's: host and port where it is served."""
    web_of: tuple[str, ...] = ()
    """The page's: robots of the site that have one, each at the port after the one before; empty: its own."""
    person: str = ""
    """The page's: in whose name it asks."""
    record: str = ""
    """The recorder's: folder of MCAP recordings; empty: nothing is recorded but the last minute."""
    record_pictures: bool = True
    """Whether camera pictures are recorded."""
    commit: Annotated[str, Field(pattern="^[0-9a-f]{0,64}$")] = ""
    """Of the checkout that the program runs from; empty: not known."""
    silent_after: float = SILENT_AFTER
    """Host seconds without a beat after which another process is said not to go on."""
    listen: tuple[str, ...] = ()
    """Endpoints at which the router listens besides its own."""
    prefixes: tuple[str, ...] = ()
    """The router's: ``<site>/<robot>`` of each of several robots behind it; empty: ``prefix`` alone."""
    keys: str | None = None
    """Folder of keys, with which every process shows who it is; None: nobody asks."""
    holder: str = ""
    """The robot's name in that folder."""

    @property
    def called(self) -> str:
        """What people and the supervisor call the process."""
        return self.unit or self.role

    parent: int | None = None
    """Process id of the process that starts it and without which it ends; None: its parent when it begins."""


WAIT: Final = "--wait"
"""Instead of settings: load what a role needs, and read the settings from standard input."""
REFUSED: Final = 4
"""Exit code of a process that must not start here."""
UNKEPT: Final = 5
"""Exit code of an executive whose ledger can't be opened or written."""


class RefusalError(RuntimeError):
    """A process that must not start here; the message says why. Exit code 4."""
