"""A description's groups: limits from a URDF, and what it leaves open from the robot's file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from tandem.skills.ports.robot_description import JointGroup, JointLimit

if TYPE_CHECKING:
    from tandem.sim.urdf import UrdfDocument

PATH_TOLERANCE: Final = 0.01
"""Radians or metres: the simulated servos stray by 0.4 mrad at the most, and that with an item in the hand
(one fetch each of TIAGo++ and the LoCoBot). 7 mm at a hand 0.7 m away."""


@dataclass(frozen=True)
class Smoothness:
    """What no URDF tells: acceleration (rad/s2 or m/s2) and jerk (rad/s3 or m/s3) of a group's joints."""

    acceleration: float
    jerk: float


def group(document: UrdfDocument, name: str, joints: Sequence[str], smooth: Smoothness) -> JointGroup:
    """Return a group of joints with the URDF's positions, velocities and efforts.

    Raises:
        KeyError: naming a joint that the URDF lacks.
    """
    limits = tuple(_limit(document, joint, smooth) for joint in joints)
    return JointGroup(name=name, limits=limits, path_tolerance=PATH_TOLERANCE)


def groups(
    document: UrdfDocument, named: Mapping[str, tuple[Sequence[str], Smoothness]]
) -> tuple[JointGroup, ...]:
    """Return groups by their names, in order."""
    return tuple(group(document, name, joints, smooth) for name, (joints, smooth) in named.items())


def _limit(document: UrdfDocument, joint: str, smooth: Smoothness) -> JointLimit:
    limit = document.joint(joint).find("limit")
    if limit is None:
        raise KeyError(f"joint {joint!r} of this URDF has no <limit>")
    return JointLimit(
        joint=joint,
        lower=float(limit.attrib["lower"]),
        upper=float(limit.attrib["upper"]),
        velocity=float(limit.attrib["velocity"]),
        acceleration=smooth.acceleration,
        jerk=smooth.jerk,
        effort=float(limit.attrib["effort"]),
    )
