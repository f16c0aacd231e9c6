"""A Panda on a pedestal picks and places by its description alone: no head, no drive, no laser."""

from __future__ import annotations

import json
import math

from tandem.executive.system.lockstep import Lockstep
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import REQUEST, TASK_STATUS, TaskState
from tandem.skills.site import load


def carried_out(lockstep: Lockstep, **document: object) -> TaskState:
    """Send a request and return the state in which its task ends."""
    news = Latest(lockstep.bus, TASK_STATUS)
    lockstep.bus.query(REQUEST, json.dumps(document).encode())

    def ended() -> bool:
        status = news.refresh()
        return status is not None and status.kind == document["task"] and status.state.terminal

    assert lockstep.run_until(ended, within=60.0)
    assert news.value is not None
    return news.value.state


def test_it_picks_an_item_places_it_and_refuses_what_takes_a_base_that_drives() -> None:
    lockstep = Lockstep(load_scenario("Bench"), seed=1)
    try:
        lockstep.run_until(lambda: False, within=0.2)
        fetch = lockstep.bus.query(REQUEST, b'{"task": "fetch", "item": 29}')
        assert carried_out(lockstep, task="pick", item=29) is TaskState.SUCCEEDED
        assert json.loads(fetch.poll() or b"{}")["problems"][0]["found"] == "fetch needs a base that drives"
        assert any(
            other.startswith("robot/gripper") for other in lockstep.station.truth().touching("item_29")
        )
        assert carried_out(lockstep, task="place", slot=1) is TaskState.SUCCEEDED
        truth, depot = lockstep.station.truth(), load("bench").depot("depot")
        assert truth.touching("item_29") == ("table.0",)
        assert depot is not None
        slot = depot.slots[1].position
        assert math.dist(truth.item(29).pose.position[:2], slot[:2]) < 0.02
    finally:
        lockstep.close()
