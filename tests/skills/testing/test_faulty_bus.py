"""A bus that loses, delays, doubles and mixes up: by its seed, and only what it may."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from tandem.skills.ports.bus import Bus
from tandem.skills.testing.faulty_bus import BusFaults, FaultyBus
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryBus, MemoryHub


class Ends:
    """A sound end and a faulty one of the same bus."""

    def __init__(self, faults: BusFaults, seed: int = 1) -> None:
        hub = MemoryHub()
        self.clocks = SteppedClocks()
        self.sound: Bus = MemoryBus(hub)
        self.faulty: Bus = FaultyBus(MemoryBus(hub), self.clocks, str(seed), faults)

    def send(self, key: str, count: int, *, every: float = 0.01, more: float = 0.0) -> list[int]:
        """Send numbers, and return those that get through, in their order."""
        inbox, got = self.faulty.subscribe(key), list[int]()
        for number in range(count + round(more / every)):
            if number < count:
                self.sound.publish(key, bytes([number]))
            got += [sample.payload[0] for sample in inbox.drain()]
            self.clocks.advance(every)
        return got


def test_a_share_gets_lost() -> None:
    got = Ends(BusFaults(drop=0.3)).send("skill/x/status", 200)
    assert 120 < len(got) < 160
    assert got == sorted(set(got))


def test_a_share_comes_twice() -> None:
    got = Ends(BusFaults(double=0.5)).send("world/state", 200)
    assert 270 < len(got) < 330
    assert got == sorted(got)
    assert set(got) == set(range(200))


def test_a_share_is_overtaken() -> None:
    got = Ends(BusFaults(reorder=0.2)).send("task/x", 200, more=0.2)
    assert got != sorted(got)
    assert sorted(got) == list(range(200))


def test_what_is_late_stays_in_order_and_comes_within_the_delay() -> None:
    ends = Ends(BusFaults(delay=0.5))
    inbox = ends.faulty.subscribe("world/x")
    ends.sound.publish("world/x", b"1")
    ends.sound.publish("world/x", b"2")
    assert inbox.drain() == []
    ends.clocks.advance(0.5)
    assert [sample.payload for sample in inbox.drain()] == [b"1", b"2"]


@pytest.mark.parametrize("key", ["hw/clock", "hw/stop/state", "sim/x"])
def test_other_keys_are_spared(key: str) -> None:
    ends = Ends(BusFaults(drop=1.0, keys=("hw/", "skill/")))
    assert ends.send(key, 5) == [0, 1, 2, 3, 4]


def test_the_seed_decides() -> None:
    faults = BusFaults(drop=0.2, double=0.2, reorder=0.2, delay=0.1)
    one, again, other = (Ends(faults, seed).send("skill/x", 100, more=0.5) for seed in (1, 1, 2))
    assert one == again
    assert one != other


def test_a_lost_question_reaches_nobody_and_ends_in_its_time() -> None:
    ends = Ends(BusFaults(drop=1.0), seed=3)
    desk = ends.sound.serve("skill/x/goal")
    reached = 0
    for _ in range(100):
        pending = ends.faulty.query("skill/x/goal", b"", timeout=1.0)
        for request in desk.drain():
            reached += 1
            request.reply(b"yes")
        assert (pending.poll(), pending.done()) == (None, False)
        ends.clocks.advance(1.0)
        assert (pending.poll(), pending.done()) == (None, True)
    assert 30 < reached < 70, "of half the queries the answer got lost, not the question"


def test_an_answer_is_late() -> None:
    ends = Ends(BusFaults(delay=0.5))
    desk = ends.sound.serve("task/x")
    pending = ends.faulty.query("task/x", b"")
    for request in desk.drain():
        request.reply(b"yes")
    assert (pending.poll(), pending.done()) == (None, False)
    ends.clocks.advance(0.5)
    assert (pending.poll(), pending.done()) == (b"yes", True)


def test_a_request_comes_twice_and_its_first_answer_counts() -> None:
    ends = Ends(BusFaults(double=1.0))
    desk = ends.faulty.serve("skill/x/goal")
    pending = ends.sound.query("skill/x/goal", b"ask")
    requests = desk.drain()
    assert [request.payload for request in requests] == [b"ask", b"ask"]
    for number, request in enumerate(requests):
        request.reply(bytes([number]))
    assert pending.poll() == bytes([0])


def test_what_is_no_share_is_refused() -> None:
    with pytest.raises(ValidationError, match="less than or equal to 1"):
        BusFaults(drop=1.5)
