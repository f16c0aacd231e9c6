"""What a plan is made from, and what it is: the world as it was believed, and a motion through it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from tandem.skills.arm.finger_space import FingerSpace
from tandem.skills.arm.planning.motions import weigh
from tandem.skills.arm.scene import allowed, obstacles
from tandem.skills.arm.trajectory import MotionLimits, Trajectory
from tandem.skills.kinematics.batch import BatchChain
from tandem.skills.kinematics.bodies import Carried, Obstacle
from tandem.skills.kinematics.collision import CollisionChecker, Contact
from tandem.skills.kinematics.described import by_name, carried, home_positions
from tandem.skills.kinematics.extent import Extent
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.kinematics.ik import SeedTable, Solver
from tandem.skills.kinematics.model import Limits
from tandem.skills.kinematics.transforms import Array
from tandem.skills.kinematics.world_field import WorldField, installed
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import EndEffector, RobotDescription
from tandem.skills.ports.world import PlanningScene

LIMIT_MARGIN = 0.01
"""Radians (or metres) that plans stay inside the joints' limits: smoothed motions overshoot a little."""
SPREAD = 200
"""Configurations over which the reach is taken."""
BEYOND = 0.35
"""Metres by which things may be farther than that: what is carried, and what the spread missed."""


@dataclass(frozen=True)
class Moment:
    """What was believed when planning began."""

    joints: JointStates
    scene: PlanningScene
    base_in_map: FloorPose | None

    @property
    def positions(self) -> Mapping[str, float]:
        """Joint positions by name."""
        return by_name(self.joints.names, self.joints.positions)


@dataclass(frozen=True)
class Plan:
    """A checked motion.

    ``target_in_base``: where the tool frame shall end, for goals that are poses. ``turned``: the radians by
    which the goal's pose was turned for an arm of few joints.
    """

    trajectory: Trajectory
    candidate: int
    target_in_base: Pose | None
    turned: float = 0.0
    proves: str = ""


class Arm:
    """What is known of one group for good: its kinematics, limits, and its hand, if it has one.

    Args:
        hulls: the robot's bodies.
        description: the robot.
        group: the group's name.
        seed: draws the starts of inverse kinematics; takes some 50 ms.
        field: check states in a distance field if numba is installed; plans are the same.
    """

    def __init__(
        self,
        hulls: RobotHulls,
        description: RobotDescription,
        group: str,
        *,
        seed: int = 0,
        field: bool = False,
    ) -> None:
        self.hulls, self.description = hulls, description
        self.group = description.group(group)
        limits = self.group.limits
        self.limits = Limits(
            np.array([each.lower for each in limits]) + LIMIT_MARGIN,
            np.array([each.upper for each in limits]) - LIMIT_MARGIN,
            np.array([each.velocity for each in limits]),
        )
        self.motion_limits = MotionLimits(
            self.limits.velocity,
            np.array([each.acceleration for each in limits]),
            np.array([each.jerk for each in limits]),
        )
        self.hand: EndEffector | None = next(
            (each for each in description.end_effectors if each.group == group), None
        )

        self._fingers = None if self.hand is None else FingerSpace(hulls, self.hand)
        self._reach = self._farthest() + BEYOND
        alone = CollisionChecker(hulls, self.group.joints, home_positions(description))
        tip = self.group.joints[-1] if self.hand is None else self.hand.frame
        self.weights = weigh(alone.chain, self.limits, tip)
        """Of the joints, for the distances of planning, (n,)."""
        self.world: WorldField | None = (
            WorldField(hulls) if field and self.hand is not None and installed() else None
        )
        """Decides most of many states at once; without it coal decides all."""
        if self.world is not None:
            self.world.warm(self.group.joints)
        self.solver = None if self.hand is None else self._make_solver(alone, self.hand.frame, seed)
        """Inverse kinematics of the hand."""

    def _make_solver(self, alone: CollisionChecker, frame: str, seed: int) -> Solver:
        batch = BatchChain(alone.chain, frame)
        table = SeedTable(batch, self.limits, np.random.default_rng(seed), alone.free)
        return Solver(batch, self.limits, table)

    def _farthest(self) -> float:
        """Return the group's reach in plan (m), over configurations spread evenly over its limits."""
        extent, joints = Extent(self.hulls, self.group.joints), self.group.joints
        low, span = self.limits.lower, self.limits.upper - self.limits.lower
        spread = [
            (np.arange(len(joints)) * 0.618 + np.arange(len(joints)) ** 2 * k / SPREAD) % 1.0
            for k in range(SPREAD)
        ]
        return max(extent.metres(dict(zip(joints, map(float, low + f * span), strict=True))) for f in spread)

    def checker(self, moment: Moment, goal: MoveGoal, *, padded: bool = True) -> CollisionChecker:
        """Return the collisions of this group at that moment, with what the goal permits."""
        between = self._between_fingers(moment, goal)
        inside = tuple(each.name for each in between)
        touch = () if self.hand is None else (*self.hand.touch_links, *inside)
        return CollisionChecker(
            self.hulls,
            self.group.joints,
            self.with_hand(moment, goal.hand_width),
            self.obstacles(moment.scene, moment.base_in_map, padded=padded),
            (*carried(moment.scene, self.description), *between),
            () if _goes_on(goal) else allowed(moment.scene, goal.touch_item, inside),
            touchable=allowed(moment.scene, goal.touch_item, touch, every=goal.retreats),
            world=self.world,
        )

    def _between_fingers(self, moment: Moment, goal: MoveGoal) -> tuple[Carried, ...]:
        """Return the space that the fingers may cross on the way, if they may."""
        if self.hand is None or self._fingers is None or goal.straight or goal.retreats:
            return ()
        if any(each.attached_to == self.hand.side for each in moment.scene.objects):
            return ()
        return self._fingers.at(moment.positions, goal.hand_width)

    def obstacles(
        self, scene: PlanningScene, base_in_map: FloorPose | None, *, padded: bool = True
    ) -> tuple[Obstacle, ...]:
        """Return what stands within this group's reach, in the base."""
        return () if base_in_map is None else obstacles(scene, base_in_map, self._reach, padded=padded)

    def with_hand(self, moment: Moment, width: float | None) -> Mapping[str, float]:
        """Return the positions with the hand as wide as it will be when it reaches for something."""
        if self.hand is None or width is None:
            return moment.positions
        gripper = self.hand.gripper
        wide = min(width, gripper.max_width) / len(gripper.joints)
        return {**moment.positions, **dict.fromkeys(gripper.joints, wide)}

    def start(self, moment: Moment) -> Array:
        """Return where the group stands (n,), be it a hair beyond a limit."""
        return np.array(moment.joints.position_of(self.group.joints))


def _goes_on(goal: MoveGoal) -> bool:
    """Say whether another move brings the hand to its item: if none does, this one may end around it."""
    return any(each.followed_by for each in goal.candidates)


def words(contact: Contact | None) -> str:
    """Return the two bodies of a contact in words."""
    return "" if contact is None else f"{contact.first} and {contact.second}"
