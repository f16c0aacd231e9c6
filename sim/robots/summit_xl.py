"""Robotnik's SUMMIT-XL: four driven wheels that skid in a turn, three range sensors, a sensor for robots.

Dimensions are those of Robotnik's ``summit_xl_common`` and data sheet. No package ships a URDF.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, RobotModel, Wheels
from tandem.sim.robots import primitives
from tandem.sim.robots.finishing import finish
from tandem.sim.robots.robot import Robot
from tandem.sim.robots.sensors import SONAR_CONE, SONAR_PERIOD, bumpers, motion_capture, range_sensor
from tandem.skills.ports.reflex_setting import ReflexSetting
from tandem.skills.ports.robot_description import RobotDescription, SkidSteerDrive
from tandem.skills.ports.sensors import RobotSensor

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

NAME: Final = "summit_xl"
FOOTPRINT_RADIUS: Final = 0.46
"""Metres: the wheels' outer corners."""
HEIGHT: Final = 0.40
"""Metres: the chassis' top."""
DRIVE: Final = SkidSteerDrive(
    forward=1.5, backward=0.5, acceleration=1.0, turn=1.5, turn_acceleration=2.0, dead_man=0.3
)
"""Ours; the maker's controller allows 3 m/s, 6 m/s2 and 6 rad/s, by default 1.5, 3 and 3."""
WHEEL_XY: Final = (0.229, 0.235)
"""Metres from the base's axis."""
WHEELS: Final = Wheels(
    ("front_left_wheel_joint", "back_left_wheel_joint"),
    ("front_right_wheel_joint", "back_right_wheel_joint"),
    radius=0.11,
    track=0.57,
    effort=40.0,
)
"""The wheels stand 0.470 m apart. The track is the effective one, measured in the physics (``SIDEWAYS``)."""
SIDEWAYS: Final = 0.1
"""Friction along the axles as a share of that along the way. With this track the robot turns by 0.94 to
1.09 of what it is told, in place and in arcs, slowly and fast; at 0.3 that spreads by half as much again."""
FLOOR_FRICTIONS: Final = {joint.replace("_joint", "_link"): 1.0 for joint in WHEELS.joints}
"""Along the way; see ``SIDEWAYS`` for along the axles."""

RANGE_HEADINGS: Final = {"left": 30.0, "middle": 0.0, "right": -30.0}
"""Degrees. As far apart as a cone is wide: 90 degrees ahead are seen without a gap, and the middle one looks
where the robot goes."""
RANGE_XYZ: Final = (0.365, 0.15, 0.20)
"""Metres, in the front's corners, clear of the chassis; the middle one between them."""
WAY: Final = 0.8
"""Metres that it goes on after turning from something: its sides, which see nothing, are past it then."""
ROBOTS_FRAME: Final = "robots_frame"
ROBOTS_FIELD: Final = math.radians(120.0)
ROBOTS_RANGE: Final = 5.0
"""Ours: a field in radians, half to each side of ahead, and metres."""


def compose() -> RobotModel:
    """Put the robot together."""
    from tandem.sim.urdf import UrdfDocument  # noqa: PLC0415 - loads numpy; the room it takes is known without

    document = UrdfDocument(_urdf())
    physics_urdf, frames = finish(document, ())
    return RobotModel(
        description=_describe(document),
        physics_urdf=physics_urdf,
        frames=frames,
        hands=(),
        wheels=WHEELS,
        floor_frictions=FLOOR_FRICTIONS,
        sideways_frictions=dict.fromkeys(FLOOR_FRICTIONS, SIDEWAYS),
        bumper_links=(ROOT, *FLOOR_FRICTIONS),
        touching_links=(),
    )


def _urdf() -> str:
    x, y = WHEEL_XY
    wheels = "".join(
        primitives.ball_wheel(f"{end}_{side}", x=at, y=out, radius=WHEELS.radius, mass=6.5)
        for end, at in (("front", x), ("back", -x))
        for side, out in (("left", y), ("right", -y))
    )
    ahead, out, up = RANGE_XYZ
    eyes = "".join(
        primitives.frame(
            f"range_{name}_frame",
            ahead,
            out * math.sin(math.radians(degrees)) / math.sin(SONAR_CONE),
            up,
            math.radians(degrees),
        )
        for name, degrees in RANGE_HEADINGS.items()
    )
    return f"""<robot name="{NAME}">
      <link name="{ROOT}">
        <inertial><origin xyz="0 0 0.20"/><mass value="39"/>
          <inertia ixx="0.55" ixy="0" ixz="0" iyy="1.9" iyz="0" izz="2.1"/></inertial>
        <collision><origin xyz="0 0 0.22"/><geometry><box size="0.72 0.32 0.20"/></geometry></collision>
        <collision><origin xyz="0 0 0.36"/><geometry><box size="0.56 0.40 0.08"/></geometry></collision>
      </link>
      {wheels}{eyes}{primitives.frame(ROBOTS_FRAME, 0.28, 0.0, 0.38, 0.0)}
    </robot>"""


def _describe(document: UrdfDocument) -> RobotDescription:
    return RobotDescription(
        name=NAME,
        urdf=document.text(),
        base_frame=ROOT,
        footprint_radius=FOOTPRINT_RADIUS,
        height=HEIGHT,
        groups=(),
        end_effectors=(),
        range_sensors=tuple(range_sensor(f"range_{name}", f"range_{name}_frame") for name in RANGE_HEADINGS),
        pose_sensors=(motion_capture(),),
        robot_sensors=(
            RobotSensor(
                name="robots",
                frame=ROBOTS_FRAME,
                field=ROBOTS_FIELD,
                range_max=ROBOTS_RANGE,
                period=SONAR_PERIOD,
            ),
        ),
        bumpers=bumpers(),
        drive=DRIVE,
        postures=(),
        reflexes=(ReflexSetting(reflex="avoid_collision", parameters={"way": WAY}),),
        period=0.01,
    )


ROBOT: Final = Robot(NAME, FOOTPRINT_RADIUS, HEIGHT, compose)
