"""The other TIAGos: their postures fit them, and a system starts for a robot without hands."""

from __future__ import annotations

import json

import pytest

from tandem.executive.system.lockstep import Lockstep
from tandem.sim.robots.registry import robot_model, shipped
from tandem.sim.scenario import load_scenario
from tandem.skills.ports.keys import Nothing
from tandem.skills.ports.tasks import REQUEST, TASK_INFO


@pytest.mark.parametrize("name", shipped())
def test_every_posture_is_within_the_limits(name: str) -> None:
    description = robot_model(name).description
    for posture in description.postures:
        for limit, value in zip(description.group(posture.group).limits, posture.positions, strict=True):
            assert limit.lower <= value <= limit.upper, (posture.name, limit.joint)


@pytest.mark.parametrize("name", shipped())
def test_a_hand_is_on_a_group_that_is_called_after_it(name: str) -> None:
    description = robot_model(name).description
    for hand in description.end_effectors:
        assert hand.group == f"arm_{hand.side}"
        assert description.group(hand.group).joints


def test_a_robot_without_arms_starts_and_refuses_a_fetch_with_the_missing_part() -> None:
    lockstep = Lockstep(load_scenario("NoArms"), seed=1)
    try:
        assert [node.name for node in lockstep.nodes] == [
            "hardware",
            "keeper",
            "perception",
            "base",
            "executive",
        ]
        lockstep.run_until(lambda: False, within=0.2)
        asked = lockstep.bus.query(REQUEST, json.dumps({"task": "fetch", "item": 29}).encode())
        info = TASK_INFO.query(lockstep.bus, Nothing())
        lockstep.run_until(lambda: False, within=0.1)
        answer = json.loads(asked.poll() or b"{}")
        assert not answer["accepted"]
        assert answer["problems"][0]["found"] == "fetch needs a gripper"
        told = info.poll()
        assert told is not None
        assert TASK_INFO.decode_answer(told).unable["fetch"] == "fetch needs a gripper"
    finally:
        lockstep.close()
