"""A Pioneer P3-DX: two driven wheels, a caster, sixteen sonars around it, and markers for motion capture.

Dimensions and sonars are those of ARIA's parameters (``p3dx-sh.p``). No package ships a URDF.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, RobotModel, Wheels
from tandem.sim.robots import primitives
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.robot import Robot
from tandem.sim.robots.sensors import bumpers, motion_capture, range_sensor
from tandem.skills.ports.robot_description import DifferentialDrive, RobotDescription

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

NAME: Final = "p3dx"
FOOTPRINT_RADIUS: Final = 0.25
"""Metres: ARIA's RobotRadius."""
HEIGHT: Final = 0.24
"""Metres: the body's top is 0.236 m up."""
DRIVE: Final = DifferentialDrive(
    forward=0.75, backward=0.40, acceleration=0.6, turn=1.75, turn_acceleration=1.75, dead_man=0.3
)
"""Ours, below the maker's maxima (1.2 m/s, 5.2 rad/s). Its controller brakes with 0.3 m/s2 unless told
otherwise, which takes 0.94 m from this speed; with 0.6 m/s2 it is half of that."""
WHEELS: Final = Wheels(("left_wheel_joint",), ("right_wheel_joint",), radius=0.0975, track=0.330, effort=8.0)
"""The wheels' diameter is 195 mm. ARIA turns with a track of 357 mm, for tyres that give; these are stiff."""
CASTER_LINK: Final = "caster_link"
FLOOR_FRICTIONS: Final = {"left_wheel_link": 1.0, "right_wheel_link": 1.0, CASTER_LINK: 0.0}
"""Chosen: tyres grip, and the caster rolls to all sides."""

SONARS: Final = (
    (69, 136, 90),
    (114, 119, 50),
    (148, 78, 30),
    (166, 27, 10),
    (166, -27, -10),
    (148, -78, -30),
    (114, -119, -50),
    (69, -136, -90),
    (-157, -136, -90),
    (-203, -119, -130),
    (-237, -78, -150),
    (-255, -27, -170),
    (-255, 27, 170),
    (-237, 78, 150),
    (-203, 119, 130),
    (-157, 136, 90),
)
"""x and y in mm, and heading in degrees, in ARIA's order."""
SONAR_HEIGHT: Final = 0.19
"""Metres above the floor: in the upper half of the body, which goes from 0.060 to 0.236 m."""


def compose() -> RobotModel:
    """Put the robot together."""
    from tandem.sim.urdf import UrdfDocument  # noqa: PLC0415 - loads numpy; the room it takes is known without

    document = UrdfDocument(_urdf())
    physics_urdf, frames = finish(document, (CASTER_LINK,))
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(),
        wheels=WHEELS,
        floor_frictions=FLOOR_FRICTIONS,
        bumper_links=(ROOT, *(link for link in FLOOR_FRICTIONS if link != CASTER_LINK)),
        touching_links=(),
    )


def _urdf() -> str:
    deck = "".join(
        f'<collision><origin xyz="{x} 0 0.148"/>'
        '<geometry><cylinder radius="0.14" length="0.176"/></geometry></collision>'
        for x in (0.026, -0.108)
    )
    wheels = "".join(
        primitives.wheel(side, x=0.0, y=y, radius=WHEELS.radius, width=0.045, mass=0.6)
        for side, y in (("left", WHEELS.track / 2), ("right", -WHEELS.track / 2))
    )
    sonars = "".join(
        primitives.frame(sonar_frame(index), x / 1000, y / 1000, SONAR_HEIGHT, math.radians(heading))
        for index, (x, y, heading) in enumerate(SONARS)
    )
    return f"""<robot name="{NAME}">
      <link name="{ROOT}">
        <inertial><origin xyz="-0.05 0 0.11"/><mass value="7.6"/>
          <inertia ixx="0.07" ixy="0" ixz="0" iyy="0.11" iyz="0" izz="0.14"/></inertial>
        {deck}
        <collision><origin xyz="-0.041 0 0.148"/>
          <geometry><box size="0.134 0.28 0.176"/></geometry></collision>
      </link>
      <link name="{CASTER_LINK}">
        <inertial><origin xyz="-0.2 0 0.03"/><mass value="0.2"/>
          <inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.0001"/></inertial>
        <collision><origin xyz="-0.2 0 0.03"/><geometry><sphere radius="0.03"/></geometry></collision>
      </link>
      <joint name="caster_joint" type="fixed"><parent link="{ROOT}"/><child link="{CASTER_LINK}"/></joint>
      {wheels}{sonars}
    </robot>"""


def sonar_frame(index: int) -> str:
    """Return the frame of a sonar, numbered as ARIA does: clockwise from the left one."""
    return f"sonar_{index}_frame"


def _describe(document: UrdfDocument) -> RobotDescription:
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=HEIGHT,
        groups=(),
        end_effectors=(),
        range_sensors=tuple(
            range_sensor(f"sonar_{index}", sonar_frame(index)) for index in range(len(SONARS))
        ),
        pose_sensors=(motion_capture(),),
        bumpers=bumpers(),
        drive=DRIVE,
        postures=(),
        period=0.01,
    )


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, HEIGHT, compose)
