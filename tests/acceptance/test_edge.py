"""A LoCoBot that is sent over an edge of the floor, which no site file has, does not fall, and says why."""

from __future__ import annotations

import pytest

from tandem.executive.system.systems import LockstepSystem
from tandem.sim.scenario import load_scenario
from tandem.sim.things import Drop
from tandem.skills.ports.action import GoalState, GoalStatus, SendGoal, goal_service, status_topic
from tandem.skills.ports.actions.base import DRIVE, LOCALISE, DriveGoal, LocaliseGoal
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Message
from tandem.skills.ports.pose import FloorPose

pytestmark = pytest.mark.lockstep

DROP = Drop(lower=(0.4, -1.0), upper=(1.2, 0.8), depth=0.15)
START = FloorPose(x=-1.0, y=-0.3, yaw=0.0)
BEYOND = DriveGoal(poses=(FloorPose(x=0.9, y=-0.3, yaw=0.0),))
TILT = 0.01
"""Half of the sine of a tilt of 20 mrad."""


def test_a_base_that_is_driven_towards_a_drop_stands_before_it_and_says_why() -> None:
    bare = {"items": (), "obstacles": (), "start": START, "drop": DROP}
    system = LockstepSystem(load_scenario("Locobot").model_copy(update=bare), 1)
    try:
        ended = _driven(system)
        truth = system.lockstep.station.truth().base_in_map
    finally:
        system.close()
    assert ended.state is GoalState.FAILED
    assert ended.failure is not None
    assert ended.failure.kind is FailureKind.OVERRIDDEN
    assert ended.failure.evidence["reflex"] == "cliff"
    assert "the floor ends" in ended.failure.causes[0].message
    assert truth.position[0] < DROP.lower[0] - 0.2
    assert truth.position[2] == pytest.approx(0.0, abs=0.005)
    assert truth.orientation[:2] == pytest.approx((0.0, 0.0), abs=TILT)


def _driven(system: LockstepSystem) -> GoalStatus:
    system.lockstep.run_until(lambda: False, within=2.0)  # arms and base have told how they are
    found = _ended(system, LOCALISE.name, LocaliseGoal())
    assert found.state is GoalState.SUCCEEDED, found
    return _ended(system, DRIVE.name, BEYOND)


def _ended(system: LockstepSystem, action: str, goal: Message) -> GoalStatus:
    told = Latest(system.bus, status_topic(action), depth=4096)
    sent = SendGoal(goal_id=f"t/{action}/1", client="", goal=goal.model_dump(mode="json"))
    goal_service(action).query(system.bus, sent)

    def ended() -> bool:
        status = told.refresh()
        return status is not None and status.state.terminal

    assert system.lockstep.run_until(ended, within=30.0), told.value
    assert told.value is not None
    return told.value
