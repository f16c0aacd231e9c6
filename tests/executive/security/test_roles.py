"""Every role against every class of keys, over mutual TLS: what is not allowed doesn't arrive.

The tables are written by hand, from what is promised; they don't know the rules that the program has.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.executive.security.authority import Wanted, begin, issue, revoke
from tandem.executive.security.identity import Identity
from tandem.skills.ports.bus import Desk, Inbox
from tandem.skills.wire.zenoh_bus import BusError, ZenohBus
from tests.executive.security.bus_with_keys import EVERYBODY, NOW, PREFIX, Secured, secured

pytestmark = pytest.mark.processes

ROBOT = {"hardware", "skills", "executive"}
READERS = {"viewer", "requester", "requester-2", "operator"}

PUTS = [
    # key, who listens there, who may put there
    ("task/request", "executive", {"operator"}),
    ("task/by/requester/request", "executive", {"requester"}),
    ("task/by/requester-2/request", "executive", {"requester-2"}),
    ("task/by/operator/request", "executive", {"operator"}),
    ("task/status", "viewer", {"executive"}),
    ("task/fetch-1/status", "viewer", {"executive"}),
    ("tree/snapshot", "viewer", {"executive"}),
    ("world/state", "executive", {"skills"}),
    ("skill/base/drive/status", "executive", {"skills"}),
    ("hw/clock", "skills", {"hardware"}),
    ("hw/stop/state", "executive", {"hardware"}),
    ("hw/base/velocity", "hardware", {"hardware", "skills"}),
    ("hw/group/arm_left/setpoint", "hardware", {"hardware", "skills"}),
    ("sim/follow", "hardware", {"skills", "executive"}),
    ("sim/faults", "supervisor", {"hardware"}),
    ("beat/base", "skills", {*ROBOT, "supervisor"}),
]
QUERIES = [
    # key, who answers there, who may ask there
    ("task/request", "executive", {"operator"}),
    ("task/by/requester/request", "executive", {"requester"}),
    ("task/by/requester/cancel", "executive", {"requester"}),
    ("task/by/requester-2/cancel", "executive", {"requester-2"}),
    ("task/cancel", "executive", {"operator"}),
    ("task/pause", "executive", {"operator"}),
    ("task/resume", "executive", {"operator"}),
    ("task/step", "executive", {"operator"}),
    ("task/list", "executive", {*READERS, "supervisor"}),
    ("task/kinds", "executive", {*READERS, "supervisor"}),
    ("task/info", "executive", {*READERS, "supervisor"}),
    ("tree/now", "executive", {*READERS, "supervisor"}),
    ("skill/base/drive/goal", "skills", {"executive"}),
    ("skill/base/drive/command", "skills", {"executive"}),
    ("skill/base/drive/result", "skills", {*READERS, "executive"}),
    ("skill/perception/picture", "skills", {*READERS, "executive"}),
    ("hw/description", "hardware", {*READERS, "skills", "executive", "supervisor"}),
    ("hw/group/arm_left/goal", "hardware", {"skills"}),
    ("hw/group/arm_left/cancel", "hardware", {"skills"}),
    ("hw/gripper/left/command", "hardware", {"skills"}),
    ("hw/stop", "hardware", {"skills", "executive", "operator"}),
    ("hw/stop/release", "hardware", {"operator"}),
    ("sim/move", "hardware", {"operator", "supervisor"}),
    ("sim/truth", "hardware", {"operator", "supervisor"}),
]
HEARD = [
    # key, who puts there, who may listen there
    ("task/by/requester/request", "requester", {"executive", "operator", "supervisor"}),
    ("task/request", "operator", {"executive", "operator", "supervisor"}),
    ("task/answers", "executive", {*READERS, "executive", "supervisor"}),
    ("tree/snapshot", "executive", {*READERS, "supervisor"}),
    ("world/scene", "skills", {*READERS, "skills", "executive", "supervisor"}),
    ("hw/base/laser", "hardware", {*READERS, *ROBOT, "supervisor"}),
    ("sim/follow", "skills", {"hardware", "operator", "supervisor"}),
]
SERVED = [
    # key, who asks there, who may answer there
    ("task/list", "viewer", {"executive"}),
    ("skill/base/drive/goal", "executive", {"skills"}),
    ("hw/stop", "operator", {"hardware"}),
    ("hw/description", "skills", {"hardware"}),
]


@pytest.fixture(scope="module")
def bus(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Secured]:
    with secured(tmp_path_factory.mktemp("keys")) as made:
        yield made


def fence(bus: Secured) -> None:
    """Return when all that was sent before has arrived: a query goes the same way, behind it."""
    desks = {part: bus.sessions[part].serve(f"{room}/fence") for part, room in ROOMS.items()}
    for part, desk in desks.items():
        asker = bus.sessions[ASKS_FENCE[part]]
        assert bus.until(lambda asker=asker, part=part, desk=desk: answered(bus, asker, part, desk))  # type: ignore[misc]
        desk.close()


ROOMS = {"executive": "task", "skills": "skill", "hardware": "sim"}
ASKS_FENCE = {"executive": "operator", "skills": "executive", "hardware": "supervisor"}


def answered(bus: Secured, asker: ZenohBus, part: str, desk: Desk) -> bool:
    pending = asker.query(f"{ROOMS[part]}/fence", b"")
    bus.until(lambda: bool([each.reply(b"yes") for each in desk.drain()]) or pending.done(), 1.0)
    bus.until(pending.done, 1.0)
    return pending.poll() == b"yes"


def names(inbox: Inbox | Desk) -> set[str]:
    return {each.payload.decode() for each in inbox.drain()}


def test_puts_reach_their_listener_from_those_who_may(bus: Secured) -> None:
    inboxes = [bus.sessions[listener].subscribe(key) for key, listener, _ in PUTS]
    for key, listener, allowed in PUTS:
        for who in sorted(allowed - {listener}):
            assert bus.until(lambda who=who, key=key: bus.sessions[who].listened(key)), (who, key)  # type: ignore[misc]
    for key, listener, _ in PUTS:
        for who in EVERYBODY:
            if who != listener:  # a session hears itself without any router
                bus.sessions[who].publish(key, who.encode())
    fence(bus)
    arrived: list[set[str]] = [set() for _ in PUTS]

    def all_there() -> bool:
        for got, inbox in zip(arrived, inboxes, strict=True):
            got.update(names(inbox))
        return all(got >= allowed - {who} for got, (_, who, allowed) in zip(arrived, PUTS, strict=True))

    bus.until(all_there)
    fence(bus)
    all_there()
    assert dict(zip(((key, who) for key, who, _ in PUTS), arrived, strict=True)) == {
        (key, who): allowed - {who} for key, who, allowed in PUTS
    }
    for inbox in inboxes:
        inbox.close()


def test_queries_reach_their_server_from_those_who_may(bus: Secured) -> None:
    desks = [bus.sessions[server].serve(key) for key, server, _ in QUERIES]
    fence(bus)
    for (key, server, allowed), desk in zip(QUERIES, desks, strict=True):
        asked, answers = set(), set()
        pending = {
            who: bus.sessions[who].query(key, who.encode(), timeout=1.0) for who in EVERYBODY if who != server
        }

        def over(desk: Desk = desk, pending: dict = pending, asked: set = asked) -> bool:  # type: ignore[type-arg]
            for request in desk.drain():
                asked.add(request.payload.decode())
                request.reply(b"yes")
            return all(each.done() for each in pending.values())

        assert bus.until(over), key
        answers = {who for who, each in pending.items() if each.poll() == b"yes"}
        assert (key, asked, answers) == (key, allowed, allowed)
    for desk in desks:
        desk.close()


def test_those_who_may_not_listen_hear_nothing(bus: Secured) -> None:
    for key, sender, allowed in HEARD:
        listeners = [who for who in EVERYBODY if who != sender]
        inboxes = {who: bus.sessions[who].subscribe(key) for who in listeners}
        fence(bus)
        bus.sessions[sender].publish(key, b"x")
        fence(bus)
        heard: set[str] = set()

        def all_there(
            inboxes: dict = inboxes, heard: set = heard, allowed: set = allowed, by: str = sender
        ) -> bool:  # type: ignore[type-arg]
            heard |= {who for who, inbox in inboxes.items() if inbox.drain()}
            return heard >= allowed - {by}

        bus.until(all_there)
        assert (key, heard) == (key, allowed - {sender})
        for inbox in inboxes.values():
            inbox.close()


def test_nobody_answers_in_anothers_place(bus: Secured) -> None:
    for key, asker, allowed in SERVED:
        desks = {who: bus.sessions[who].serve(key) for who in EVERYBODY if who not in {*allowed, asker}}
        fence(bus)
        pending = bus.sessions[asker].query(key, b"", timeout=0.3)
        assert bus.until(pending.done)
        assert {who for who, desk in desks.items() if desk.drain()} == set(), key
        for desk in desks.values():
            desk.close()


def test_only_the_robot_announces_itself(bus: Secured) -> None:
    for who in EVERYBODY:
        bus.sessions[who].announce(f"test/{who}")
    watching = bus.sessions["viewer"]
    robot = {*ROBOT, "supervisor"}
    bus.until(lambda: {f"test/{who}" for who in robot} <= watching.alive())
    fence(bus)
    seen = {name for name in bus.sessions["operator"].alive() if name.startswith("test/")}
    assert seen - {"test/operator"} == {f"test/{who}" for who in robot}


def test_all_that_there_is_can_be_asked_for_by_nobody(bus: Secured) -> None:
    inboxes = {who: bus.sessions[who].subscribe("**") for who in EVERYBODY if who != "executive"}
    fence(bus)
    bus.sessions["executive"].publish("task/status", b"x")
    fence(bus)
    assert {who for who, inbox in inboxes.items() if inbox.drain()} == set()
    for inbox in inboxes.values():
        inbox.close()


def test_another_authoritys_key_opens_nothing(bus: Secured, tmp_path: Path) -> None:
    begin(tmp_path, NOW)
    issue(tmp_path, Wanted("operator", "operator"), NOW)
    stranger = Identity(tmp_path, "operator").client()
    with pytest.raises(BusError):
        ZenohBus(bus.endpoint, PREFIX, patience=0.5, credentials=stranger)
    with pytest.raises(BusError):
        ZenohBus(bus.endpoint, PREFIX, patience=0.5)


def test_a_key_that_is_revoked_is_out_at_once(bus: Secured) -> None:
    desk = bus.sessions["executive"].serve("task/pause")

    def may(who: str) -> bool:
        pending = bus.sessions[who].query("task/pause", b"", timeout=0.5)
        bus.until(lambda: bool([each.reply(b"yes") for each in desk.drain()]) or pending.done(), 1.0)
        bus.until(pending.done, 1.0)
        return pending.poll() == b"yes"

    issue(bus.folder, Wanted("operator", "second"), NOW)
    bus.router.step()
    second = ZenohBus(bus.endpoint, PREFIX, credentials=Identity(bus.folder, "second").client())
    bus.sessions["second"] = second
    assert bus.until(lambda: may("second"))
    revoke(bus.folder, "second")
    bus.router.step()
    assert bus.until(lambda: may("operator"))
    assert not may("second")
    assert second.alive() >= set()


def test_states_are_asked_for_again_by_those_who_may_hear_them(bus: Secured) -> None:
    skills, liar = bus.sessions["skills"], bus.sessions["requester-2"]
    skills.publish("world/state", b"believed")
    liar.publish("world/state", b"a lie")
    # A session's own questions reach its own desk by no router, so neither of the two that tell is asked.
    asking = {who: bus.sessions[who] for who in EVERYBODY if who not in {"skills", "requester-2"}}
    answers: dict[str, bytes | None] = {}

    def ask() -> bool:
        pending = {who: bus.query("kept/world/state", b"", timeout=1.0) for who, bus in asking.items()}

        def over() -> bool:
            skills.beat()
            liar.beat()
            return all(each.done() for each in pending.values())

        bus.until(over)
        answers.update((who, each.poll()) for who, each in pending.items())
        return answers["operator"] is not None

    assert bus.until(ask, 10.0)
    assert {who for who, answer in answers.items() if answer is not None} == {
        "executive",
        "supervisor",
        "viewer",
        "requester",
        "operator",
    }
    assert set(answers.values()) == {b"believed", None}


def test_only_the_executive_tells_the_site_and_only_of_its_own_robot(bus: Secured) -> None:
    heard = bus.sessions["skills"].commons().subscribe("world/robots/*")
    commons = {who: bus.sessions[who].commons() for who in EVERYBODY if who != "skills"}
    got: set[tuple[str, str]] = set()

    def tell() -> bool:
        for who, end in commons.items():
            for robot in ("tiago", "other"):
                end.publish(f"world/robots/{robot}", who.encode())
        got.update((each.key, each.payload.decode()) for each in heard.drain())
        return bool(got)

    assert bus.until(tell)
    fence(bus)
    tell()
    fence(bus)
    got.update((each.key, each.payload.decode()) for each in heard.drain())
    assert got == {("world/robots/tiago", "executive")}
    heard.close()
