"""TIAGo++: two arms with a parallel gripper on each wrist.

The arms, torso, head and base are those of the URDF that ``example-robot-data`` installs; the hands are cut
off and grippers put in their place. What the URDF leaves open (accelerations, jerks, the grippers, the
laser's mount) is stated here and in the shared parts, and nowhere else.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, Hand, RobotModel
from tandem.sim.robots import parallel_gripper, pmb2, tiago_upper
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.joint_limits import groups
from tandem.sim.robots.robot import Robot
from tandem.sim.robots.sensors import bumpers, camera_sensor, laser_sensor
from tandem.skills.ports.robot_description import ArmsCrossing, EndEffector, Posture, RobotDescription

if TYPE_CHECKING:
    from collections.abc import Mapping

    from tandem.sim.urdf import UrdfDocument
    from tandem.skills.ports.message import HandName

NAME: Final = "tiago_dual"
SIDES: Final[tuple[HandName, HandName]] = ("left", "right")
FOOTPRINT_RADIUS: Final = 0.37
"""Metres. The arms at home reach 0.364 m from the base's axis; the base itself 0.30 m."""

ARMS_CROSSING: Final = ArmsCrossing(k=0.21, gamma=0.0, mu=0.0, clearance=0.03)
"""Found with ``python -m benchmarks.crossing_tuning``; see docs/decisions/005-arms-crossing.md."""

ARM_HOME: Final = (-1.1, 1.468, 2.714, 1.7095, -1.5707, 1.37, 0.0)
"""PAL's: the hands hang in front of the shoulders, fingers up, 0.364 m from the base's axis at the most.

Needs the torso at 0.05 m or more: below that the forearms come close to the base.
"""
ARM_CARRY: Final[Mapping[HandName, tuple[float, ...]]] = {
    "left": (0.34, 1.49, 1.70, 2.28, -0.72, -0.78, 1.17),
    "right": (0.34, 1.49, 1.70, 2.28, -0.72, -0.78, -1.97),
}
"""The hand level and upright in front of the torso, 0.72 m high with the torso at 0.15 m, fingers inwards.

The arms mirror each other, their tool frames do not: with equal wrists one of them would turn what it took
upside down, and back before it puts it down.

The arm reaches 0.395 m from the base's axis, an item in the hand up to 0.40 m. One arm at a time: both hands
would meet. The camera sees the hand neither looking ahead nor at a table.
"""
POSTURES: Final = (
    *(Posture(name="home", group=f"arm_{side}", positions=ARM_HOME) for side in SIDES),
    *(Posture(name="carry", group=f"arm_{side}", positions=ARM_CARRY[side]) for side in SIDES),
    *tiago_upper.POSTURES,
)


def compose() -> RobotModel:
    """Put the robot together from the installed description.

    Raises:
        FileNotFoundError: when example-robot-data is not installed.
    """
    document = tiago_upper.load("tiago_dual.urdf")
    for side in SIDES:
        tiago_upper.cut_hand(document, _mount(side))
        parallel_gripper.fit(document, f"gripper_{side}", mount=_mount(side))
    hands = tuple(_hand(side) for side in SIDES)
    physics_urdf, frames = finish(document, (*(hand.mount_link for hand in hands), pmb2.CASTERS_LINK))
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=hands,
        wheels=pmb2.WHEELS,
        floor_frictions=pmb2.FLOOR_FRICTIONS,
        bumper_links=pmb2.BUMPER_LINKS,
        touching_links=(
            *((f"arm_{side}_5_link", f"arm_{side}_7_link") for side in SIDES),
            *(hand.finger_links for hand in hands),
        ),
    )


def _describe(document: UrdfDocument) -> RobotDescription:
    arms = {
        f"arm_{side}": (tuple(f"arm_{side}_{i}_joint" for i in range(1, 8)), tiago_upper.TURNING)
        for side in SIDES
    }
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=tiago_upper.HEIGHT,
        groups=groups(document, {**arms, **tiago_upper.GROUPS}),
        end_effectors=tuple(_end_effector(side) for side in SIDES),
        cameras=(camera_sensor(tiago_upper.CAMERA_FRAME),),
        lasers=(laser_sensor(pmb2.LASER_FRAME),),
        bumpers=bumpers(),
        drive=pmb2.DRIVE,
        postures=POSTURES,
        period=tiago_upper.PERIOD,
        arms_crossing=ARMS_CROSSING,
    )


def _mount(side: HandName) -> str:
    return f"wrist_{side}_ft_tool_link"


def _hand(side: HandName) -> Hand:
    return parallel_gripper.hand(
        side, f"gripper_{side}", mount=_mount(side), wrench_joint=f"wrist_{side}_tool_joint"
    )


def _end_effector(side: HandName) -> EndEffector:
    hand, outwards = _hand(side), 1.0 if side == "left" else -1.0
    return EndEffector(
        side=side,
        group=f"arm_{side}",
        frame=parallel_gripper.tool_frame(f"gripper_{side}"),
        touch_links=(*hand.finger_links, hand.mount_link),
        gripper=parallel_gripper.gripper(hand),
        # With the torso at 0.3 m these leave most pitches and places open: a hand that points inwards has its
        # elbow out, and not in the torso.
        work_point=(0.58, outwards * 0.20),
        work_heading=outwards * math.radians(-45.0),
        safe_point=(0.38, outwards * 0.50, 1.00),
    )


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, tiago_upper.HEIGHT, compose)
