"""``<site>/world/robots/<name>``: where each robot of a site is and what it does, told by itself.

Robots have no common clock, so that the message has no stamp. Who hears it takes its age by a clock of its
own, from when it came. See docs/decisions/007-robots-of-a-site.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.bus import Commons
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.hearing import Heard
from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.pose import FloorPose

EVERY: Final = 0.1
"""Robot seconds between two messages: at 1 m/s a robot is 10 cm farther when the next one comes."""
_AREA: Final = "world/robots/"


class Following(Message):
    """That a robot follows another one."""

    robot: Annotated[str, Field(min_length=1, max_length=64)]
    """Whom it follows."""
    distance: Annotated[float, Field(gt=0.0, le=10.0)]
    """Metres between the two centres that it keeps."""


LARGEST: Final = 10.0
"""Metres: no robot that drives about is larger, and one that says so would hide the rest of a map."""
Extent = Annotated[float, Field(gt=0.0, le=LARGEST)]


class RobotWhereabouts(Message):
    """Where a robot believes that it is, and what it does; owner: its executive."""

    name: Annotated[str, Field(min_length=1, max_length=64)]
    """The robot part of its keys."""
    start: Annotated[str, Field(max_length=64)]
    """Names this start of the teller."""
    sequence: Count
    """Counts the messages of a start."""
    base_in_map: FloorPose | None = None
    """None while it does not know."""
    task: Annotated[str, Field(max_length=200)] = ""
    """Id of the task that runs; empty: none."""
    kind: Annotated[str, Field(max_length=64)] = ""
    """Of that task, such as ``patrol``."""
    phase: Annotated[str, Field(max_length=200)] = ""
    """Of that task."""
    follows: Following | None = None
    """Whom that task follows, if anybody."""
    radius: Extent | None = None
    """Metres: no part of it in its driving posture is farther from the base's axis. None: not known yet."""
    height: Extent | None = None
    """Metres above the floor that it reaches. None: not known yet."""


def whereabouts(robot: str) -> Topic[RobotWhereabouts]:
    """Return the topic of a robot, relative to ``<site>``: on a ``Commons``."""
    return Topic(f"{_AREA}{robot}", RobotWhereabouts)


@dataclass(frozen=True)
class Neighbour:
    """What another robot told last, and how many robot seconds of one's own ago it came."""

    told: RobotWhereabouts
    age: float


class Neighbours:
    """The other robots of the site. Call ``refresh`` in each step of the node.

    Args:
        commons: where they tell; None: there are no others.
        clocks: by which ages are taken.
        own: the robot's own name, which is left out.
    """

    def __init__(self, commons: Commons | None, clocks: Clocks, own: str) -> None:
        self._clocks, self._own = clocks, own
        decode = whereabouts("*").decode
        self._heard = None if commons is None else Heard(commons, f"{_AREA}*", decode, depth=4)
        self._came: dict[str, tuple[RobotWhereabouts, float]] = {}

    @property
    def own(self) -> str:
        """The robot's own name."""
        return self._own

    def refresh(self) -> None:
        """Take in what has arrived; a message under another robot's key, or an older one, is none."""
        for key, told, _ in () if self._heard is None else self._heard.take():
            if key != f"{_AREA}{told.name}" or told.name == self._own:
                continue
            before = self._came.get(told.name)
            if before is None or before[0].start != told.start or before[0].sequence < told.sequence:
                self._came[told.name] = (told, self._clocks.passed())

    def all(self) -> Mapping[str, Neighbour]:
        """Return what each told last, by its name, however old that is: who reads it judges the age."""
        now = self._clocks.passed()
        return {name: Neighbour(told, now - came) for name, (told, came) in self._came.items()}

    def of(self, name: str) -> Neighbour | None:
        """Return what a robot told last, or None."""
        return self.all().get(name)

    def close(self) -> None:
        """Hear no more."""
        if self._heard is not None:
            self._heard.close()
