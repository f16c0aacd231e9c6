"""TIAGo's two arms as numbers only: joint states are told, what is said about them is heard."""

from __future__ import annotations

from functools import cache

from tandem.sim.robots.registry import robot_model
from tandem.skills.kinematics.described import home_positions, load_hulls
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.robot_description import RobotDescription

IN_FRONT = (0.34, 1.49, 1.70, 2.28, -0.72, -0.78, -1.97)
"""The posture "carry": both arms in it are 2.6 cm apart in front of the torso."""
ASIDE = (-0.16, 1.49, 1.70, 2.28, -0.72, -0.78, -1.97)
"""The same with the shoulder turned out by half a radian."""


@cache
def robot() -> tuple[RobotDescription, RobotHulls]:
    """Return TIAGo++ and its bodies."""
    description = robot_model("tiago_dual").description
    return description, load_hulls(description)


def positions(
    left: tuple[float, ...] | None = None, right: tuple[float, ...] | None = None
) -> dict[str, float]:
    """Return all joints' positions, the arms at home unless said otherwise, the grippers closed."""
    description, _ = robot()
    told = dict(home_positions(description))
    for hand in description.end_effectors:
        told |= dict.fromkeys(hand.gripper.joints, 0.0)
    for side, arm in (("left", left), ("right", right)):
        if arm is not None:
            told |= dict(zip(description.group(f"arm_{side}").joints, arm, strict=True))
    return told


def joint_states(seconds: float, at: dict[str, float], speeds: dict[str, float] | None = None) -> JointStates:
    """Return a message of the joints."""
    names = tuple(at)
    return JointStates(
        stamp=RobotTime(boot="test", seconds=seconds),
        names=names,
        positions=tuple(at.values()),
        velocities=tuple((speeds or {}).get(name, 0.0) for name in names),
        efforts=tuple(0.0 for _ in names),
    )
