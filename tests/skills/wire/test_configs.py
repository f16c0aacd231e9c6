"""What zenoh is told."""

import json

from tandem.skills.wire.configs import client_config


def test_a_client_asks_for_a_router_that_is_not_there_yet_well_within_its_patience() -> None:
    connect = json.loads(client_config("tcp/127.0.0.1:7447", 0.5).get_json("connect"))
    assert connect["timeout_ms"] == 500
    assert connect["retry"]["period_init_ms"] < 50
