"""What an arm's field is made of at each period: joints, obstacles, the other arm and its goal."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.arm.field.hand_surroundings import Around, split
from tandem.skills.arm.problem import Arm, Moment
from tandem.skills.arm.silence import joints_silent
from tandem.skills.geometry.poses import floor_distance
from tandem.skills.kinematics.bodies import CellsShape, Obstacle
from tandem.skills.kinematics.described import carried, home_positions
from tandem.skills.kinematics.proximity import Proximity
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.approach import approach_status
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES, STOP_STATE, Latest, group_status
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.shapes import extents
from tandem.skills.ports.world import ROBOT_POSE, SCENE, PlanningScene

AHEAD: Final = 0.15
"""Seconds by which all other joints are looked at ahead, at their present speeds: what braking takes."""
STANDS: Final = 0.002
"""Radians (or metres) that no joint goes in that time when it stands."""
SHIFTED: Final = 0.002
"""Metres by which the base is believed elsewhere before obstacles are placed anew."""
TURNED: Final = 0.002
"""Radians, likewise: at an arm's length of a metre it shifts things by as much as SHIFTED."""
GOAL_AGE: Final = 0.5
"""Robot seconds after which what was told of the other arm's approach is old."""


@dataclass(frozen=True)
class _Placed:
    """What the obstacles were made from."""

    version: int
    base: FloorPose


