"""What may be chosen of the crossings, and what comes out of them."""

from __future__ import annotations

from typing import Literal

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.site import LocalPlanner

What = Literal["crossing", "alone", "today"]
"""Among people; the same drive without them; among them, with the planner that takes people for things."""


class CrossingOptions(Message):
    """Of all runs."""

    planner: LocalPlanner = "people"
    seed: Count = 1
    baselines: bool = True
    """Whether each drive is made without people, and with today's planner, as well."""


class Touch(Message):
    """A contact of a person with the robot, when (robot seconds), and for how long the robot had stood."""

    person: str
    at: float
    stood: float


class Seen(Message):
    """How well the tracker saw the people, in one drive."""

    lasted: float = 0.0
    """Robot seconds of the drive."""
    false_people: Count = 0
    """Tracks that for most of their time had nobody within 0.6 m."""
    in_view: float = 0.0
    """Person seconds: in the laser's view, after 0.6 m of walking in it."""
    missed: float = 0.0
    """Of these, without a track within 0.5 m."""


class Drive(Message):
    """One drive."""

    what: What
    state: str
    failure: Failure | None = None
    lasted: float
    """Robot seconds from the goal to its end."""
    near: float
    """Robot seconds within 1.0 m of a person, from axis to axis."""
    nearest: float
    """Metres between the axes of the robot and the nearest person, at least."""
    touches: tuple[Touch, ...] = ()
    seen: Seen = Seen()

    @property
    def caused(self) -> tuple[Touch, ...]:
        """The contacts while the robot moved, or had stood for less than a second."""
        return tuple(each for each in self.touches if each.stood < 1.0)


class CrossingRun(Message):
    """One drawn drive, in its variants."""

    run: int
    people: Count
    drives: tuple[Drive, ...]

    def of(self, what: What) -> Drive | None:
        """Return a variant, if it was driven."""
        return next((each for each in self.drives if each.what == what), None)

    @property
    def reached(self) -> bool:
        """Whether the robot got there among the people, and is to blame for no contact."""
        drive = self.of("crossing")
        return drive is not None and drive.state == "SUCCEEDED" and not drive.caused


class CrossingExperiment(Message):
    """All runs: what ``--report`` writes."""

    options: CrossingOptions
    runs: tuple[CrossingRun, ...]
