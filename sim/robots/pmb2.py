"""PAL's PMB2 base, on which TIAGo stands: wheels, casters, the laser, and the drive's limits."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from tandem.sim.model import ROOT, Wheels
from tandem.skills.ports.robot_description import DifferentialDrive

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

LASER_FRAME: Final = "base_laser_link"
DRIVE: Final = DifferentialDrive(
    forward=1.0, backward=0.2, acceleration=0.5, turn=1.05, turn_acceleration=1.05, dead_man=0.3
)
"""PAL's configuration, and our dead-man."""
WHEELS: Final = Wheels(("wheel_left_joint",), ("wheel_right_joint",), radius=0.0985, track=0.4044, effort=6.0)
"""PAL's radius, track and limit of effort."""
FLOOR_FRICTIONS: Final = {"wheel_left_link": 1.0, "wheel_right_link": 1.0, "casters_link": 0.0}
"""Chosen: tyres grip, and the casters roll to all sides."""
CASTERS_LINK: Final = "casters_link"
BUMPER_LINKS: Final = (ROOT, "torso_lift_link")

_LASER_IN_BASE: Final = (0.202, 0.0, 0.0945)
"""Metres in ROOT: at the front, 94.5 mm above the floor. It sees walls and the legs of tables, not their
tops."""
_CASTERS_XY: Final = ((0.1535, 0.102), (0.1535, -0.102), (-0.1895, 0.102), (-0.1895, -0.102))
"""Metres: where PAL's URDF has the wheels of its casters while they point backwards."""
_CASTER_RADIUS: Final = 0.025
"""Metres: as high as that URDF has their axles over the floor."""


def fit(document: UrdfDocument) -> None:
    """Rigid suspension; four frictionless balls for the casters; a laser; no virtual sensors."""
    document.cut("rgbd_laser_link")
    sprung = {str(joint.get("name")) for joint in document.joints()}
    for side in ("left", "right"):
        document.cut(f"base_antenna_{side}_link")
        if f"suspension_{side}_joint" in sprung:
            document.fix(f"suspension_{side}_joint")
        for end in ("front", "back"):
            document.cut(f"caster_{end}_{side}_1_link")
    balls = "".join(
        f'<collision><origin xyz="{x} {y} {_CASTER_RADIUS}"/>'
        f'<geometry><sphere radius="{_CASTER_RADIUS}"/></geometry></collision>'
        for x, y in _CASTERS_XY
    )
    document.add(f"""
      <link name="casters_link">
        <inertial><origin xyz="-0.016 0 {_CASTER_RADIUS}"/><mass value="0.56"/>
          <inertia ixx="0.006" ixy="0" ixz="0" iyy="0.016" iyz="0" izz="0.022"/></inertial>
        {balls}
      </link>
      <joint name="casters_joint" type="fixed"><origin xyz="0 0 0"/>
        <parent link="{ROOT}"/><child link="casters_link"/></joint>
      <link name="base_laser_link"/>
      <joint name="base_laser_joint" type="fixed">
        <origin xyz="{_LASER_IN_BASE[0]} {_LASER_IN_BASE[1]} {_LASER_IN_BASE[2]}"/>
        <parent link="{ROOT}"/><child link="base_laser_link"/></joint>""")