class Live:
    """Listens, and keeps the distances' bodies up to date.

    Args:
        bus: hardware and beliefs.
        clocks: robot time.
        arm: the group.
    """

    def __init__(self, bus: Bus, clocks: Clocks, arm: Arm) -> None:
        self._clocks, self._arm = clocks, arm
        self.hand_width: float | None = None
        """Metres between the pads that are reckoned with; as they are unless given."""
        self._joints, self._scene = Latest(bus, JOINT_STATES), Latest(bus, SCENE)
        self._pose, self._stop = Latest(bus, ROBOT_POSE), Latest(bus, STOP_STATE)
        self._group = Latest(bus, group_status(arm.group.name))
        robot = arm.hulls.robot
        self.columns = np.array([robot.joint_index(joint) for joint in arm.group.joints])
        others = [hand for hand in arm.description.end_effectors if hand.group != arm.group.name]
        self._others = [Latest(bus, approach_status(hand.group)) for hand in others]
        self.other_links = _links_of(arm, [hand.group for hand in others])
        moving = {joint for hand in others for joint in arm.description.group(hand.group).joints}
        home = home_positions(arm.description)
        self._home = {joint: at for joint, at in home.items() if joint in moving}
        self.proximity = Proximity(arm.hulls, arm.group.joints)
        self.around = Around((), ())
        self._placed: _Placed | None = None
        self._goal: Vector3 | None = None
        self._obstacles: tuple[Obstacle, ...] = ()
        self._index: Array | None = None
        self._full: Array = np.zeros(0)
        self._now: Array = np.zeros(0)

    def refresh(self) -> None:
        """Take what has come."""
        joints, scene, pose = self._joints.refresh(), self._scene.refresh(), self._pose.refresh()
        self._stop.refresh()
        self._group.refresh()
        if joints is not None:
            self._full, self._now = self._configuration(joints, AHEAD), self._configuration(joints, 0.0)
        if scene is not None and pose is not None:
            self._place(scene, pose.base_in_map)

    @property
    def missing(self) -> str:
        """Say what has not been heard yet; nothing when all has."""
        parts = (("joint states", self._joints), ("planning scene", self._scene), ("robot pose", self._pose))
        return ", ".join(name for name, latest in parts if latest.value is None)

    @property
    def stopped(self) -> bool:
        """Whether the hardware's stop is set."""
        state = self._stop.value
        return state is not None and state.stopped

    @property
    def at_rest(self) -> bool:
        """Whether the hardware says that the group is at rest, and takes motions again."""
        status = self._group.value
        return status is None or status.at_rest

    @property
    def silent(self) -> bool:
        """Whether no joint states have come for too long."""
        return joints_silent(self._joints.value, self._clocks)

    def measured(self) -> tuple[Array, Array]:
        """Return the group's measured positions and velocities, (n,) each."""
        joints = self._joints.value
        assert joints is not None  # heard before anything moves
        places = {name: k for k, name in enumerate(joints.names)}
        rows = [places[joint] for joint in self._arm.group.joints]
        return np.array([joints.positions[k] for k in rows]), np.array([joints.velocities[k] for k in rows])

    def full(self, q: Array) -> Array:
        """Return all joints' positions: the group's at q, the others where they are about to be."""
        everything = self._full.copy()
        everything[self.columns] = q
        return everything

    def cases(self, q: Array) -> tuple[Array, ...]:
        """Return all joints' positions: the group's at q, the others where they are about to be, or stop now.

        One that is on its way out may be stopped in the way.
        """
        coming = self.full(q)
        here = self._now.copy()
        here[self.columns] = q
        return (coming,) if bool(np.abs(coming - here).max() < STANDS) else (coming, here)

    def in_the_way(self, failure: Failure) -> bool:
        """Say whether it is the other arm that would be touched: it moves on."""
        told = [str(each.evidence.get("contact", "")) for each in (failure, *failure.causes)]
        return any(link in contact for contact in told for link in self.other_links)

    def moment(self, q: Array, *, others_gone: bool = False) -> Moment:
        """Return what is believed now, the group standing at q, and the others at home if gone."""
        joints, scene, pose = self._joints.value, self._scene.value, self._pose.value
        assert joints is not None
        assert scene is not None
        assert pose is not None
        mine = dict(self._home) if others_gone else {}
        mine |= dict(zip(self._arm.group.joints, map(float, q), strict=True))
        positions = tuple(mine.get(name, at) for name, at in zip(joints.names, joints.positions, strict=True))
        return Moment(joints.model_copy(update={"positions": positions}), scene, pose.base_in_map)

    def other_goal(self) -> Vector3 | None:
        """Return the other arm's goal in the base, if it approaches one."""
        now = self._clocks.robot()
        for latest in self._others:
            told = latest.refresh()
            if told is None or now is None or not told.active:
                continue
            if told.stamp.is_fresh(now, GOAL_AGE):
                return told.goal_in_base
        return None

    def _configuration(self, joints: JointStates, ahead: float) -> Array:
        robot = self._arm.hulls.robot
        positions = {
            name: at + ahead * speed
            for name, at, speed in zip(joints.names, joints.positions, joints.velocities, strict=True)
        }
        hand = self._arm.hand
        if hand is not None and self.hand_width is not None:
            wide = min(self.hand_width, hand.gripper.max_width) / len(hand.gripper.joints)
            positions |= dict.fromkeys(hand.gripper.joints, wide)
        return robot.configuration(positions)

    def _place(self, scene: PlanningScene, base: FloorPose) -> None:
        goal, known = self.other_goal(), self._placed
        stale = (
            known is None
            or known.version != scene.version
            or floor_distance(known.base, base) > SHIFTED
            or abs(known.base.yaw - base.yaw) > TURNED
        )
        if stale:
            self._placed = _Placed(scene.version, base)
            self._obstacles = self._arm.obstacles(scene, base)
            self.proximity.stand(self._obstacles, carried(scene, self._arm.description))
        if stale or goal != self._goal:
            self._goal = goal
            boxes = [
                (each.pose_in_base, extents(each.shape))
                for each in self._obstacles
                if not isinstance(each.shape, CellsShape)
            ]
            self.around = split(boxes, goal)

    def close(self) -> None:
        """End the subscriptions."""
        for inbox in (self._joints, self._scene, self._pose, self._stop, self._group):
            inbox.close()
        for other in self._others:
            other.close()


def _links_of(arm: Arm, groups: list[str]) -> tuple[str, ...]:
    """Return the links that the joints of some groups move."""
    model, robot = arm.hulls.robot.model, arm.hulls.robot
    joints = {
        robot.joint_index(joint) + 1 for group in groups for joint in arm.description.group(group).joints
    }
    bodies = zip(arm.hulls.links, arm.hulls.geometry.geometryObjects, strict=True)
    return tuple(
        link for link, body in bodies if joints & {int(j) for j in model.supports[int(body.parentJoint)]}
    )
