"""What every bus keeps to: in memory, over zenoh, and around another bus that changes nothing: one suite."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest

from tandem.executive.trials.campaigns.crash_points import CrashBus, CrashPoints
from tandem.sim.faulty_link import FaultyLink
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.forwarding_bus import ForwardingBus
from tandem.skills.scoped_bus import ScopedBus
from tandem.skills.testing.faulty_bus import BusFaults, FaultyBus
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.configs import router_config
from tandem.skills.wire.memory import MemoryBus, MemoryHub
from tandem.skills.wire.zenoh_bus import ZenohBus, open_session
from tests.fakes.ports import free_endpoint


@dataclass
class Pair:
    """Two ends of one bus, and a way to wait that suits it."""

    a: Bus
    b: Bus
    until: Callable[[Callable[[], bool]], bool]
    close_a: Callable[[], None]


def faulty_pair(faults: BusFaults | None) -> Pair:
    hub, clocks = MemoryHub(), SteppedClocks()
    inner = MemoryBus(hub), MemoryBus(hub)
    a, b = (FaultyBus(bus, clocks, "1", faults) for bus in inner)
    return Pair(a, b, lambda condition: condition(), inner[0].close)


WRAPPERS: dict[str, Callable[[Bus], Bus]] = {
    "memory": lambda bus: bus,
    "forwarded": ForwardingBus,
    "scoped": ScopedBus,
    "a whole link": FaultyLink,
    "points that kill nobody": lambda bus: CrashBus(bus, CrashPoints()),
}


@pytest.fixture(params=[*WRAPPERS, "zenoh", "no faults", "shares of nothing"])
def pair(request: pytest.FixtureRequest) -> Iterator[Pair]:
    if request.param in WRAPPERS:
        hub, wrap = MemoryHub(), WRAPPERS[request.param]
        one = MemoryBus(hub)
        yield Pair(wrap(one), wrap(MemoryBus(hub)), lambda condition: condition(), one.close)
        return
    if request.param != "zenoh":
        yield faulty_pair(None if request.param == "no faults" else BusFaults())
        return
    endpoint = free_endpoint()
    router = open_session(router_config(endpoint), endpoint)
    a, b = ZenohBus(endpoint, "lab/robot"), ZenohBus(endpoint, "lab/robot")

    def until(condition: Callable[[], bool]) -> bool:
        deadline = time.monotonic() + 5.0
        while not (held := condition()) and time.monotonic() < deadline:
            a.waker.wait(0.005)
        return held

    yield Pair(a, b, until, a.close)
    a.close()
    b.close()
    router.close()


def collect(pair: Pair, key: str, count: int, send: Callable[[], None]) -> list[tuple[str, bytes]]:
    inbox = pair.a.subscribe(key)
    assert pair.until(lambda: pair.b.listened(key.replace("**", "x").replace("*", "x")))
    send()
    got: list[tuple[str, bytes]] = []

    def arrived() -> bool:
        got.extend((sample.key, sample.payload) for sample in inbox.drain())
        return len(got) >= count

    pair.until(arrived)
    return got


def test_what_is_put_arrives_in_order(pair: Pair) -> None:
    """A burst shares its batches on the way: one batch for each message would lose half of these."""
    sent = [("task/x", f"{number:03}".encode() * 100) for number in range(250)]
    got = collect(pair, "task/x", 250, lambda: [pair.b.publish(key, body) for key, body in sent] and None)
    assert got == sent


def test_a_star_is_one_part_of_a_key(pair: Pair) -> None:
    def send() -> None:
        for key in ("hw/gripper/left/state", "hw/gripper/left/deep/state", "hw/gripper/x/state"):
            pair.b.publish(key, b"")

    inbox = pair.a.subscribe("hw/gripper/*/state")
    assert pair.until(lambda: pair.b.listened("hw/gripper/x/state"))
    send()
    got: list[str] = []

    def arrived() -> bool:
        got.extend(sample.key for sample in inbox.drain())
        return len(got) >= 2

    pair.until(arrived)
    assert got == ["hw/gripper/left/state", "hw/gripper/x/state"]


def test_a_picture_arrives_whole(pair: Pair) -> None:
    body = bytes(range(256)) * 20_000
    assert collect(pair, "hw/camera", 1, lambda: pair.b.publish("hw/camera", body)) == [("hw/camera", body)]


def test_a_closed_inbox_gets_nothing(pair: Pair) -> None:
    inbox = pair.a.subscribe("hw/x")
    assert pair.until(lambda: pair.b.listened("hw/x"))
    inbox.close()
    assert pair.until(lambda: not pair.b.listened("hw/x"))


def test_a_full_inbox_loses_the_oldest(pair: Pair) -> None:
    inbox = pair.a.subscribe("task/x", depth=2)
    last = pair.a.subscribe("task/end")
    assert pair.until(lambda: pair.b.listened("task/x") and pair.b.listened("task/end"))
    for number in range(5):
        pair.b.publish("task/x", bytes([number]))
    pair.b.publish("task/end", b"")
    assert pair.until(lambda: bool(last.drain()))
    time.sleep(0.1)  # over zenoh each subscription has a thread of its own: the end may overtake
    assert [sample.payload for sample in inbox.drain()] == [bytes([3]), bytes([4])]


def test_a_query_is_answered(pair: Pair) -> None:
    desk = pair.a.serve("skill/x/goal")

    def asked() -> bool:
        pending = pair.b.query("skill/x/goal", b"ask")
        pair.until(lambda: bool(answer(desk)) or pending.done())
        pair.until(pending.done)
        return pending.poll() == b"answer to ask"

    def answer(desk: object) -> list[None]:
        return [request.reply(b"answer to " + request.payload) for request in desk.drain()]  # type: ignore[attr-defined]

    assert pair.until(asked)


def test_a_selector_is_told_from_a_key_and_answered_under_one(pair: Pair) -> None:
    desk = pair.a.serve("task/list")
    seen: list[tuple[str, str, bool]] = []

    def answer() -> bool:
        for request in desk.drain():
            seen.append((request.key, request.selector, request.covers("task/list")))
            request.reply(b"here")
        return bool(seen)

    def asked(selector: str) -> bytes | None:
        seen.clear()
        pending = pair.b.query(selector, b"")
        pair.until(lambda: answer() or pending.done())
        pair.until(pending.done)
        return pending.poll()

    assert pair.until(lambda: asked("task/list") == b"here")
    assert seen == [("task/list", "task/list", True)]
    assert asked("task/**") == b"here"
    assert seen == [("task/list", "task/**", True)]


def test_at_a_pattern_no_selector_is_a_key(pair: Pair) -> None:
    desk = pair.a.serve("task/*/status")
    seen: list[tuple[str, str]] = []

    def asked(selector: str) -> bytes | None:
        seen.clear()
        pending = pair.b.query(selector, b"")

        def answer() -> bool:
            for request in desk.drain():
                seen.append((request.key, request.selector))
                request.reply_each({key: b"here" for key in ["task/x/status"] if request.covers(key)})
            return bool(seen) or pending.done()

        pair.until(answer)
        pair.until(pending.done)
        return pending.poll()

    assert pair.until(lambda: asked("task/x/status") == b"here")
    assert seen == [("task/x/status", "task/x/status")]
    assert asked("**") == b"here"
    assert seen == [("", "**")]


def test_a_query_may_be_answered_with_an_error(pair: Pair) -> None:
    desk = pair.a.serve("task/list")

    def refused() -> bool:
        pending = pair.b.query("task/list", b"")
        pair.until(lambda: bool([each.refuse(b'"no"') for each in desk.drain()]) or pending.done())
        pair.until(pending.done)
        return pending.refusal() == b'"no"' and pending.poll() is None

    assert pair.until(refused)


def test_of_too_heavy_a_query_only_the_size_is_kept(pair: Pair) -> None:
    desk = pair.a.serve("task/list", limit=10)
    seen: list[tuple[int, bytes]] = []

    def asked() -> bool:
        pending = pair.b.query("task/list", b"x" * 11)
        pair.until(
            lambda: bool([seen.append((each.size, each.payload)) for each in desk.drain()]) or pending.done()
        )
        return bool(seen)

    assert pair.until(asked)
    assert seen == [(11, b"")]


def test_a_query_that_nobody_serves_ends_empty(pair: Pair) -> None:
    pending = pair.b.query("no/one", b"", timeout=0.5)
    assert pair.until(pending.done)
    assert pending.poll() is None


def test_names_are_alive_while_announced(pair: Pair) -> None:
    pair.a.announce("skill/look")
    assert pair.until(lambda: "skill/look" in pair.b.alive())
    pair.close_a()
    assert pair.until(lambda: "skill/look" not in pair.b.alive())


def test_other_robots_at_the_router_are_known_by_their_processes() -> None:
    endpoint = free_endpoint()
    router = open_session(router_config(endpoint), endpoint)
    mine, other, client = (ZenohBus(endpoint, f"lab/{name}") for name in ("mine", "other", "client"))
    mine.announce("process/base")
    other.announce("process/executive")
    client.announce("client/ann")
    deadline = time.monotonic() + 5.0
    # What is announced reaches the router a moment later: a look at once may come before it.
    while not (found := mine.neighbours(timeout=2.0)) and time.monotonic() < deadline:
        mine.waker.wait(0.01)
    for each in (mine, other, client):
        each.close()
    router.close()
    assert found == {"lab/other"}


def test_a_session_that_has_just_been_opened_knows_who_is_present() -> None:
    endpoint = free_endpoint()
    router = open_session(router_config(endpoint), endpoint)
    first = ZenohBus(endpoint, "lab/robot")
    first.claim("claim/hardware/first")
    assert first.claims("claim/hardware/*", timeout=2.0), "the router has it: it is asked over the same link"
    for _ in range(10):
        second = ZenohBus(endpoint, "lab/robot")
        assert second.claims("claim/hardware/*", timeout=2.0) == {"claim/hardware/first"}
        second.close()
    assert not first.claims("claim/executive/*", timeout=2.0)
    first.close()
    router.close()


def test_over_zenoh_what_is_told_steadily_arrives_and_wakes_nobody() -> None:
    endpoint = free_endpoint()
    router = open_session(router_config(endpoint), endpoint)
    a, b = ZenohBus(endpoint, "lab/robot"), ZenohBus(endpoint, "lab/robot")
    inboxes = {key: a.subscribe(key) for key in ("hw/joints/state", "hw/clock")}
    deadline = time.monotonic() + 5.0
    while not all(b.listened(key) for key in inboxes) and time.monotonic() < deadline:
        b.waker.wait(0.005)
    woken = []
    a.waker.wake = lambda: woken.append(1)  # type: ignore[method-assign]
    b.publish("hw/joints/state", b"joints")
    b.publish("hw/clock", b"clock")
    got: dict[str, bytes] = {}
    while len(got) < 2 and time.monotonic() < deadline:
        got |= {each.key: each.payload for inbox in inboxes.values() for each in inbox.drain()}
    for end in (a, b, router):
        end.close()
    assert got == {"hw/joints/state": b"joints", "hw/clock": b"clock"}
    assert len(woken) == 1
