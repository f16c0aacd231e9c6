"""What may be chosen of the fetches, and what comes out of them."""

from __future__ import annotations

from enum import StrEnum

from tandem.skills.ports.failure import Failure
from tandem.skills.ports.message import Count, Message
from tandem.skills.ports.pose import FloorPose


class Phase(StrEnum):
    """What the robot is about, in the order-picking paper's order (III-A, Fig. 3)."""

    REQUEST = "request"
    SEARCH = "search"
    APPROACH = "approach"
    PICK = "pick"
    CARRY = "carry"
    PLACE = "place"
    HOME = "home"
    RECOVERY = "recovery"


class PickingOptions(Message):
    """Of all runs."""

    scenario: str = "Locobot"
    seed: Count = 1
    arm_fails: bool = False
    """The hand is stuck from the first motion of the arm on, until all is tried that needs no way home."""


class Stretch(Message):
    """A node of the tree that worked: seconds from the request on."""

    node: str
    """Its name."""
    phase: Phase
    begin: float
    end: float
    ended_well: bool


class Point(Message):
    """Where the robot truly was, seconds from the request on."""

    at: float
    x: float
    y: float
    yaw: float


class PickingRun(Message):
    """One fetch. ``right``: the task succeeded, and nothing is ``wrong`` in truth."""

    run: int
    item: int
    place: FloorPose
    """Where the item stood, and its heading."""
    state: str
    wrong: tuple[str, ...]
    failure: Failure | None
    lasted: float
    """Robot seconds from the request to its end."""
    phases: dict[Phase, float]
    """Robot seconds of each phase. They add up to ``lasted``."""
    stretches: tuple[Stretch, ...]
    path: tuple[Point, ...]

    @property
    def right(self) -> bool:
        """Whether it did what it was asked, and nothing else."""
        return self.state == "SUCCEEDED" and not self.wrong


class PickingExperiment(Message):
    """All runs: what ``--report`` writes."""

    options: PickingOptions
    runs: tuple[PickingRun, ...]
