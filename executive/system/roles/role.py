"""What a role's file declares: its name, when it is needed, how it is played, what it may do on the bus.

A role's own libraries are imported when it is played, inside its functions: the executive's process loads no
numpy, the base's no camera library.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Final, Literal

from tandem.executive.config.extras import Extra
from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.security.rights import Rights
from tandem.skills.ports.bus import Bus, Commons
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site

if TYPE_CHECKING:
    from tandem.skills.wire.forked_worker import ForkedWorker
    from tandem.skills.wire.presence import Presence
    from tandem.skills.wire.zenoh_bus import ZenohBus

Kind = Literal["router", "hardware", "skills", "executive", "observer", "recorder"]
"""Whose certificate a role shows, where keys are used: an observer that of the skills, a recorder that of the
supervisor, which hears everything too."""

Calm = Literal["never", "between goals", "always"]
Worker = Literal["spawned", "forked", "once"]
"""A worker process beside a process of skills. ``spawned``: with the first work, which hardly ever comes.
``forked``: there from the start, for work that comes again and again. ``once``: forked, too, and ended when
it has done what the start asks of it."""


@dataclass(frozen=True)
class Surroundings:
    """What the nodes of a skills role are made with."""

    bus: Bus
    clocks: Clocks
    description: RobotDescription
    site: Site
    compute: Compute
    seed: int
    charge: bool = False
    """Whether computations cost their declared robot time (lockstep)."""
    journal: Path | None = None
    left_out: Mapping[str, str] | None = None
    """Plug-ins that are known not to load; None: all plug-ins are left out."""
    commons: Commons | None = None
    """What all robots of the site share (``tandem.skills.ports.whereabouts``)."""
    robot: str = ""
    """The robot's name among them."""
    map_file: Path | None = None
    """Where the map of occupied space is saved, and read from at the start; None: nowhere."""


@dataclass(frozen=True)
class Stage:
    """What a role that plays itself is given.

    Args:
        settings: of the process.
        bus: its end of the bus; a router has none.
        presence: its claim, which is settled.
        stopped: says when to end.
        worker: see ``Role.worker``.
    """

    settings: WorkerSettings
    bus: ZenohBus
    presence: Presence
    stopped: Callable[[], bool]
    worker: ForkedWorker | None = None


def always(description: RobotDescription) -> bool:  # noqa: ARG001 - as the others are called
    """Say that every robot needs it."""
    return True


@dataclass(frozen=True)
class Role:
    """A role. Exactly one of ``nodes``, ``play`` and ``route`` says how it is played."""

    name: str
    starts: int = 70
    """Roles are started, and stepped in lockstep, in the order of these numbers; the executive's is 80."""
    kind: Kind = "skills"
    rights: Rights = field(default_factory=Rights)
    """What it may do on the bus; roles of one kind share a certificate, which allows what any of them may."""
    extra: Extra | None = None
    """What has to be installed where it is played, besides the bare package."""
    needed: Callable[[RobotDescription], bool] = always
    """Whether a robot of this description has use for it."""
    nodes: Callable[[Surroundings], Sequence[Node]] | None = None
    """Skills: makes the nodes of one boot, in the order in which they are stepped."""
    play: Callable[[Stage], None] | None = None
    """Plays the role until it is told to end."""
    route: Callable[[WorkerSettings, Callable[[], bool]], None] | None = None
    """The router's: it plays before there is a bus."""
    pictures: bool = False
    """Whether it tells or hears camera pictures: on one host they go through shared memory."""
    calm: Calm = "never"
    """Skills: when they move nothing themselves, so that not each tick of the clock need wake them."""
    on_request: bool = False
    """Whether it is started only when somebody asks for it."""
    ahead: Callable[[], None] | None = None
    """Loads what playing the role will need: in a process that waits to take the place of a dead one, and
    before a worker is forked."""
    worker: Worker = "spawned"
    """Skills: where work is done that can't be sliced."""


@dataclass(frozen=True)
class Family:
    """Roles of which a robot has one for each part of a kind. A file declares one as ``FAMILY``."""

    prefix: str
    """What their names begin with, such as ``arm_``; the part's name follows."""
    parts: Callable[[RobotDescription], Sequence[str]]
    """The names of a robot's parts."""
    role: Callable[[str], Role]
    """Makes the role of a part."""

    def named(self, name: str) -> Role | None:
        """Return the role of that name, or None if it is none of these."""
        part = name.removeprefix(self.prefix)
        return self.role(part) if part not in {"", name} else None


_EVERY_PROCESS: Final = Rights(announces=("alive/**", "claim/**"), sees=("alive/**", "claim/**"))
_EVERY_SKILL: Final = Rights(
    tells=("skill/**", "sim/follow", "beat/**", "refused"),
    hears=("hw/**", "world/**", "skill/**", "beat/**", "refused"),
    asks=("hw/description", "hw/lease", "hw/stop"),  # no skill calls another
    serves=("skill/**",),
    hears_site=("world/robots/*",),
).also(_EVERY_PROCESS)


def process_rights(rights: Rights) -> Rights:
    """Return what a process may do besides announcing itself."""
    return rights.also(_EVERY_PROCESS)


def skill_rights(*, tells: tuple[str, ...] = (), asks: tuple[str, ...] = ()) -> Rights:
    """Return what a process of skills may do besides what all of them may."""
    believes = tuple(key for key in tells if key.startswith("world/"))
    return _EVERY_SKILL.also(Rights(tells=tells, asks=asks, serves=believes))
