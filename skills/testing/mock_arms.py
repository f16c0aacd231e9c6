"""Arms and hands of a mocked robot: they are in or out, and hold what they were brought to."""

from __future__ import annotations

from typing import Final, Protocol

from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.ports.actions.approach import ApproachGoal, ApproachResult
from tandem.skills.ports.actions.approach import approach as contract
from tandem.skills.ports.actions.arm import MoveGoal, MoveResult, SurveyGoal, SurveyResult
from tandem.skills.ports.actions.bimanual import PAIR, TwoHands, TwoHandsGoal, TwoHandsResult
from tandem.skills.ports.actions.gripper import Grip, GripGoal, GripResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.skill import Outcome, failed, succeeded
from tandem.skills.ports.world import WorldState

TUCKED: Final = 0.20
STRETCHED: Final = 0.75
"""Metres from the arm's shoulder to its hand."""


class _Armed(Protocol):
    """The robot whose arms they are."""

    world: WorldState
    out_of_reach: int
    """How many of a survey's first base poses are out of reach."""


class MockArms:
    """What ``MockRobot`` has of them as ``arms``.

    Args:
        robot: whose.
        first: the item that a hand grasps which was brought to none.
    """

    def __init__(self, robot: _Armed, first: int | None) -> None:
        self._robot, self._first = robot, first
        self.extent: dict[HandName, float] = {"left": TUCKED, "right": TUCKED}
        """How far each arm is out: ``TUCKED`` or ``STRETCHED``."""
        self.hands: dict[HandName, int | None] = {"left": None, "right": None}
        """What each hand holds in truth."""
        self._before: dict[HandName, int] = {}

    def move(self, side: HandName, goal: MoveGoal) -> Outcome[MoveResult]:
        """Put the hand where the goal says: in, or out."""
        self.extent[side] = TUCKED if goal.posture in {"home", "carry"} else STRETCHED
        if goal.follows_item is not None or goal.touch_item is not None:
            self._before[side] = goal.follows_item or goal.touch_item or 0
        return succeeded(MoveResult(positions=(0.0,), error=0.0, planning_steps=1, duration=0.0))

    def approach(self, side: HandName, goal: ApproachGoal) -> Outcome[ApproachResult]:
        """Bring the hand to an item that is believed in."""
        fact = self._robot.world.item(goal.item)
        if fact is None:
            message = f"item {goal.item} is not believed to be anywhere"
            where = contract(f"arm_{side}").name
            return failed(Failure(kind=FailureKind.ITEM_GONE, message=message, where=where))
        self.extent[side], self._before[side] = STRETCHED, goal.item
        at = standing_in_map(fact.tag_in_map, fact) or Pose(position=fact.tag_in_map.position)
        return succeeded(ApproachResult(grasp=0, positions=(0.0,), error=0.0, item_in_map=at, duration=0.0))

    def two_hands(self, goal: TwoHandsGoal) -> Outcome[TwoHandsResult]:
        """Have both hands do as the goal says."""
        force = 0.0 if goal.do is TwoHands.RELEASE else goal.force or 40.0
        self.extent = dict.fromkeys(PAIR, STRETCHED)
        return succeeded(TwoHandsResult(left_force=force, right_force=force, item_in_map=goal.to))

    def survey(self, goal: SurveyGoal) -> Outcome[SurveyResult]:
        """Call all bases good but those that are out of reach."""
        good = range(self._robot.out_of_reach, len(goal.bases))
        return succeeded(SurveyResult(bases=tuple(good[: goal.enough])))

    def grip(self, side: HandName, goal: GripGoal) -> Outcome[GripResult]:
        """Open or close the hand, on what it was brought to."""
        if goal.grip is Grip.GRASP:
            self.hands[side] = self._before.get(side, self._first)
        elif goal.grip is Grip.OPEN:
            self.hands[side] = None
        full = self.hands[side] is not None
        return succeeded(
            GripResult(width=goal.width if full else 0.0, force=10.0 if full else 0.0, full=full)
        )
