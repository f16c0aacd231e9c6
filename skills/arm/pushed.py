"""Has the base been pushed since a motion to a place in the map was planned?"""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.arm.scene import to_base
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.world import RobotPose

TOLERANCE: Final = 0.015
"""Metres by which the goal may come to be elsewhere, seen from the base: as much as a motion may miss it by.
Where nobody pushes, the belief of a base at rest changes by less than a millimetre meanwhile (0.6 mm at most
in two fetches of the LoCoBot and two of TIAGo++)."""


class PushedBase:
    """Watches the place in the map that a goal names, as the base sees it.

    The arm goes where the place was when the plan was made. A base that somebody pushes meanwhile would have
    it put an item down beside its slot.

    Args:
        pose: where the robot believes to be.
        where: the action's name, for failures.
    """

    def __init__(self, pose: Latest[RobotPose], where: str) -> None:
        self._pose, self._where = pose, where
        self._goal: MoveGoal | None = None
        self._planned_for: tuple[Vector3, ...] = ()
        self._heard: RobotPose | None = None

    def begin(self, goal: MoveGoal, base_in_map: FloorPose | None) -> None:
        """Note where the goal is seen from; the plan is made now."""
        self._goal = goal if goal.candidates and goal.frame == "map" and base_in_map is not None else None
        self._planned_for = () if base_in_map is None else _seen(goal, base_in_map)

    def moved(self) -> Failure | None:
        """Return ARM_STOPPED when the base is believed to be elsewhere, and to know where."""
        told = self._pose.refresh()
        if self._goal is None or told is None or told is self._heard or not told.localised:
            return None
        self._heard = told
        seen = _seen(self._goal, told.base_in_map)
        way = max(math.dist(now, then) for now, then in zip(seen, self._planned_for, strict=True))
        if way <= TOLERANCE:
            return None
        return Failure(
            kind=FailureKind.ARM_STOPPED,
            message=f"the base has been pushed: the goal is {way:.3f} m from where the plan has it",
            where=self._where,
            evidence={"moved_m": round(way, 4)},
        )


def _seen(goal: MoveGoal, base_in_map: FloorPose) -> tuple[Vector3, ...]:
    """Return where the goal's poses are in the base (m)."""
    return tuple(to_base(each.pose, goal.frame, base_in_map).position for each in goal.candidates)
