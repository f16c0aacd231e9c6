"""What kinematics takes out of the robot's description and the planning scene; for every domain alike."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import numpy as np

from tandem.skills.kinematics.bodies import Carried
from tandem.skills.kinematics.extent import Extent
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.model import RobotKinematics
from tandem.skills.ports.actions.base import ARM_MARGIN
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.shapes import solid
from tandem.skills.ports.urdf_check import UrdfError, check_fingers, parsed
from tandem.skills.ports.world import PlanningScene

HOME: Final = "home"
"""The postures of this name are free of collisions: what touches there is taken to do so without harm."""
DRIVING: Final = ("home", "carry")
"""Postures in which an arm drives along."""
DEEP: Final = 0.01
"""Metres by which links may be in each other at home, by their convex hulls. No shipped robot has any."""


def home_positions(description: RobotDescription) -> Mapping[str, float]:
    """Return the joints' positions at home, of the groups that have such a posture."""
    return {
        joint: value
        for posture in description.postures
        if posture.name == HOME
        for joint, value in zip(description.group(posture.group).joints, posture.positions, strict=True)
    }


def load_hulls(description: RobotDescription, seed: int = 0) -> RobotHulls:
    """Return the robot's bodies; takes some 0.2 s. The arms of one process can share them.

    Raises:
        UrdfError: a joint can't be right, a hand is no parallel gripper, or links are in each other at home.
    """
    check_fingers(
        parsed(description.urdf), {hand.side: hand.gripper.joints for hand in description.end_effectors}
    )
    robot = RobotKinematics(description.urdf, {group.name: group.joints for group in description.groups})
    home = home_positions(description)
    hulls = RobotHulls(robot, [home] if home else [], np.random.default_rng(seed))
    for depth, one, other in hulls.overlapping(home) if home else ():
        if depth > DEEP:
            raise UrdfError(
                f"posture {HOME!r}: {one!r} and {other!r} are {depth:.3f} m in each other; expected a posture"
                " in which no links touch that are more than two joints apart"
            )
    return hulls


def check_reach(description: RobotDescription, hulls: RobotHulls) -> None:
    """Refuse an arm that reaches out too far in a posture in which it drives along: the base would hold.

    Raises:
        UrdfError: naming the posture, how far it reaches, and how far it may.
    """
    if description.drive is None:
        return
    home = home_positions(description)
    most = description.footprint_radius + ARM_MARGIN
    arms = {hand.group for hand in description.end_effectors}
    for posture in description.postures:
        if posture.group in arms and posture.name in DRIVING:
            joints = description.group(posture.group).joints
            stands = {**home, **dict(zip(joints, posture.positions, strict=True))}
            reach = Extent(hulls, joints).metres(stands)
            if reach > most:
                raise UrdfError(
                    f"posture {posture.name!r} of {posture.group!r} reaches {reach:.3f} m from the base's"
                    f" axis; the base drives with at most {most:.2f} m (footprint_radius and {ARM_MARGIN:g}"
                    " m). Expected a posture further in, or a larger footprint_radius"
                )


def carried(scene: PlanningScene, description: RobotDescription) -> tuple[Carried, ...]:
    """Return what the hands hold, each in its tool frame."""
    found = []
    for each in scene.objects:
        if each.attached_to is not None:
            hand = description.end_effector(each.attached_to)
            found.append(Carried(each.name, solid(each.box), hand.frame, each.box.pose, hand.touch_links))
    return tuple(found)


def by_name(names: tuple[str, ...], positions: tuple[float, ...]) -> Mapping[str, float]:
    """Return joint positions by name."""
    return dict(zip(names, positions, strict=True))
