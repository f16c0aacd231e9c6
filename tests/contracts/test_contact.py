"""What is free for the planner is free in the simulation: its links meet no sooner than the planner's do."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pinocchio as pin
import pybullet

from tandem.sim.body import RobotBody
from tandem.sim.physics import Physics
from tandem.sim.robots.registry import robot_model
from tandem.skills.kinematics.described import home_positions, load_hulls
from tandem.skills.kinematics.hulls import RobotHulls

MEETINGS = 12
FINE = 1e-4
"""rad between a state with contact and one without."""


def in_simulation(body: RobotBody, joints: Mapping[str, float], hulls: RobotHulls) -> bool:
    """Say whether links touch in the physics that the planner keeps apart."""
    for name, value in joints.items():
        pybullet.resetJointState(
            body.body, body.joint_index[name], value, physicsClientId=body.physics.client
        )
    number = {link: k for k, link in enumerate(hulls.links)}
    return any(
        depth > 0.0 and not hulls.harmless[tuple(sorted((number[one], number[other])))]
        for depth, one, other in body.overlaps()
        if one in number and other in number
    )


def in_plans(joints: Mapping[str, float], hulls: RobotHulls) -> bool:
    """Say whether links touch for the planner."""
    model, geometry = hulls.robot.model, hulls.geometry
    data, found = model.createData(), geometry.createData()
    pairs = pin.GeometryModel(geometry)
    pairs.setCollisionPairs(np.triu(~hulls.harmless, 1))
    found = pairs.createData()
    at = hulls.robot.configuration(joints)
    return bool(pin.computeCollisions(model, data, pairs, found, at, True))


def test_links_that_begin_to_touch_in_the_simulation_touch_for_the_planner() -> None:
    model = robot_model("panda")
    hulls, home = load_hulls(model.description), dict(home_positions(model.description))
    body = RobotBody(Physics(), model, x=0.0, y=0.0, yaw=0.0, positions=home)
    group = model.description.groups[0]
    limits, rng = hulls.robot.limits(group.joints), np.random.default_rng(1)
    met = 0
    while met < MEETINGS:
        free, touching = np.array(list(home.values())), rng.uniform(limits.lower, limits.upper)
        if not in_simulation(body, dict(zip(group.joints, touching, strict=True)), hulls):
            continue
        while float(np.max(np.abs(touching - free))) > FINE:
            middle = 0.5 * (free + touching)
            if in_simulation(body, dict(zip(group.joints, middle, strict=True)), hulls):
                touching = middle
            else:
                free = middle
        met += 1
        assert in_plans(dict(zip(group.joints, touching, strict=True)), hulls)
