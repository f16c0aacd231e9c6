"""Presence over zenoh: of those who want one role at the same moment exactly one has it."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest

from tandem.skills.ports.lease import Claim
from tandem.skills.wire.configs import router_config
from tandem.skills.wire.presence import Presence, RivalError
from tandem.skills.wire.zenoh_bus import ZenohBus, open_session
from tests.fakes.ports import free_endpoint

ROUNDS = 20


@pytest.fixture(scope="module")
def endpoint() -> Iterator[str]:
    endpoint = free_endpoint()
    router = open_session(router_config(endpoint), endpoint)
    yield endpoint
    router.close()  # type: ignore[no-untyped-call]


def presence(endpoint: str, claim: Claim, prefix: str, role: str = "executive") -> tuple[ZenohBus, Presence]:
    bus = ZenohBus(endpoint, prefix)
    return bus, Presence(bus, role, claim)


def go_on() -> bool:
    return False


def test_of_three_that_start_together_one_stays(endpoint: str) -> None:
    claims = [Claim(name, 1, number, "host") for number, name in enumerate("abc")]
    for turn in range(ROUNDS):
        gate = threading.Barrier(len(claims))

        def play(
            claim: Claim, prefix: str = f"lab/turn{turn}", gate: threading.Barrier = gate
        ) -> tuple[ZenohBus, bool]:
            bus, mine = presence(endpoint, claim, prefix)
            gate.wait(10.0)
            try:
                mine.settle(go_on)
            except RivalError:
                return bus, False
            return bus, True

        with ThreadPoolExecutor(len(claims)) as pool:
            ends = list(pool.map(play, claims))
        for bus, _ in ends:
            bus.close()
        assert [stays for _, stays in ends].count(True) == 1, f"turn {turn}: {ends}"


def test_whoever_comes_late_leaves_and_names_the_other_even_with_the_lower_claim(endpoint: str) -> None:
    first, settled = presence(endpoint, Claim("zz", 1, 4711, "there"), "lab/late")
    settled.settle(go_on)
    late, newcomer = presence(endpoint, Claim("aa", 1, 1, "here"), "lab/late")
    with pytest.raises(RivalError, match="process 4711 on there"):
        newcomer.settle(go_on)
    left = late.claims("claim/executive/**", timeout=2.0)
    assert not [key for key in left if "/aa." in key]
    assert settled.rival() is None
    late.close()
    first.close()


def test_a_later_process_of_the_same_parent_takes_the_place_at_once(endpoint: str) -> None:
    dead, before = presence(endpoint, Claim("aa", 1, 1, "host"), "lab/again")
    before.settle(go_on)
    bus, after = presence(endpoint, Claim("aa", 2, 2, "host"), "lab/again")
    after.settle(go_on)
    assert after.rival() is None
    dead.close()
    bus.close()


def test_roles_and_robots_do_not_meet(endpoint: str) -> None:
    ends = [
        presence(endpoint, Claim("aa", 1, 1, "host"), "lab/one"),
        presence(endpoint, Claim("bb", 1, 1, "host"), "lab/two"),
        presence(endpoint, Claim("cc", 1, 1, "host"), "lab/one", "hardware"),
    ]
    for _, each in ends:
        each.settle(go_on)
    for bus, _ in ends:
        bus.close()
