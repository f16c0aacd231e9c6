"""What zenoh is told."""

import json

import pytest
import zenoh

from tandem.skills.wire.configs import client_config
from tandem.skills.wire.zenoh_bus import HostError, open_session


def test_a_client_asks_for_a_router_that_is_not_there_yet_well_within_its_patience() -> None:
    connect = json.loads(client_config("tcp/127.0.0.1:7447", 0.5).get_json("connect"))
    assert connect["timeout_ms"] == 500
    assert connect["retry"]["period_init_ms"] < 50


def test_a_panic_of_zenohs_is_told_in_a_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    """With twelve open files allowed a command ended with a panic's traceback."""
    panic = type("PanicException", (BaseException,), {})

    def full(_config: zenoh.Config) -> zenoh.Session:
        raise panic("Failed to init tx")

    monkeypatch.setattr(zenoh, "open", full)
    with pytest.raises(HostError, match=r"can't start on this host.*ulimit"):
        open_session(zenoh.Config(), "tcp/127.0.0.1:7447")
