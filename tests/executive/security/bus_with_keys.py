"""A router with mutual TLS and the access rules, and a session for everybody who has a key."""

from __future__ import annotations

import datetime as dt
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.security.authority import Wanted, begin, issue, revoke
from tandem.executive.security.identity import Identity
from tandem.executive.security.role import Part
from tandem.executive.system.router import Router
from tandem.skills.wire.credentials import Credentials
from tandem.skills.wire.zenoh_bus import ZenohBus
from tests.fakes.ports import free_endpoint

NOW = dt.datetime.now(dt.UTC)
PREFIX = "lab/tiago"
PARTS: dict[str, Part] = {
    "hardware": "hardware",
    "skills": "skills",
    "executive": "executive",
    "supervisor": "supervisor",
}
CLIENTS = ("viewer", "requester", "requester-2", "operator", "revoked")
EVERYBODY = (*PARTS, *CLIENTS)


def keys_in(folder: Path) -> Path:
    """Make keys for a robot and for a client of each kind; one has been revoked."""
    begin(folder, NOW)
    issue(folder, Wanted("robot", "tiago"), NOW)
    issue(folder, Wanted("viewer", "viewer"), NOW)
    issue(folder, Wanted("requester", "requester"), NOW)
    issue(folder, Wanted("requester", "requester-2"), NOW)
    issue(folder, Wanted("operator", "operator"), NOW)
    issue(folder, Wanted("operator", "revoked"), NOW)
    revoke(folder, "revoked")
    return folder


def shown(folder: Path, who: str) -> Credentials:
    robot = Identity(folder, "tiago")
    return robot.part(PARTS[who]) if who in PARTS else Identity(folder, who).client()


@dataclass
class Secured:
    """The sessions, and a way to wait."""

    folder: Path
    endpoint: str
    router: Router
    sessions: dict[str, ZenohBus]

    def until(self, holds: Callable[[], bool], within: float = 5.0) -> bool:
        deadline = time.monotonic() + within
        while not (held := holds()) and time.monotonic() < deadline:
            self.sessions["executive"].waker.wait(0.005)
        return held


@contextmanager
def secured(folder: Path) -> Iterator[Secured]:
    keys_in(folder)
    endpoint = free_endpoint().replace("tcp/", "tls/")
    settings = WorkerSettings(
        role="router", endpoint=endpoint, prefix=PREFIX, site="lab", keys=str(folder), holder="tiago"
    )
    router = Router(settings, Identity(folder, "tiago").part("router"))
    sessions = {who: ZenohBus(endpoint, PREFIX, credentials=shown(folder, who)) for who in EVERYBODY}
    try:
        yield Secured(folder, endpoint, router, sessions)
    finally:
        for session in sessions.values():
            session.close()
        router.close()
