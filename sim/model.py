"""What the sim knows of a robot: the hardware's description, and what only a stand-in needs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from tandem.skills.ports.robot_description import RobotDescription

if TYPE_CHECKING:
    from tandem.sim.urdf import Array

ROOT: Final = "base_footprint"
"""The robot's root frame: on the floor between the wheels."""


@dataclass(frozen=True)
class Hand:
    """A parallel gripper on its mount: ``inner`` and ``outer`` finger joints open with positive values."""

    side: str
    mount_link: str
    wrench_joint: str
    """The joint in front of the mount, whose reaction the wrist's sensor measures."""
    inner: str
    outer: str
    finger_links: tuple[str, str]


@dataclass(frozen=True)
class Wheels:
    """The driven wheels of a differential or a skid-steer drive, by their joints: metres, N m."""

    left: tuple[str, ...]
    right: tuple[str, ...]
    radius: float
    track: float
    """Between the wheels' contacts with the floor. With wheels that slip in a turn, the effective one, which
    is larger: the right side's way less the left side's, over the turn."""
    effort: float

    @property
    def joints(self) -> tuple[str, ...]:
        """All of them, the left ones first: the order of angles and speeds."""
        return (*self.left, *self.right)


@dataclass(frozen=True)
class Sector:
    """A bumper and the bearings that it feels contacts at: counter-clockwise in the base, in radians."""

    name: str
    begins: float
    ends: float

    def feels(self, bearing: float) -> bool:
        """Return whether a contact at a bearing (rad) presses it."""
        return (bearing - self.begins) % (2.0 * math.pi) <= self.ends - self.begins


QUARTERS: Final = tuple(
    Sector(name, (2 * number - 1) * math.pi / 4, (2 * number + 1) * math.pi / 4)
    for number, name in enumerate(("front", "left", "back", "right"))
)
"""Bumpers all around: each covers a quarter of the base, centred on its direction."""


@dataclass(frozen=True)
class RobotModel:
    """A robot to load into the physics.

    ``physics_urdf`` is the description's URDF without the massless frames, which only cost time; ``frames``
    says where each frame is: its link, and its 4x4 pose in it. ``touching_links`` are pairs that no motion
    brings together, whose contacts are not worth computing. Links on the floor have a friction each.
    """

    description: RobotDescription
    physics_urdf: str
    frames: Mapping[str, tuple[str, Array]]
    hands: tuple[Hand, ...]
    wheels: Wheels | None
    """None: the base is fixed to the floor."""
    floor_frictions: Mapping[str, float]
    bumper_links: tuple[str, ...]
    touching_links: tuple[tuple[str, str], ...]
    root: str = ROOT
    sideways_frictions: Mapping[str, float] = field(default_factory=dict)
    """Of wheels that skid in a turn, by link: the friction along the axle (the link's y) as a share of
    that along the way."""
    bumpers: tuple[Sector, ...] = QUARTERS
    anchored_wheels: tuple[str, ...] = ()
    """Links of wheels whose static friction keeps its place. A light base creeps on the floor else, by
    a degree in ten seconds, as its arm moves."""

    def hand(self, side: str) -> Hand:
        """Return the hand of a side.

        Raises:
            KeyError: naming the sides there are.
        """
        for hand in self.hands:
            if hand.side == side:
                return hand
        raise KeyError(f"no hand {side!r}; there are {', '.join(h.side for h in self.hands)}")
