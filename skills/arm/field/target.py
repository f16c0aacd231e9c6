"""Where the hand shall be: the item as it is believed now, and the proximity poses before its grasps."""

from __future__ import annotations

from dataclasses import dataclass

from tandem.skills.geometry.poses import angle_between, compose, distance, invert, to_pose, turned
from tandem.skills.grasping.item_frames import standing_in_map, turned_like
from tandem.skills.ports.actions.approach import ApproachGoal
from tandem.skills.ports.actions.arm import Candidate, MoveGoal, TurnAbout
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import ROBOT_POSE, WORLD

HIDDEN_FOR = 2.5
"""Robot seconds for which the arm stands and waits when its item has disappeared.

It was moved, and the head looks for it; not found by then, it may be that this arm hides it.
"""


@dataclass(frozen=True)
class Target:
    """The item's centre frame, and the tool's poses before and at each grasp; all in the base."""

    item: Pose
    proximity: tuple[Pose, ...]
    grasps: tuple[Pose, ...]

    def moved(self, before: Target) -> tuple[float, float]:
        """Return by how many metres and radians the item has moved."""
        return distance(self.item, before.item), angle_between(self.item.orientation, before.item.orientation)

    def before(self, grasp: int, turn: float) -> Pose:
        """Return the proximity pose of a grasp (its number) that is turned by ``turn`` radians."""
        return self._turned(self.proximity[grasp], turn)

    def as_move(self, goal: ApproachGoal, turn: float = 0.0) -> MoveGoal:
        """Return the goal of a move to the proximity poses, from where the grasps can be reached.

        ``turn``: radians by which all of them are turned already.
        """
        return MoveGoal(
            candidates=tuple(
                Candidate(pose=self._turned(before, turn), followed_by=(self._turned(grasp, turn),))
                for before, grasp in zip(self.proximity, self.grasps, strict=True)
            ),
            turn=TurnAbout(point=self.item.position, most=goal.turn) if goal.turn else None,
            frame="base",
            touch_item=goal.item,
            hand_width=goal.hand_width,
            speed=goal.speed,
        )

    def _turned(self, pose: Pose, angle: float) -> Pose:
        return turned(pose, self.item.position, angle) if angle else pose


class TargetTracker:
    """Follows one item.

    An item carries its tag on several upright sides, and the side that was seen last gives its frame. When
    another side is seen the frame turns by quarters though the item stands still; grasps are told in the
    frame of the beginning, so it is turned back.

    Args:
        bus: where the beliefs are.
        clocks: robot time, for how long an item has not been seen.
    """

    def __init__(self, bus: Bus, clocks: Clocks) -> None:
        self._clocks = clocks
        self._last: tuple[float, Pose] | None = None
        self._goal: ApproachGoal | None = None
        self._world, self._robot = Latest(bus, WORLD), Latest(bus, ROBOT_POSE)
        self._before: Pose | None = None
        self.hidden = False
        """Whether the target is where the item was last seen, and not where it is believed to be."""
        self.heard = False
        """Whether beliefs and the robot's pose have come."""
        self.localised = False

    def begin(self, goal: ApproachGoal) -> None:
        """Follow this goal's item from now on."""
        self._goal, self._before, self._last = goal, None, None

    def refresh(self) -> Target | None:
        """Return the target; None when the item is in a hand, has fallen over, or is for long nowhere."""
        world, robot, goal = self._world.refresh(), self._robot.refresh(), self._goal
        if world is None or robot is None or goal is None:
            return None
        self.heard, self.localised = True, robot.localised
        fact = world.item(goal.item)
        now = robot_seconds(self._clocks)
        stands = None if fact is None or fact.held else standing_in_map(fact.tag_in_map, fact)
        if stands is not None:
            self.hidden = False
            self._last = (now, self._steady(stands))
        elif fact is not None or self._last is None or now - self._last[0] > HIDDEN_FOR:
            return None
        else:
            self.hidden = True
        frame = self._last[1]
        item = compose(invert(to_pose(robot.base_in_map)), frame)
        grasps = tuple(compose(item, grasp) for grasp in goal.grasps)
        before = Pose(position=(-goal.radius, 0.0, 0.0))
        return Target(item, tuple(compose(grasp, before) for grasp in grasps), grasps)

    def _steady(self, frame: Pose) -> Pose:
        if self._before is not None:
            frame = turned_like(frame, self._before)
        self._before = frame
        return frame

    @property
    def item_in_map(self) -> Pose:
        """The item's frame, in the map, that the grasps are told in; there has been a target."""
        assert self._before is not None, "asked for only after a target"
        return self._before

    def close(self) -> None:
        """End the subscriptions."""
        self._world.close()
        self._robot.close()
