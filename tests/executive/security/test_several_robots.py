"""A router with the keys of two robots: the parts of each have their rights at their own robot only."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from tandem.executive.config.process_settings import WorkerSettings
from tandem.executive.security.authority import Wanted, begin, issue
from tandem.executive.security.identity import Identity
from tandem.executive.security.role import Part
from tandem.executive.system.router import Router
from tandem.skills.ports.bus import Desk
from tandem.skills.wire.credentials import Credentials
from tandem.skills.wire.zenoh_bus import ZenohBus
from tests.executive.security.bus_with_keys import NOW
from tests.fakes.ports import free_endpoint

pytestmark = pytest.mark.processes

STOP = "hw/stop"
"""Served by a robot's hardware; its skills, its executive and operators may ask there."""

DESCRIPTION = "hw/description"


class Site:
    """A router of the robots r2 and r3, with an operator kim, and sessions of theirs."""

    def __init__(self, folder: Path, ends: ExitStack) -> None:
        begin(folder, NOW)
        for wanted in (Wanted("robot", "r2"), Wanted("robot", "r3"), Wanted("operator", "kim")):
            issue(folder, wanted, NOW)
        self._folder, self._ends = folder, ends
        self._endpoint = free_endpoint().replace("tcp/", "tls/")
        settings = WorkerSettings(
            role="router",
            endpoint=self._endpoint,
            prefix="lab/r2",
            prefixes=("lab/r2", "lab/r3"),
            site="lab",
            keys=str(folder),
            holder="r2",
        )
        ends.callback(Router(settings, self._shown("r2", "router")).close)

    def _shown(self, who: str, part: Part | None = None) -> Credentials:
        identity = Identity(self._folder, who)
        return identity.client() if part is None else identity.part(part)

    def at(self, robot: str, who: str, part: Part | None = None) -> ZenohBus:
        bus = ZenohBus(self._endpoint, f"lab/{robot}", credentials=self._shown(who, part))
        self._ends.callback(bus.close)
        return bus


@pytest.fixture
def site(tmp_path: Path) -> Iterator[Site]:
    with ExitStack() as ends:
        yield Site(tmp_path / "keys", ends)


def answered(asker: ZenohBus, desk: Desk, key: str = STOP) -> bool:
    """Ask once, and have the desk's owner answer if that reaches it."""
    pending = asker.query(key, b"", timeout=1.0)
    while not pending.done():
        asker.waker.wait(0.005)
        for request in desk.drain():
            request.reply(b"yes")
    return pending.poll() == b"yes"


def answered_in_time(asker: ZenohBus, desk: Desk, key: str = STOP) -> bool:
    """Ask until there is an answer: that somebody serves there is told to the others a little later."""
    deadline = time.monotonic() + 5.0
    while not (got := answered(asker, desk, key)) and time.monotonic() < deadline:
        asker.waker.wait(0.005)
    return got


@pytest.mark.parametrize("robot", ["r2", "r3"])
def test_the_hardware_of_each_is_asked_by_its_own_skills_and_by_clients(site: Site, robot: str) -> None:
    other = {"r2": "r3", "r3": "r2"}[robot]
    desk = site.at(robot, robot, "hardware").serve(STOP)
    assert answered_in_time(site.at(robot, robot, "skills"), desk)
    assert answered_in_time(site.at(robot, "kim"), desk)
    assert not answered(site.at(robot, other, "skills"), desk)


def test_the_hardware_of_one_does_not_answer_for_the_other(site: Site) -> None:
    operator = site.at("r3", "kim")
    desk = site.at("r3", "r2", "hardware").serve(STOP)
    fence = site.at("r3", "r3", "hardware").serve(DESCRIPTION)
    assert answered_in_time(operator, fence, DESCRIPTION)
    assert not answered(operator, desk)
