"""A program that reads the robot's topics is stopped in a debugger. The robot must not stop with it.

A user saw: with ``hw/camera/head/rgbd`` or ``**`` subscribed by a process under SIGSTOP, the hardware's
clock, its dead man's switch and its stop stood still for 5 to 20 s, and tasks failed with SKILL_LOST.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Final

import pytest
import zenoh

from tests.fakes.ports import free_endpoint
from tests.outside._readers import readers
from tests.outside._up import client, until, up

SITE: Final = "frozen"
PREFIX: Final = f"{SITE}/tiago"
FROZEN_FOR: Final = 16.0
"""Seconds: a publisher that waits for a reader was held for 5 s, from the second picture on. After 10 s zenoh
gives such a reader up; a router that then waits for its connection to close was held for another 10 s."""
BOUND: Final = 2.0
"""Seconds between two messages; 0.02 on an idle machine, and the machine of the tests is not idle."""


class Gaps:
    """When messages of a key came: the longest time without one."""

    def __init__(self, session: zenoh.Session, key: str) -> None:
        self.count, self.longest, self._last = 0, 0.0, time.monotonic()
        self._subscriber = session.declare_subscriber(key, self._came)

    def _came(self, _: zenoh.Sample) -> None:
        now = time.monotonic()
        self.count, self.longest, self._last = self.count + 1, max(self.longest, now - self._last), now

    def begin(self) -> None:
        """Count from now on."""
        self.count, self.longest, self._last = 0, 0.0, time.monotonic()


@pytest.mark.processes
def test_the_robot_goes_on_while_its_readers_stand_still(tmp_path: Path) -> None:
    endpoint = free_endpoint()
    with (
        up(endpoint, SITE, tmp_path, only="router,hardware"),
        client(endpoint) as session,
        readers(endpoint, "**", 2) as everything,
        readers(endpoint, f"{PREFIX}/hw/camera/head/rgbd", 1) as pictures,
    ):
        heard = {
            key: Gaps(session, f"{PREFIX}/{key}") for key in ("hw/clock", "hw/joints/state", "beat/hardware")
        }
        seen = Gaps(session, f"{PREFIX}/hw/camera/head/rgbd")
        until(lambda: seen.count > 1, 30.0)
        for reader in (*everything, *pictures):
            reader.freeze()
        for each in (*heard.values(), seen):
            each.begin()
        end = time.monotonic() + FROZEN_FOR
        until(lambda: time.monotonic() >= end, FROZEN_FOR + 1.0)
        longest = {key: max(each.longest, time.monotonic() - each._last) for key, each in heard.items()}
        assert max(longest.values()) < BOUND, longest
        until(lambda: seen.count > 1, 60.0)  # a reader that reads gets pictures, as fast as they are drawn
