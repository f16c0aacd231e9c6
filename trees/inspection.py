"""What an inspection has seen so far, and what it tells at its end. Survives a restart of the executive."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final

from pydantic import Field

from tandem.skills.grasping.item_frames import standing_in_map
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import ItemFact, Sighting
from tandem.trees.context import TreeContext

NAME: Final = "inspect"


class SeenItem(Message):
    """An item that was seen, and where it is believed to be."""

    item: Count
    """Its number."""
    name: str = ""
    """What the site calls it."""
    pose: Pose
    """In the map: of its centre, z up, if it stands on a side; else of the tag that was seen."""
    stands: bool
    """Whether ``pose`` is that of its centre."""
    position_sigma: float
    """Standard deviation of the position in metres, as perception tells it."""
    spots: tuple[str, ...]
    """The spots from which it was seen, in the order of the visits."""


class MissedSpot(Message):
    """A spot from which nothing could be looked at, and why."""

    spot: str
    kind: FailureKind
    message: str


class InspectResult(Message):
    """What was seen from which spots."""

    spots: tuple[str, ...]
    """The spots from which the robot looked around, in order."""
    missed: tuple[MissedSpot, ...] = ()
    items: tuple[SeenItem, ...] = ()
    """By number; of two things with one number, both."""


class InspectNotes(Message):
    """Kept with the task (``TaskNotes.keep``)."""

    done: tuple[str, ...] = ()
    missed: tuple[MissedSpot, ...] = ()
    seen: dict[str, tuple[Count, ...]] = Field(default_factory=dict)
    """Numbers of the items seen, by spot."""


@dataclass(eq=False)
class Inspection:
    """An inspection under way.

    Args:
        context: of its task.
        spots: the names of the spots to be visited, in order.
    """

    context: TreeContext
    spots: tuple[str, ...]
    spot: str = ""
    """The spot whose turn it is."""
    _fresh: dict[int, None] = field(default_factory=dict)
    """Numbers seen from the present spot."""

    @property
    def notes(self) -> InspectNotes:
        """What is noted, by this tree or by the one of before a restart."""
        return self.context.notes.kept(NAME, InspectNotes) or InspectNotes()

    @property
    def left(self) -> tuple[str, ...]:
        """The spots that are still to be visited."""
        notes = self.notes
        gone = {*notes.done, *(missed.spot for missed in notes.missed)}
        return tuple(spot for spot in self.spots if spot not in gone)

    def turn_to_next(self) -> str:
        """Turn to the next spot, and return its name."""
        self.spot, self._fresh = self.left[0], {}
        return self.spot

    def saw(self, sightings: Iterable[Sighting]) -> None:
        """Take in what was seen from the present spot."""
        self._fresh.update(dict.fromkeys(sighting.item for sighting in sightings))

    def finish_spot(self) -> str:
        """Note that the robot has looked around at the present spot; return what it saw, in words."""
        notes = self.notes
        numbers = tuple(sorted(self._fresh))
        self._keep(
            notes.model_copy(
                update={"done": (*notes.done, self.spot), "seen": {**notes.seen, self.spot: numbers}}
            )
        )
        return f"{self.spot}: {', '.join(map(self.context.site.called, numbers)) or 'no item'}"

    def miss_spot(self) -> str:
        """Note why the present spot could not be looked around at; return it in words."""
        notes, last = self.notes, self.context.failures.last()
        missed = MissedSpot(spot=self.spot, kind=last.kind, message=last.message)
        self._keep(notes.model_copy(update={"missed": (*notes.missed, missed)}))
        return f"{self.spot} is left out: {last.kind}"

    def _keep(self, notes: InspectNotes) -> None:
        self.context.notes.keep(NAME, notes)

    def result(self) -> InspectResult:
        """Return what has been seen by now, with the poses that are believed."""
        notes, world = self.notes, self.context.knowledge.world
        seen = {**notes.seen}
        if self._fresh and self.spot not in seen:  # it ends in the middle of a spot
            seen[self.spot] = tuple(sorted(self._fresh))
        items = []
        for number in sorted({number for numbers in seen.values() for number in numbers}):
            spots = tuple(spot for spot in self.spots if number in seen.get(spot, ()))
            facts = () if world is None else world.those(number)
            known = self.context.site.item(number)
            name = "" if known is None else known.name
            items += [_told(fact, name, spots) for fact in facts if fact.held is None]
        return InspectResult(spots=notes.done, missed=notes.missed, items=tuple(items))


def _told(fact: ItemFact, name: str, spots: tuple[str, ...]) -> SeenItem:
    stands = standing_in_map(fact.tag_in_map, fact)
    return SeenItem(
        item=fact.item,
        name=name,
        pose=stands or fact.tag_in_map,
        stands=stands is not None,
        position_sigma=fact.position_sigma,
        spots=spots,
    )
