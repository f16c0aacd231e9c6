"""A room with a robot in it, for the tests of the sim's senses and controls."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from tandem.sim.body import RobotBody
from tandem.sim.model import RobotModel
from tandem.sim.physics import Physics
from tandem.sim.robots.registry import robot_model
from tandem.sim.scenario import Scenario, load_scenario
from tandem.sim.world import World, spawn
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.site import Site
from tandem.skills.site import load

POSTURES = (("arm_left", "home"), ("arm_right", "home"), ("torso", "home"), ("head", "table"))


@dataclass(frozen=True)
class Room:
    site: Site
    scenario: Scenario
    physics: Physics
    world: World
    model: RobotModel
    robot: RobotBody


class MakeRoom(Protocol):
    """Makes a room of a packaged scenario, with the robot at its start or at another one."""

    def __call__(self, name: str = "Demo", start: FloorPose | None = None) -> Room: ...


def make_room(name: str = "Demo", start: FloorPose | None = None) -> Room:
    site, scenario, physics, model = load("lab"), load_scenario(name), Physics(), robot_model("tiago_dual")
    world = spawn(physics, site, scenario)
    description = model.description
    positions: dict[str, float] = {}
    for group, posture in POSTURES:
        joints = description.group(group).joints
        positions.update(zip(joints, description.posture(group, posture).positions, strict=True))
    start = start or scenario.first.start
    robot = RobotBody(physics, model, x=start.x, y=start.y, yaw=start.yaw, positions=positions)
    world.settle(most=100)
    return Room(site, scenario, physics, world, model, robot)


def at(seconds: float) -> RobotTime:
    """Return a moment on the robot's clock."""
    return RobotTime(boot="test", seconds=seconds)
