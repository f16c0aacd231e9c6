"""Lets the stand-in's time pass: at a pace, or as fast as all who follow it go."""

from __future__ import annotations

import gc
import time
from typing import TYPE_CHECKING, Final

from tandem.skills.ports.keys import Latest
from tandem.skills.wire.loop import FOLLOW, FOLLOWS

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from tandem.sim.station import Station
    from tandem.skills.wire.zenoh_bus import ZenohBus

PATIENCE: Final = 0.5
"""Host seconds that a follower is waited for; one that hangs must not stop the world."""
FALLEN_BEHIND: Final = 0.25
"""Host seconds by which the pace may lag before it is given up and begun anew."""
WARM_WITHIN: Final = 15.0
"""Host seconds that the renderer has for its first picture."""
PICTURE_LATE: Final = 0.15
"""Robot seconds after which a picture that is still being drawn is waited for."""


def await_renderer(station: Station, bus: ZenohBus, stopped: Callable[[], bool]) -> None:
    """Answer who asks, and let no time pass, until the camera can take pictures at its rate.

    The first picture takes seconds, as the renderer loads the room; a robot that tells it is there has eyes.
    """
    deadline = time.monotonic() + WARM_WITHIN
    while station.studio.warming() and not stopped() and time.monotonic() < deadline:
        station.hear()
        bus.waker.wait(0.02)


def run_paced(
    station: Station, buses: Sequence[ZenohBus], speed: float | None, stopped: Callable[[], bool]
) -> None:
    """Step the station until ``stopped`` says so.

    Args:
        station: one step is one period.
        buses: of the robots; they tell who follows, and the first one wakes the wait for all.
        speed: simulated seconds in a second; None: as fast as the followers go.
        stopped: asked once a period.
    """
    # As in skills/wire/loop.py: a collection of all takes 30 ms here, and a stop may have to wait for it.
    gc.collect()
    gc.freeze()
    period = station.model.description.period
    followers = [Followers(bus) for bus in buses]
    due = time.monotonic()
    while not stopped():
        for bus in buses:
            bus.beat()
        station.step()
        if speed is None and not station.silent:
            for each in followers:
                each.wait_for(station.hardware.tick)
            _wait_for_picture(station, buses[0])
            continue
        # Silent hardware hurries nobody: who waits for it counts the host's seconds.
        due += period / (speed or 1.0)
        now = time.monotonic()
        if now - due > FALLEN_BEHIND:
            due = now
        while (left := due - time.monotonic()) > 0.0:
            buses[0].waker.wait(left)
            # A stop need not wait for the period's end to be heard.
            station.hear()


class Followers:
    """The processes that the hardware waits for, faster than real time: all that say that they follow."""

    def __init__(self, bus: ZenohBus) -> None:
        """Listen to them."""
        self._bus = bus
        self._said = Latest(bus, FOLLOW, depth=1024)
        self._through: dict[str, int] = {}

    def wait_for(self, tick: int) -> None:
        """Wait until all are through with the tick, or have had their time."""
        deadline = time.monotonic() + PATIENCE
        while True:
            for said in self._said.take():
                self._through[said.follower] = max(said.tick, self._through.get(said.follower, 0))
            if all(self._through.get(name, 0) >= tick for name in self._names()):
                return
            left = deadline - time.monotonic()
            if left <= 0.0:
                return
            self._bus.waker.wait(left)

    def _names(self) -> list[str]:
        return [name.removeprefix(FOLLOWS) for name in self._bus.alive() if name.startswith(FOLLOWS)]


def _wait_for_picture(station: Station, bus: ZenohBus) -> None:
    deadline = time.monotonic() + PATIENCE
    now = station.hardware.now
    for camera in station.cameras:
        while camera.late_by(now) > PICTURE_LATE and time.monotonic() < deadline:
            bus.waker.wait(0.005)
            camera.step(now)
