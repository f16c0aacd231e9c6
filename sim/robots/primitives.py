"""Parts of robots that no package ships, as URDF: wheels, frames, links of boxes, joints."""

from __future__ import annotations

import math

from tandem.sim.model import ROOT
from tandem.skills.ports.message import Vector3


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


def shape(geometry: str, at: Vector3) -> str:
    """Return what the physics collides with: a geometry with its middle at a point of its link (m)."""
    x, y, z = at
    return f'<collision><origin xyz="{x} {y} {z}"/><geometry>{geometry}</geometry></collision>'


def box(at: Vector3, size: Vector3) -> str:
    """Return a box along the axes of its link: middle and edges in metres."""
    return shape(f'<box size="{size[0]} {size[1]} {size[2]}"/>', at)


def inertial(mass: float, at: Vector3, moments: Vector3) -> str:
    """Return mass (kg), its centre in the link (m), and the moments about the axes there (kg m2)."""
    x, y, z = at
    xx, yy, zz = moments
    return f"""<inertial><origin xyz="{x} {y} {z}"/><mass value="{mass}"/>
          <inertia ixx="{xx}" ixy="0" ixz="0" iyy="{yy}" iyz="0" izz="{zz}"/></inertial>"""


def link(name: str, mass: float, centre: Vector3, shapes: str) -> str:
    """Return a link with moments of a ball that is as wide as its mass is far out (kg, m)."""
    moment = mass * (0.04**2 + sum(each**2 for each in centre) / 3)
    return f'<link name="{name}">{inertial(mass, centre, (moment, moment, moment))}{shapes}</link>'


def fixed(name: str, parent: str, child: str, at: Vector3, rpy: str = "0 0 0") -> str:
    """Return a fixed joint at a point of the parent (m)."""
    x, y, z = at
    return f"""<joint name="{name}" type="fixed"><origin xyz="{x} {y} {z}" rpy="{rpy}"/>
        <parent link="{parent}"/><child link="{child}"/></joint>"""


def turning(  # noqa: PLR0917
    name: str,
    parent: str,
    child: str,
    at: Vector3,
    axis: str,
    limits: tuple[float, float],
    effort: float,
) -> str:
    """Return a joint that turns about an axis at a point of the parent (m, rad, Nm), half a turn a second."""
    x, y, z = at
    low, high = limits
    return f"""<joint name="{name}" type="revolute"><origin xyz="{x} {y} {z}"/>
        <parent link="{parent}"/><child link="{child}"/><axis xyz="{axis}"/>
        <limit lower="{low}" upper="{high}" effort="{effort}" velocity="{math.pi}"/></joint>"""
