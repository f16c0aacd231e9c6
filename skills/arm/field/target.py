"""Where the hand shall be: the item as it is believed now, and the proximity poses before its grasps."""

from __future__ import annotations

import math
from dataclasses import dataclass

from skills.ports.actions.approach import ApproachGoal
from skills.ports.actions.arm import Candidate, MoveGoal
from skills.ports.bus import Bus
from skills.ports.geometry import Pose, about, angle_between, compose, distance, invert, multiply, to_pose
from skills.ports.grasping import item_in_map
from skills.ports.keys import Latest
from skills.ports.message import Vector3
from skills.ports.world import ROBOT_POSE, WORLD

QUARTER = math.pi / 2.0
_UP: Vector3 = (0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Target:
    """The item's centre frame, and the tool's poses before and at each grasp; all in the base."""

    item: Pose
    proximity: tuple[Pose, ...]
    grasps: tuple[Pose, ...]

    def moved(self, before: Target) -> tuple[float, float]:
        """Return by how many metres and radians the item has moved."""
        return distance(self.item, before.item), angle_between(self.item.orientation, before.item.orientation)

    def as_move(self, goal: ApproachGoal) -> MoveGoal:
        """Return the goal of a move to the proximity poses, from where the grasps can be reached."""
        return MoveGoal(
            candidates=tuple(
                Candidate(pose=before, followed_by=(grasp,))
                for before, grasp in zip(self.proximity, self.grasps, strict=True)
            ),
            frame="base",
            touch_item=goal.item,
            hand_width=goal.hand_width,
            speed=goal.speed,
        )


class TargetTracker:
    """Follows one item.

    An item carries its tag on several upright sides, and the side that was seen last gives its frame. When
    another side is seen the frame turns by quarters though the item stands still; grasps are told in the
    frame of the beginning, so it is turned back.

    Args:
        bus: where the beliefs are.
    """

    def __init__(self, bus: Bus) -> None:
        self._goal: ApproachGoal | None = None
        self._world, self._robot = Latest(bus, WORLD), Latest(bus, ROBOT_POSE)
        self._before: Pose | None = None
        self.heard = False
        """Whether beliefs and the robot's pose have come."""
        self.localised = False

    def begin(self, goal: ApproachGoal) -> None:
        """Follow this goal's item from now on."""
        self._goal, self._before = goal, None

    def refresh(self) -> Target | None:
        """Return the target, or None while the item is not believed to be anywhere, or is in a hand."""
        world, robot, goal = self._world.refresh(), self._robot.refresh(), self._goal
        if world is None or robot is None or goal is None:
            return None
        self.heard, self.localised = True, robot.localised
        fact = world.item(goal.item)
        if fact is None or fact.held is not None:
            return None
        frame = self._steady(item_in_map(fact.tag_in_map, fact.size[0]))
        item = compose(invert(to_pose(robot.base_in_map)), frame)
        grasps = tuple(compose(item, grasp) for grasp in goal.grasps)
        before = Pose(position=(-goal.radius, 0.0, 0.0))
        return Target(item, tuple(compose(grasp, before) for grasp in grasps), grasps)

    def _steady(self, frame: Pose) -> Pose:
        if self._before is not None:
            turns = [
                Pose(
                    position=frame.position, orientation=multiply(frame.orientation, about(_UP, k * QUARTER))
                )
                for k in range(4)
            ]
            known = self._before.orientation
            frame = min(turns, key=lambda each: round(angle_between(each.orientation, known), 6))
        self._before = frame
        return frame

    def close(self) -> None:
        """End the subscriptions."""
        self._world.close()
        self._robot.close()
