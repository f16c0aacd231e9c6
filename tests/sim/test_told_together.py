"""What the hardware tells steadily goes out with what wakes its readers."""

from __future__ import annotations

from tandem.sim.told_together import ToldTogether
from tandem.skills.wire.memory import MemoryBus, MemoryHub


def test_what_wakes_nobody_waits_for_what_does_and_goes_before_it() -> None:
    hub = MemoryHub()
    heard = MemoryBus(hub).subscribe("hw/**")
    bus = ToldTogether(MemoryBus(hub))
    bus.publish("hw/joints/state", b"1")
    bus.publish("hw/base/odometry", b"2")
    assert not heard.drain()
    bus.publish("hw/clock", b"3")
    assert [each.payload for each in heard.drain()] == [b"1", b"2", b"3"]


def test_what_wakes_its_readers_goes_at_once() -> None:
    hub = MemoryHub()
    heard = MemoryBus(hub).subscribe("hw/**")
    bus = ToldTogether(MemoryBus(hub))
    bus.publish("hw/stop/state", b"1")
    assert [each.key for each in heard.drain()] == ["hw/stop/state"]
