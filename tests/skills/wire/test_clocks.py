"""The clock of a process that turns calmly: of several ticks the newest is read, and once."""

from __future__ import annotations

import pytest

from tandem.skills.ports.hardware import Clock
from tandem.skills.ports.keys import CLOCK, Topic
from tandem.skills.ports.message import RobotTime
from tandem.skills.site import load
from tandem.skills.wire.clocks import ProcessClocks
from tandem.skills.wire.memory import MemoryBus
from tandem.trees.knowledge import Knowledge


def tell(bus: MemoryBus, *ticks: int) -> None:
    for tick in ticks:
        CLOCK.publish(bus, Clock(stamp=RobotTime(boot="a", seconds=tick / 100), tick=tick))


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Keys of the payloads that are read."""
    keys: list[str] = []
    decode = Topic.decode

    def noted(topic: Topic[Clock], payload: bytes) -> Clock:
        keys.append(topic.key)
        return decode(topic, payload)

    monkeypatch.setattr(Topic, "decode", noted)
    return keys


def test_of_several_ticks_the_newest_alone_is_read(read: list[str]) -> None:
    bus = MemoryBus()
    clocks = ProcessClocks(bus)
    tell(bus, 1, 2, 3)
    tick = clocks.refresh()
    assert tick is not None
    assert (tick.tick, read) == (3, [CLOCK.key])
    assert clocks.refresh() is None


def test_a_tick_that_came_late_is_none() -> None:
    bus = MemoryBus()
    clocks = ProcessClocks(bus)
    tell(bus, 3)
    clocks.refresh()
    tell(bus, 2)
    assert clocks.refresh() is None
    assert clocks.passed() == 0.0


def test_what_trees_know_of_the_hardware_costs_no_second_reading(read: list[str]) -> None:
    bus = MemoryBus()
    clocks = ProcessClocks(bus)
    knowledge = Knowledge(bus, clocks, load("lab"))
    tell(bus, 1, 2, 3)
    clocks.refresh()
    knowledge.refresh()
    assert knowledge.hardware_silent_for is not None
    assert read == [CLOCK.key]
