"""The base's process, asked over the bus as the trees ask it."""

import numpy as np

from tandem.skills.base.process import build
from tandem.skills.geometry.poses import floor_distance
from tandem.skills.ports.action import GoalState, SendGoal, goal_service, status_topic
from tandem.skills.ports.actions.arm import ArmState, ArmStatus, arm_status
from tandem.skills.ports.actions.base import DRIVE, LOCALISE, DriveGoal
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import FloorPose
from tandem.skills.site import load
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.planar_robot import PlanarClocks, PlanarRobot, describe


def test_localise_then_drive_over_the_bus() -> None:
    site, bus, clocks, description = load("lab"), MemoryBus(), PlanarClocks(), describe()
    robot = PlanarRobot(bus, clocks, description, site, np.random.default_rng(1), site.home)
    nodes = build(bus, clocks, description, site, charge=True)

    def until_done(action: str, goal: dict[str, object]) -> GoalState:
        status = Latest(bus, status_topic(action), depth=4)
        sent = SendGoal.model_validate({"goal_id": f"t/{action}/1", "client": "", "goal": goal})
        goal_service(action).query(bus, sent)
        for _ in range(2000):
            robot.step()
            if robot.tick % 10 == 0:
                for hand in description.end_effectors:
                    idle = ArmStatus(
                        stamp=clocks.robot(), group=hand.group, state=ArmState.ARM_IDLE, extent=0.3
                    )
                    arm_status(hand.group).publish(bus, idle)
            for node in nodes:
                while node.step():
                    pass
            told = status.refresh()
            if told is not None and told.state.terminal:
                return told.state
        raise AssertionError(f"{action} did not end")

    goal = FloorPose(x=-0.55, y=0.5, yaw=0.0)
    assert until_done(LOCALISE.name, {}) is GoalState.SUCCEEDED
    assert until_done(DRIVE.name, DriveGoal(poses=(goal,)).model_dump(mode="json")) is GoalState.SUCCEEDED
    assert floor_distance(robot.truth, goal) < 0.03
    for node in nodes:
        node.close()
