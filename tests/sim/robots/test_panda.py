"""A Panda on a pedestal picks by its description alone: a camera on a post, no head, no drive, no laser."""

from __future__ import annotations

import json

from tandem.executive.system.lockstep import Lockstep
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.tasks import REQUEST, TASK_STATUS, TaskState


def test_it_picks_an_item_and_refuses_what_takes_a_base_that_drives() -> None:
    lockstep = Lockstep(load_scenario("Bench"), seed=1)
    try:
        news = Latest(lockstep.bus, TASK_STATUS)
        lockstep.run_until(lambda: False, within=0.2)
        fetch, pick = (
            lockstep.bus.query(REQUEST, json.dumps({"task": task, "item": 29}).encode())
            for task in ("fetch", "pick")
        )

        def ended() -> bool:
            status = news.refresh()
            return status is not None and status.state.terminal

        assert lockstep.run_until(ended, within=60.0)
        refused, accepted = (json.loads(pending.poll() or b"{}") for pending in (fetch, pick))
        assert refused["problems"][0]["found"] == "fetch needs a base that drives"
        assert accepted["accepted"]
        assert news.value is not None
        assert news.value.state is TaskState.SUCCEEDED
        assert any(
            other.startswith("robot/gripper") for other in lockstep.station.truth().touching("item_29")
        )
    finally:
        lockstep.close()
