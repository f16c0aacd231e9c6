"""How a demo or a whole system is to be run: typed, frozen, read in one place (``executive/cli``)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final, Literal

from tandem.executive.config.log_format import LogFormat
from tandem.executive.config.on_restart import OnRestart
from tandem.skills.ports.plugins import Broken
from tandem.skills.wire.pulse import SILENT_AFTER

Processes = Literal["few", "many"]
FILMS: Final = (".webp", ".gif", ".png")
"""Endings of moving pictures; .png is an animated one."""
DEFAULT_ENDPOINT: Final = "tcp/127.0.0.1:7447"
DEFAULT_SITE: Final = "lab"
DEFAULT_ROBOT: Final = "tiago"


@dataclass(frozen=True)
class BusOptions:
    """Where the bus is, and whose keys are meant."""

    endpoint: str = DEFAULT_ENDPOINT
    site: str = DEFAULT_SITE
    """First part of every key."""
    robot: str = DEFAULT_ROBOT
    """Second part of every key."""
    keys: Path | None = None
    """Folder of keys for mutual TLS; None: without."""
    holder: str = ""
    """Whose keys of that folder are shown."""

    @property
    def prefix(self) -> str:
        """What stands before every key: ``<site>/<robot>``."""
        return f"{self.site}/{self.robot}"


def default_data(bus: BusOptions, environment: Mapping[str, str]) -> Path:
    """Return the folder of a robot's data: in ``$XDG_STATE_HOME/tandem``, or in ~/.local/state/tandem."""
    state = environment.get("XDG_STATE_HOME", "")
    home = Path(state) if state else Path(environment.get("HOME", "~")).expanduser() / ".local" / "state"
    return home / "tandem" / f"{bus.site}-{bus.robot}"


@dataclass(frozen=True)
class RunOptions:
    """What ``tandem demo`` and ``tandem up`` were asked for.

    ``executive.cli.running_system`` does the work.
    """

    bus: BusOptions = BusOptions()
    scenario: str = "Demo"
    """Name of a scenario that comes with the sim, or the path of a YAML file."""
    site: str = ""
    """Name of a site, or path of a site file, instead of the scenario's own."""
    faults: Path | None = None
    """File of faults on purpose, besides the scenario's own."""
    seed: int = 1
    speed: float | None = 1.0
    """Simulated seconds in a second; None: as fast as it goes."""
    gui: bool = False
    """Show pybullet's window."""
    lockstep: bool = False
    """All in one thread over the bus in memory, instead of processes over zenoh."""
    report: Path | None = None
    """Where the run's report goes (JSON)."""
    picture: Path | None = None
    """Where the demo's picture of the last scene goes; None: a file of the demo's choice."""
    film: Path | None = None
    """Where a moving picture of room and tree goes; None: none is taken."""
    log: Path | None = None
    """Where logs of all processes go; None: standard error when ``verbose``."""
    verbose: bool = False
    log_format: LogFormat = "text"
    metrics: str = ""
    """Host and port where metrics are served for Prometheus; empty: nowhere."""
    traces: str = ""
    """Address of a collector of OpenTelemetry traces; empty: none."""
    web: str = ""
    """Host and port where the page is served; empty: nowhere."""
    black_box: bool = False
    """Keep the last minute of each robot, and write it down when something goes wrong."""
    record: Path | None = None
    """Folder of MCAP recordings; None: nothing is recorded but the last minute."""
    record_pictures: bool = True
    """Whether camera pictures are recorded."""
    again: Path | None = None
    """Record of a run in lockstep that this one is held to, message by message."""
    again_until: float = math.inf
    """Robot seconds at which that is enough."""
    commit: str = ""
    """Of the checkout that the program runs from; empty: not known."""
    person: str = ""
    """Who started it, in whose name the page asks."""
    silent_after: float = SILENT_AFTER
    """Host seconds without a beat after which a process is said not to go on."""
    listen: tuple[str, ...] = ()
    """Endpoints at which the router listens besides that of ``bus``."""
    processes: Processes = "many"
    """Whether the skills that ship have a process each, or share one."""
    only: tuple[str, ...] = ()
    """Roles that are started here; empty: all."""
    data: Path | None = None
    """Folder of the ledger and of what skills keep; None: one that ends with the run."""
    on_restart: OnRestart = "resume"
    """What becomes of a task that was under way when the executive ended, unless its request says so."""
    broken: tuple[Broken, ...] = ()
    """Plug-ins that can't be loaded, and are left out."""
    request: str = ""
    """What ``tandem run`` asks for, as a JSON document."""
    as_json: bool = False
    """Whether the end of the request is printed as JSON, and what is said meanwhile to standard error."""
    within: float = 900.0
    """Robot seconds that its task may take."""

    @property
    def left_out(self) -> Mapping[str, str]:
        """Errors of plug-ins that are left out, as settings of processes name them."""
        return {each.plugin.key: each.error for each in self.broken}
