"""Parts of robots that no package ships, as URDF: wheels and frames."""

from __future__ import annotations

import math

from tandem.sim.model import ROOT


def wheel(name: str, *, x: float, y: float, radius: float, width: float, mass: float) -> str:
    """Return the link ``NAME_wheel_link`` on its continuous joint, a cylinder that stands on the floor.

    Its axle is y, so that a positive speed rolls ahead. All in metres, kg.
    """
    cylinder = f'<cylinder radius="{radius}" length="{width}"/>'
    return _wheel(
        name, cylinder, (mass * (3 * radius**2 + width**2) / 12, mass * radius**2 / 2), x, y, radius, mass
    )


def ball_wheel(name: str, *, x: float, y: float, radius: float, mass: float) -> str:
    """Return a ``wheel`` that touches the floor in one point, for wheels that skid.

    The rims of a cylinder catch as it slips sideways: turned once around in place, a robot on four of them
    wanders by 0.2 m.
    """
    inertia = 0.4 * mass * radius**2
    return _wheel(name, f'<sphere radius="{radius}"/>', (inertia, inertia), x, y, radius, mass)


def _wheel(  # noqa: PLR0917
    name: str, shape: str, inertia: tuple[float, float], x: float, y: float, radius: float, mass: float
) -> str:
    across, along = inertia
    return f"""
      <link name="{name}_wheel_link">
        <inertial><mass value="{mass}"/>
          <inertia ixx="{across}" ixy="0" ixz="0" iyy="{along}" iyz="0" izz="{across}"/></inertial>
        <collision><origin rpy="{math.pi / 2} 0 0" xyz="0 0 0"/>
          <geometry>{shape}</geometry></collision>
      </link>
      <joint name="{name}_wheel_joint" type="continuous"><origin xyz="{x} {y} {radius}"/>
        <parent link="{ROOT}"/><child link="{name}_wheel_link"/><axis xyz="0 1 0"/></joint>"""


def frame(name: str, x: float, y: float, z: float, yaw: float) -> str:
    """Return a frame on the base: metres, and its heading in radians."""
    return f"""
      <link name="{name}"/>
      <joint name="{name}_joint" type="fixed"><origin xyz="{x} {y} {z}" rpy="0 0 {yaw}"/>
        <parent link="{ROOT}"/><child link="{name}"/></joint>"""
