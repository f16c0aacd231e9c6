"""What the reflex sees in one message of the joints: Algorithm 2's verdict, and the true clearance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.kinematics.clearance import ArmsClearance
from tandem.skills.kinematics.described import carried
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.robot_description import ArmsCrossing, RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import PlanningScene, SceneObject
from tandem.skills.reflex.crossing import arms_crossing

REACTION: Final = 0.03
"""Seconds from a message of the joints to the arms' braking: three periods."""
STILL: Final = 0.02
"""rad/s below which a joint stands."""
SAFE_WITHIN: Final = 0.10
"""Radians by which an arm may be off its safe posture and still be in it."""
FINGERS_MOVED: Final = 0.004
"""Metres by which fingers have moved before the bodies are put together anew."""


@dataclass(frozen=True)
class Seen:
    """Metres as in ``Crossing``, and which arms move."""

    risk: bool
    near: bool
    distance: float
    threshold: float
    clearance: float
    moving: bool


class ArmsWatch:
    """Looks at both arms.

    Args:
        hulls: the robot's bodies.
        description: the robot.
        how: its parameters.
        site: says which items both hands hold at once.
    """

    def __init__(
        self, hulls: RobotHulls, description: RobotDescription, how: ArmsCrossing, site: Site
    ) -> None:
        self._hulls, self._description, self._how, self._site = hulls, description, how, site
        hands = [description.end_effector(side) for side in PAIR]
        self._frames = [hand.frame for hand in hands]
        groups = [description.group(hand.group) for hand in hands]
        self._safe = [
            np.array(description.posture(group.name, how.safe_posture).positions) for group in groups
        ]
        self._fingers = [joint for hand in hands for joint in hand.gripper.joints]
        self._clearance: ArmsClearance | None = None
        self._built_at: Array = np.zeros(0)
        self._built_for: tuple[SceneObject, ...] = ()

    def look(self, joints: JointStates, scene: PlanningScene | None) -> Seen:
        """Return what there is to see; two looks at the same are the same."""
        positions = dict(zip(joints.names, joints.positions, strict=True))
        speeds = dict(zip(joints.names, joints.velocities, strict=True))
        clearance = self._bodies(positions, scene)
        q = np.array([positions[joint] for joint in clearance.joints])
        v = np.array([speeds[joint] for joint in clearance.joints])
        left, right = self._hulls.robot.poses(self._frames, positions)
        verdict = arms_crossing(left, right, self._how)
        moving = bool(np.max(np.abs(v)) > STILL)
        here = clearance.at(q)
        near, coming = here.distance, here.distance
        if moving:
            coming = clearance.ahead(here, q, v, REACTION).distance
        crossing = verdict.risk and not self._in_a_safe_place(q) and not self._together(scene)
        too_near = min(near, coming) < self._how.clearance
        return Seen(
            risk=crossing or too_near,
            near=too_near,
            distance=verdict.distance,
            threshold=verdict.threshold,
            clearance=near,
            moving=moving,
        )

    def _in_a_safe_place(self, q: Array) -> bool:
        """Say whether one arm is tucked away: the other may then be anywhere that it does not touch it."""
        halves = np.split(q, [len(self._safe[0])])
        return any(
            float(np.max(np.abs(half - safe))) < SAFE_WITHIN
            for half, safe in zip(halves, self._safe, strict=True)
        )

    def _together(self, scene: PlanningScene | None) -> tuple[str, ...]:
        """Return the names of what both hands hold at once."""
        if scene is None:
            return ()
        return tuple(
            each.name
            for each in scene.objects
            if each.attached_to is not None
            and each.item is not None
            and (known := self._site.item(each.item)) is not None
            and known.needs_two
        )

    def _bodies(self, positions: Mapping[str, float], scene: PlanningScene | None) -> ArmsClearance:
        """Return the bodies as they are; put together anew (2 ms) when hands, or what they hold, changed."""
        fingers = np.array([positions.get(joint, 0.0) for joint in self._fingers])
        held = () if scene is None else tuple(each for each in scene.objects if each.attached_to is not None)
        known = self._clearance
        if (
            known is not None
            and held == self._built_for
            and bool(np.all(np.abs(fingers - self._built_at) < FINGERS_MOVED))
        ):
            return known
        bodies = () if scene is None else carried(scene, self._description)
        made = ArmsClearance(self._hulls, self._description, positions, bodies, self._together(scene))
        self._clearance, self._built_at, self._built_for = made, fingers, held
        return made
