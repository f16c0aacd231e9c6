"""What commands print with ``--json``: one shape each, with times of day in ISO 8601.

``SHAPES`` has the model of each command; docs/json.md is generated from it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import typer

from tandem.executive.records.exporting import KeyCount
from tandem.executive.records.moments import Moment
from tandem.executive.records.recording import Facts
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.occupancy import MapEdited, Occupancy
from tandem.skills.ports.reflex import PipelineState, ReflexState
from tandem.skills.ports.tasks import TaskStatus, TreeSnapshot
from tandem.skills.ports.utc import ISO, UtcSeconds

if TYPE_CHECKING:
    from collections.abc import Mapping


class Tasks(Message):
    """Tasks, oldest first."""

    tasks: tuple[TaskStatus, ...]


class Requested(Message):
    """A request that was accepted."""

    task: str
    """Id of its task."""
    retry_of: str = ""
    """Id of the task that it repeats, if it repeats one."""
    robot: str | None = None
    """Name of the robot; null when none answers yet, and the task waits for one."""
    status: TaskStatus | None = None
    """The task at its end, with ``--wait``."""


class Ran(Message):
    """A request that was carried out."""

    status: TaskStatus
    """The task at its end."""
    picture: str = ""
    """File with the picture of the final scene, with ``--picture``."""


class Cancelled(Message):
    """Tasks that are being cancelled."""

    tasks: tuple[str, ...]
    refused: tuple[str, ...] = ()
    """Tasks that could not be cancelled, each with the reason."""


class Explained(Message):
    """Why a task failed."""

    status: TaskStatus | None
    """The task; null when none has failed and none is running."""
    words: str
    """The explanation for people."""
    picture: str = ""
    """File with the picture of the failure, with ``--picture``."""
    record: str = ""
    """File with the last minute before the failure, on the host of the recorder; empty if there is none."""


class Watched(Message):
    """What ``tandem watch`` shows: one document a line, at each change."""

    status: TaskStatus | None
    tree: TreeSnapshot | None
    gone: bool = False
    """Whether the executive has not been seen for a while."""
    reflexes: tuple[PipelineState, ...] = ()
    """The resources that a reflex has now, not with ``--once``."""


class TaskKind(Message):
    """A kind of task that is installed here."""

    name: str
    summary: str
    required: tuple[str, ...]
    """Fields that a request must have."""
    optional: tuple[str, ...]


class TaskKindList(Message):
    """The kinds of task that are installed here."""

    kinds: tuple[TaskKind, ...]


class Covered(Message):
    """Which statuses of which nodes an exploration has seen."""

    nodes: Count
    runs: Count
    ticks: Count
    missing: dict[str, tuple[str, ...]]
    """Statuses that were not seen, by node."""
    broken: tuple[str, ...]
    """Rules that were broken, and by which plan."""


class Searched(Message):
    """Runs with random faults."""

    runs: Count
    broken: Count
    """Runs that broke a rule."""
    words: tuple[str, ...]
    """What the command says of each of them without ``--json``."""


class ScenarioFacts(Message):
    """A scenario."""

    name: str
    site: str
    items: tuple[int | str, ...]
    """Items in it."""
    obstacles: Count
    faults: Count


class ScenarioList(Message):
    """The scenarios that come with Tandem."""

    scenarios: tuple[ScenarioFacts, ...]


class ScenarioChecked(Message):
    """A valid scenario, and the fault file that was checked with it."""

    scenario: ScenarioFacts
    faults: Count | None = None
    """Faults in the file of ``--faults``."""
    bus_faults: bool = False
    """Whether that file has faults of the bus."""


class Key(Message):
    """A key."""

    name: str
    role: str
    part: str | None
    expires_at: UtcSeconds
    revoked: bool
    valid: bool


class KeyList(Message):
    """Keys that the authority has made."""

    keys: tuple[Key, ...]


class Found(Message):
    """One thing that ``tandem doctor`` has looked at."""

    subject: str
    good: bool
    vital: bool
    """Whether something essential is missing if it is not good."""
    words: str


class Findings(Message):
    """What ``tandem doctor`` has found."""

    findings: tuple[Found, ...]
    missing: tuple[str, ...]
    """Essential things that are missing."""


class ClauseFound(Message):
    """A clause of the hardware contract, and how it ended."""

    name: str
    requires: str
    where: str
    """The page that says so."""
    moving: bool
    """Whether trying it moves something."""
    state: str
    """``ok``, ``failed`` or ``skipped``; empty with ``--list``."""
    expected: str = ""
    """If it failed."""
    found: str = ""
    why: str = ""
    """If it was skipped."""


class HardwareChecked(Message):
    """Clauses of the hardware contract, in the order in which they were tried."""

    clauses: tuple[ClauseFound, ...]


class Reflexes(Message):
    """A robot's reflexes, highest rank first, and what has its resources."""

    pipelines: tuple[PipelineState, ...]
    reflexes: tuple[ReflexState, ...]


class LogInfo(Message):
    """What is in a record of a robot."""

    facts: Facts
    begin: float
    """From when on it is whole, in robot seconds since its recorder began."""
    end: float
    size: Count
    """Bytes of the file."""
    keys: tuple[KeyCount, ...]
    pictures: Count
    attachments: tuple[str, ...]


class Replayed(Message):
    """A record, or a moment of it."""

    moments: tuple[Moment, ...] = ()
    """What happened in it, without ``--at`` and ``--task``."""
    at: float | None = None
    """The moment, in robot seconds since the recorder began."""
    status: TaskStatus | None = None
    """The task at work then, or the one asked for."""
    tree: TreeSnapshot | None = None
    words: str = ""
    """The explanation for people, as of ``tandem why``."""


def shapes() -> Mapping[str, type[Message]]:
    """Return the shape of each command that has ``--json``, by the command's words."""
    from tandem.executive.system.plugin_probe import Fared  # noqa: PLC0415
    from tandem.executive.telemetry.log_reading import LogLine  # noqa: PLC0415
    from tandem.skills.ports.hardware import StopState  # noqa: PLC0415

    return {
        "request KIND": Requested,
        "request json": Requested,
        "run KIND": Ran,
        "run json": Ran,
        "retry": Requested,
        "tasks": Tasks,
        "cancel": Cancelled,
        "stop": StopState,
        "release": StopState,
        "reflex list": Reflexes,
        "reflex on": ReflexState,
        "reflex off": ReflexState,
        "map show": Occupancy,
        "map save": MapEdited,
        "map clear": MapEdited,
        "watch": Watched,
        "logs": LogLine,
        "log info": LogInfo,
        "replay": Replayed,
        "why": Explained,
        "tree list": TaskKindList,
        "tree coverage": Covered,
        "tree properties": Searched,
        "scenario list": ScenarioList,
        "scenario check": ScenarioChecked,
        "keys list": KeyList,
        "plugins": Fared,
        "hardware check": HardwareChecked,
        "doctor": Findings,
    }


EACH: Final = frozenset({"plugins"})
"""Commands that print an array of their shape."""
LINES: Final = frozenset({"watch", "logs"})
"""Commands that print a document a line, again and again."""


def print_json(message: Message, *, line: bool = False) -> None:
    """Print a message as JSON; in one line, or indented for people."""
    typer.echo(message.model_dump_json(indent=None if line else 2, context=ISO))
