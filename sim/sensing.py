"""The sensors of a robot that are neither cameras nor lasers, made from its description."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tandem.sim.cliff_sensor import CliffFinder
from tandem.sim.pose_sensor import PoseFinder, floor_pose
from tandem.sim.range_sensor import RangeFinder
from tandem.sim.robot_sensor import RobotFinder
from tandem.sim.sensor_nodes import PoseNode, RangesNode, RobotsNode, cliffs_node, ranges_node

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy as np

    from tandem.sim.body import RobotBody
    from tandem.sim.scenario import Noise
    from tandem.sim.world import World
    from tandem.skills.ports.bus import Bus
    from tandem.skills.ports.pose import FloorPose


def others_in(world: World, robot: RobotBody) -> Mapping[str, FloorPose]:
    """Return where the bases of all robots but one truly are in map, by name."""
    return {name: floor_pose(other) for name, other in world.robots.items() if other is not robot}


def sensor_nodes(
    bus: Bus,
    robot: RobotBody,
    *,
    noise: Noise,
    ranging: np.random.Generator,
    posing: np.random.Generator,
    falling: np.random.Generator,
    others: Callable[[], Mapping[str, FloorPose]],
) -> tuple[RangesNode | PoseNode | RobotsNode, ...]:
    """Return the nodes of a robot's range, cliff, pose and robot sensors.

    Args:
        bus: where they publish.
        robot: carries them.
        noise: ``range_sigma`` of it; a pose sensor's errors stand in its description.
        ranging: source of the range sensors' errors.
        posing: source of the pose sensors' errors.
        falling: source of the cliff sensors' flicker.
        others: returns the other robots' bases in map, by name.
    """
    description, sigma = robot.model.description, noise.range_sigma
    ranges = [RangeFinder(robot, each, sigma=sigma, rng=ranging) for each in description.range_sensors]
    cliffs = [CliffFinder(robot, each, rng=falling) for each in description.cliff_sensors]
    return (
        *([ranges_node(bus, ranges)] if ranges else []),
        *([cliffs_node(bus, cliffs)] if cliffs else []),
        *(PoseNode(bus, PoseFinder(robot, each, rng=posing)) for each in description.pose_sensors),
        *(RobotsNode(bus, RobotFinder(robot, each, others=others)) for each in description.robot_sensors),
    )
