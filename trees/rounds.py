"""Rounds of corners under way: which is next, and when each was visited. Survives a restart."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.message import Count, Message
from tandem.trees.context import TreeContext
from tandem.trees.course import Course, Target

NAME: Final = "rounds"
KEPT: Final = 50
"""Visits that are told: a result must stay small."""


@dataclass(frozen=True)
class Place:
    """Metres in the map."""

    x: float
    y: float


class Visit(Message):
    """A corner, when it was visited, and how near."""

    corner: Count
    """Counted from 0, as in the request."""
    round: Count
    """Counted from 1."""
    at: float
    """Robot seconds, of the hardware's boot."""
    position_error: float
    """Metres."""


class RoundsNotes(Message):
    """Kept with the task (``TaskNotes.keep``)."""

    visited: Count = 0
    visits: tuple[Visit, ...] = ()


@dataclass(eq=False)
class Rounds:
    """Corners that are visited in order, several times.

    Args:
        context: of the task.
        corners: the places.
        rounds: how often.
        tolerance: metres.
    """

    context: TreeContext
    corners: tuple[Place, ...]
    rounds: int
    tolerance: float
    course: Course = field(init=False)

    def __post_init__(self) -> None:
        """Begin with the corner that is next."""
        self.course = Course(self.context, self._target())

    @property
    def all(self) -> int:
        """How many visits there are to be."""
        return self.rounds * len(self.corners)

    @property
    def notes(self) -> RoundsNotes:
        """What is noted, by this tree or by the one of before a restart."""
        return self.context.notes.kept(NAME, RoundsNotes) or RoundsNotes()

    @property
    def over(self) -> bool:
        """Whether all have been visited."""
        return self.notes.visited >= self.all

    def turn_to_next(self) -> str:
        """Turn to the corner that is next, and return it in words."""
        self.course.aim(self._target())
        done = self.notes.visited
        corner, lap = done % len(self.corners), done // len(self.corners) + 1
        return f"corner {corner}, round {lap} of {self.rounds}"

    def arrive(self) -> str:
        """Note that the robot is at the corner; return it in words."""
        notes = self.notes
        corner, lap = notes.visited % len(self.corners), notes.visited // len(self.corners) + 1
        off = self.course.away() or 0.0
        visit = Visit(corner=corner, round=lap, at=robot_seconds(self.context.clocks), position_error=off)
        visits = (*notes.visits, visit)[-KEPT:]
        self.context.notes.keep(NAME, RoundsNotes(visited=notes.visited + 1, visits=visits))
        return f"corner {corner}, {off:.2f} m from it"

    def _target(self) -> Target:
        place = self.corners[self.notes.visited % len(self.corners)]
        return Target(x=place.x, y=place.y, yaw=None, tolerance=self.tolerance)
