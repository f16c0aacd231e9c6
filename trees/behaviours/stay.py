"""Hold a place for a while, without moving."""

from __future__ import annotations

from py_trees.common import Status

from tandem.trees.behaviours.pause import Pause
from tandem.trees.context import TreeContext
from tandem.trees.course import Course


class Stay(Pause):
    """RUNNING at the course's target; SUCCESS when the time is over, or when the robot is no longer there.

    The time begins when it is there first, and runs on when it is pushed away and comes back.

    Args:
        name: unique in the tree.
        context: its clock.
        seconds: robot seconds to stay.
        course: where.
    """

    def __init__(self, name: str, context: TreeContext, seconds: float, course: Course) -> None:
        super().__init__(name, context, seconds)
        self._course, self._arrived, self.left = course, False, 0

    def initialise(self) -> None:
        """Note the time of the first arrival. The way back, if there is one, is a way of its own."""
        if not self._arrived:
            self._arrived = True
            super().initialise()

    def over(self) -> bool:
        """Say whether the time is over, and the robot has not been pushed away."""
        return self._arrived and self.waited >= self.seconds and (not self.seconds or self._course.there())

    def update(self) -> Status:
        """Watch the time and the place."""
        status = super().update()
        if status is Status.SUCCESS or self._course.there():
            taken = self._context.knowledge.base_taken
            self.feedback_message += f"; {taken}" if taken else ""
            return status
        self.left += 1
        self._course.aim(self._course.target)
        self.feedback_message = f"pushed away; {self.feedback_message}"
        return Status.SUCCESS
