"""The way of a robot on wheels from place to place: how near it is, and how often reflexes took the base."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

from pydantic import Field

from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Count, Message
from tandem.trees.behaviours.give_way import REFLEX
from tandem.trees.context import TreeContext

NAME: Final = "course"
OVERRIDES: Final = 20
"""How often in a row reflexes may take the base before it has got nearer. One that gives way to a passer-by
takes it once to three times in the five to ten seconds that one needs to pass. Twenty are several of them, or
a minute at one spot: then the way is closed, and somebody should know."""
NEARER: Final = 0.3
"""Metres by which it must have got nearer for the count to begin anew: more than a turn on the spot and the
noise of a pose sensor make out."""
AFTER_OVERRIDE: Final = 0.2
"""Robot seconds in which the pipeline's state arrives."""
AFTER_REFUSAL: Final = 2.0
"""Robot seconds before a base that was refused as busy is asked again, where its pipeline tells nothing."""
YAW_TOLERANCE: Final = 0.15
"""Radians."""


@dataclass(frozen=True)
class Target:
    """A place in the map: metres and, unless any heading will do, radians."""

    x: float
    y: float
    yaw: float | None
    tolerance: float
    """Metres."""

    @property
    def words(self) -> str:
        """Return it for people."""
        return f"({self.x:.2f}, {self.y:.2f}) m"


class CourseNotes(Message):
    """Kept with the task (``TaskNotes.keep``)."""

    overridden: Count = 0
    replans: Count = 0
    reactive: float = 0.0
    reflexes: dict[str, Count] = Field(default_factory=dict)


@dataclass(eq=False)
class Course:
    """A task's way; its counts survive a restart of the executive.

    Args:
        context: of its task.
        target: where it goes now.
        most: how often in a row reflexes may take the base.
    """

    context: TreeContext
    target: Target
    most: int = OVERRIDES
    not_before: float = 0.0
    """Robot seconds (``context.seconds``) before which no goal is sent."""
    reactive: float = 0.0
    """Robot seconds for which a reflex had the base, since this tree began."""
    _nearest: float = math.inf
    """Metres from the target, the least of this way."""
    _before: float = math.inf
    """The same when the count began."""
    _in_a_row: dict[str, int] = field(default_factory=dict)
    _sent: bool = False
    _seen: tuple[float, bool] | None = None

    @property
    def notes(self) -> CourseNotes:
        """What is noted, by this tree or by the one of before a restart."""
        return self.context.notes.kept(NAME, CourseNotes) or CourseNotes()

    def aim(self, target: Target) -> None:
        """Turn to a place: nothing is known yet of how one gets there."""
        self.target, self._sent = target, False
        self._nearest, self._before, self._in_a_row = math.inf, math.inf, {}

    def away(self) -> float | None:
        """Return the metres from the target, or None while it is not known where the robot is."""
        robot = self.context.knowledge.robot
        if robot is None or not robot.localised:
            return None
        at = robot.base_in_map
        return math.hypot(at.x - self.target.x, at.y - self.target.y)

    def _distance(self) -> float:
        away = self.away()
        return math.inf if away is None else away

    def there(self) -> bool:
        """Say whether the robot is believed to be at the target."""
        away, robot, yaw = self.away(), self.context.knowledge.robot, self.target.yaw
        if away is None or robot is None or away > self.target.tolerance:
            return False
        return yaw is None or abs(wrap(robot.base_in_map.yaw - yaw)) < YAW_TOLERANCE

    def free(self) -> bool:
        """Say whether no reflex has the base, and it may be asked for again."""
        return not self.context.knowledge.base_taken and self.context.seconds >= self.not_before

    def watch(self) -> None:
        """Take note of who has the base now; called at each tick."""
        now, taken = self.context.seconds, bool(self.context.knowledge.base_taken)
        if self._seen is not None and self._seen[1]:
            self.reactive += max(0.0, now - self._seen[0])
        self._seen = (now, taken)
        self._nearest = min(self._nearest, self._distance())

    def sets_out(self) -> None:
        """Note that a goal is sent; each after the first for a target is a plan made anew."""
        if self._sent:
            self._keep(replans=self.notes.replans + 1)
        self._sent = True

    def held_up(self, failure: Failure) -> Failure | None:
        """Take in that a reflex had the base; return why it is enough now, or None: try again."""
        reflex, notes = str(failure.evidence.get(REFLEX, "")), self.notes
        refused = failure.kind is FailureKind.BUSY
        self.not_before = self.context.seconds + (AFTER_REFUSAL if refused else AFTER_OVERRIDE)
        if not refused:
            told = {**notes.reflexes, reflex: notes.reflexes.get(reflex, 0) + 1}
            self._keep(overridden=notes.overridden + 1, reflexes=told)
        self._nearest = min(self._nearest, self._distance())
        if self._nearest < self._before - NEARER:
            self._in_a_row, self._before = {}, self._nearest
        self._in_a_row[reflex] = self._in_a_row.get(reflex, 0) + 1
        return self._starved(failure) if sum(self._in_a_row.values()) >= self.most else None

    def _starved(self, last: Failure) -> Failure:
        times, by = sum(self._in_a_row.values()), _words(self._in_a_row)
        near = self._nearest
        nearest = "" if math.isinf(near) else f"; the nearest was {near:.2f} m from {self.target.words}"
        where = {} if math.isinf(near) else {"nearest_m": round(near, 3)}
        return Failure(
            kind=FailureKind.OVERRIDDEN,
            message=f"reflexes had the base {times} times ({by}) without {NEARER} m of progress{nearest}",
            evidence={
                "overridden": times,
                "reflexes": by,
                **where,
                "target_x_m": self.target.x,
                "target_y_m": self.target.y,
            },
            causes=(last,),
        )

    def counts(self) -> CourseNotes:
        """Return all that was counted, also before a restart."""
        notes = self.notes
        return notes.model_copy(update={"reactive": round(notes.reactive + self.reactive, 2)})

    def _keep(self, **changes: object) -> None:
        """Keep what has changed, and the seconds on the reactive route with it."""
        notes = self.notes
        reactive, self.reactive = notes.reactive + self.reactive, 0.0
        self.context.notes.keep(NAME, notes.model_copy(update={"reactive": reactive, **changes}))


def _words(reflexes: Mapping[str, int]) -> str:
    return ", ".join(f"{reflex} {times}" for reflex, times in reflexes.items())
