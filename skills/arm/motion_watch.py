"""Is the way still free? The rest of a motion, against what has come into the scene since it was checked."""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.problem import Moment, Plan
from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.failure import Failure
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.world import PlanningScene, SceneObject

EVERY: Final = 0.1
"""Seconds of the motion between two checks at the least."""


class MotionWatch:
    """Watches one motion.

    Only a change of what is not carried counts, and only what would truly be hit, without the padding that
    plans keep: an obstacle's place is told a little differently each time that it is seen.

    Args:
        planner: of the group.
        scene: the newest planning scene.
        goal: what was asked.
        moment: what was believed when the motion was planned.
        plan: the motion.
    """

    def __init__(
        self, planner: MovePlanner, scene: Latest[PlanningScene], goal: MoveGoal, moment: Moment, plan: Plan
    ) -> None:
        self._planner, self._scene, self._goal = planner, scene, goal
        self._moment, self._plan = moment, plan
        newest = scene.refresh() or moment.scene
        self._version, self._known = newest.version, _standing(newest)
        self._checked_at = 0.0
        self._check: Generator[int, None, Failure | None] | None = None
        self.found: Failure | None = None
        """What would be hit."""

    def look(self, elapsed: float) -> int:
        """Do a slice of a check if there is something to check; return its units, 0 if there was nothing.

        Args:
            elapsed: seconds of the motion that have passed.
        """
        if self._check is None and not self._begin(elapsed):
            return 0
        assert self._check is not None
        try:
            return next(self._check)
        except StopIteration as stop:
            self._check, self.found = None, stop.value
            return 0

    def _begin(self, elapsed: float) -> bool:
        scene = self._scene.refresh()
        if scene is None or scene.version == self._version or elapsed - self._checked_at < EVERY:
            return False
        self._version = scene.version
        standing = _standing(scene)
        if standing == self._known:
            return False
        self._known, self._checked_at = standing, elapsed
        newest = Moment(self._moment.joints, scene, self._moment.base_in_map)
        self._check = self._planner.recheck(
            self._plan.trajectory, self._goal, newest, after=elapsed, padded=False
        )
        return True


def _standing(scene: PlanningScene) -> tuple[tuple[SceneObject, ...], str]:
    """Return what may be hit: the things that are not carried, and the cells of occupied space."""
    cells = "" if scene.occupied is None else scene.occupied.cells
    return tuple(each for each in scene.objects if each.attached_to is None), cells
