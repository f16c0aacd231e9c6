"""How a process plays its role: it settles that it is the only one, then does what the role's file says."""

from __future__ import annotations

import logging
import os
import re
import socket
import time
import uuid
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Final

from tandem.executive.config.extras import words_on
from tandem.executive.config.process_settings import RefusalError, WorkerSettings
from tandem.executive.system.command_line import show
from tandem.executive.system.roles.registry import part_of, role_named, role_of
from tandem.executive.system.roles.role import Role, Stage
from tandem.skills.ports.isolation import python
from tandem.skills.ports.lease import Claim

if TYPE_CHECKING:
    from tandem.skills.wire.credentials import Credentials
    from tandem.skills.wire.forked_worker import ForkedWorker
    from tandem.skills.wire.zenoh_bus import ZenohBus

ROUTER_WITHIN: Final = 20.0
"""Host seconds for which a process waits for its router. The processes of a robot start at once or on several
hosts, and a router takes up to ten seconds to start on a busy machine; who waits much longer hides a wrong
endpoint."""

_LOG = logging.getLogger(__name__)


def load_ahead(name: str) -> None:
    """Load what playing a role will need, so that its start takes no time for it later."""
    role = role_named(name)
    if role is not None and role.ahead is not None:
        role.ahead()


def play(
    settings: WorkerSettings, stopped: Callable[[], bool], *, router_within: float = ROUTER_WITHIN
) -> None:
    """Play a role until ``stopped`` says so.

    Args:
        settings: of the process.
        stopped: whether it is to end.
        router_within: host seconds for which it waits for its router.

    Raises:
        RefusalError: there is no such role, what it needs is not installed, another process plays it already,
            or the hardware does not tell who it is.
    """
    try:
        role = role_of(settings)
    except LookupError as error:
        raise RefusalError(str(error.args[0])) from error
    lacks = "" if role.extra is None else words_on(role.extra, f"the role {role.name}")
    if lacks:
        raise RefusalError(lacks)
    if role.route is not None:
        role.route(settings, stopped)
        return
    from tandem.skills.wire.presence import Presence, RivalError  # noqa: PLC0415

    worker = _fork_worker(role)  # while there is no session, and no thread of its
    bus = connect(settings, role, stopped, within=router_within)
    if bus is None:
        return
    try:
        # Settled long before ``process/...`` says that the role is ready to be played.
        presence = Presence(bus, settings.role, claim_of(settings))
        presence.settle(stopped)
        stage = Stage(settings, bus, presence, stopped, worker)
        if role.play is not None:
            role.play(stage)
        else:
            from tandem.executive.system.skill_process import play_skills  # noqa: PLC0415

            play_skills(stage, role)
    except RivalError as rival:
        raise RefusalError(
            f"{rival}, for {settings.prefix} at {settings.endpoint}; end it first, or give this robot keys "
            f"of its own with --robot"
        ) from rival
    finally:
        bus.close()


def connect(
    settings: WorkerSettings, role: Role, stopped: Callable[[], bool], *, within: float = ROUTER_WITHIN
) -> ZenohBus | None:
    """Return the process's end of the bus; None when it was stopped before the router was there.

    Raises:
        BusError: the router is not there ``within`` so many host seconds.
    """
    from tandem.skills.wire.zenoh_bus import BusError, ZenohBus  # noqa: PLC0415

    deadline, told = time.monotonic() + within, False
    while not stopped():
        try:
            return ZenohBus(
                settings.endpoint,
                settings.prefix,
                credentials=credentials_of(settings, role),
                silent_after=settings.silent_after,
                pictures=role.pictures or (bool(settings.record) and settings.record_pictures),
            )
        except BusError:
            if time.monotonic() >= deadline:
                raise
            if not told:
                _LOG.warning("waits for its router", extra={"endpoint": settings.endpoint})
                told = True
    return None


def _fork_worker(role: Role) -> ForkedWorker | None:
    """Return the worker of a role that has one from the start; None for the others, and where none can be."""
    if role.worker == "spawned":
        return None
    from tandem.skills.wire.forked_worker import fork_worker  # noqa: PLC0415

    if role.ahead is not None:
        role.ahead()
    return fork_worker(lambda: show(python("-m", "tandem.skills.wire.forked_worker", role.name)))


def claim_of(settings: WorkerSettings) -> Claim:
    """Return what this process claims its role with."""
    host = re.sub(r"[^0-9A-Za-z_-]", "-", socket.gethostname())[:64] or "host"
    lineage = settings.lineage or uuid.uuid4().hex[:12]
    return Claim(lineage, settings.generation, os.getpid(), host)


def credentials_of(settings: WorkerSettings, role: Role) -> Credentials | None:
    """Return the certificate and key that a process shows; None where no keys are used."""
    if settings.keys is None:
        return None
    from tandem.executive.security.identity import Identity  # noqa: PLC0415

    return Identity(Path(settings.keys), settings.holder).part(part_of(role))
