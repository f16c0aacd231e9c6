"""Another robot that is followed: how much time is left, and for how long it was seen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Final

from tandem.skills.ports.actions.base import FollowFeedback, FollowResult
from tandem.skills.ports.failure import Failure
from tandem.trees.context import TreeContext
from tandem.trees.course import Course, Target

AT_ONCE: Final = 300.0
"""Robot seconds of one goal at the most: its client gives up at twice that."""
NOWHERE: Final = Target(x=0.0, y=0.0, yaw=None, tolerance=0.0)


@dataclass(eq=False)
class Pursuit:
    """Time runs on while a reflex has the base, so that none can hold it up for ever.

    Args:
        context: of the task.
        wanted: robot seconds to follow.
    """

    context: TreeContext
    wanted: float
    spent: float = 0.0
    """Robot seconds since the other is followed."""
    seen: float = 0.0
    """Robot seconds of these for which the other was seen."""
    hears: Callable[[], FollowFeedback | None] = lambda: None
    """Returns what the skill tells now."""
    course: Course = field(init=False)
    """Counts what reflexes do; a pursuit has no place to get to."""
    _at: float | None = None
    _began: float = 0.0
    _partly: float = 0.0
    """Seconds for which the other was seen during the goal that is at work."""

    def __post_init__(self) -> None:
        """Begin with no count."""
        self.course = Course(self.context, NOWHERE)

    @property
    def left(self) -> float:
        """Robot seconds that are left."""
        return max(0.0, self.wanted - self.spent)

    @property
    def over(self) -> bool:
        """Whether the time is over; a rest too short for a goal is none."""
        return self.left < 0.5  # noqa: PLR2004 - seconds

    def watch(self) -> None:
        """Take note of the time, of whether the other is seen, and of reflexes; called at each tick."""
        self.course.watch()
        now = self.context.seconds
        passed = 0.0 if self._at is None else max(0.0, now - self._at)
        self._at, self.spent = now, self.spent + passed
        told = self.hears()
        if told is not None and told.distance is not None:
            self._partly += passed

    def sets_out(self) -> float:
        """Note that a goal is sent; return for how many seconds."""
        self._at = self.context.seconds if self._at is None else self._at
        self._began, self._partly = self.spent, 0.0
        self.course.sets_out()
        return min(self.left, AT_ONCE)

    def done(self, result: FollowResult) -> None:
        """Take in that a goal has ended by itself: what it tells counts more than what was heard."""
        self.spent = max(self.spent, self._began + result.seconds)
        self.seen += result.seen
        self._partly = 0.0

    def held_up(self, failure: Failure) -> Failure | None:
        """Take in that a reflex had the base. It is never enough: the time runs out."""
        self.seen, self._partly = self.seen + self._partly, 0.0
        self.course.held_up(failure)
        return None
