"""``tandem hardware check`` against a simulated robot in processes, as a driver's author has it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from tandem.skills.ports import keys
from tandem.skills.ports.lease import Claim, LeaseRequest, claim_name
from tandem.skills.wire.zenoh_bus import ZenohBus
from tests.outside._command import free_port, running, tandem
from tests.outside._up import until

pytestmark = [pytest.mark.processes, pytest.mark.xdist_group("processes")]


@pytest.fixture(scope="module")
def env(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, str]]:
    made = {
        "TANDEM_CONNECT": f"tcp/127.0.0.1:{free_port()}",
        "TANDEM_SITE": "check-test",
        "TANDEM_ROBOT": "panda",
        "XDG_STATE_HOME": str(tmp_path_factory.mktemp("state")),
    }
    with running("up", "--only", "router,hardware", "--scenario", "Bench", env=made) as up:
        up.await_word("press Ctrl-C to stop")
        yield made


def test_a_sound_driver_passes_also_what_moves(env: dict[str, str]) -> None:
    done = tandem("hardware", "check", "--moving", "--yes", env=env, within=240.0)
    assert done.code == 0, done.said
    assert "ok       trajectory_reaches" in done.out
    assert "skipped  velocity_obeyed: the robot has no drive" in done.out
    assert " 0 failed," in done.out


def test_without_moving_it_tries_what_moves_nothing_and_prints_one_document(env: dict[str, str]) -> None:
    done = tandem("hardware", "check", "--json", env=env)
    assert done.code == 0, done.said
    found = json.loads(done.out)["clauses"]
    assert not any(each["moving"] for each in found)
    assert {each["state"] for each in found} == {"ok", "skipped"}


def test_nothing_moves_before_somebody_says_so(env: dict[str, str]) -> None:
    done = tandem("hardware", "check", "--moving", env=env)
    assert done.code == 2
    assert "--yes" in done.err


def test_it_moves_nothing_that_others_command(env: dict[str, str]) -> None:
    claim = Claim("somebody", 1, 1, "host")
    bus = ZenohBus(env["TANDEM_CONNECT"], "check-test/panda")
    try:
        bus.announce(claim_name("arm_single", claim))
        pending = keys.LEASE.query(bus, LeaseRequest(role="arm_single", claim=claim.text))
        until(lambda: pending.poll() is not None, 10.0)
        moving = tandem("hardware", "check", "--moving", "--yes", env=env)
        still = tandem("hardware", "check", env=env)
    finally:
        bus.close()
    assert moving.code == 4, moving.said
    assert "arm_single command" in moving.err
    assert still.code == 0, still.said
    assert "skipped  stop_refuses: arm_single command" in still.out


def test_where_nothing_serves_the_hardware_it_says_so(env: dict[str, str], tmp_path: Path) -> None:
    done = tandem("hardware", "check", env=env | {"TANDEM_ROBOT": "nobody"}, cwd=tmp_path)
    assert done.code == 3
    assert "no hardware answers on check-test/nobody" in done.err


def test_the_clauses_are_listed_without_a_robot() -> None:
    done = tandem("hardware", "check", "--list", "--connect", "tcp/127.0.0.1:1")
    assert done.code == 0
    assert done.out.startswith("description_served: ")
    assert "stop_brakes (moves): " in done.out
