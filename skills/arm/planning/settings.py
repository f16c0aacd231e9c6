"""How paths are planned: typed, frozen, read in one place."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

from pydantic import Field

from tandem.skills.arm.optimising.settings import ChompSettings, StompSettings
from tandem.skills.ports.message import Message

Count = Annotated[int, Field(gt=0, le=1_000_000)]


class PlannerName(StrEnum):
    """The planners that can be chosen: those of OMPL, and STOMP and CHOMP, alone or seeded by RRT*."""

    RRT_CONNECT = "RRTConnect"
    RRT_STAR = "RRTstar"
    BIT_STAR = "BITstar"
    AORRTC = "AORRTC"
    STOMP = "STOMP"
    CHOMP = "CHOMP"
    RRT_STAR_STOMP = "RRTstar+STOMP"
    RRT_STAR_CHOMP = "RRTstar+CHOMP"

    @property
    def improves(self) -> bool:
        """Whether it goes on improving its path until its checks are used up."""
        return self is not PlannerName.RRT_CONNECT

    @property
    def optimises(self) -> bool:
        """Whether it makes a smooth path of many points, to be driven as a curve."""
        return self.is_stomp or self in {PlannerName.CHOMP, PlannerName.RRT_STAR_CHOMP}

    @property
    def is_stomp(self) -> bool:
        """Whether the path is optimised by STOMP."""
        return self in {PlannerName.STOMP, PlannerName.RRT_STAR_STOMP}

    @property
    def seeded(self) -> bool:
        """Whether RRT* finds the path that is optimised; else it begins as the straight line."""
        return self in {PlannerName.RRT_STAR_STOMP, PlannerName.RRT_STAR_CHOMP}


class PlannerSettings(Message):
    """Bounds are counts of collision checks, never times, so that a seed gives one path."""

    planner: PlannerName = PlannerName.RRT_CONNECT
    longest_edge: Annotated[float, Field(gt=0.0)] = 0.7
    """Metres (weighed) of the tree's edges."""
    checks: Count = 6_000
    """After so many the planner gives up."""
    improving_checks: Count = 6_000
    """After so many BIT* and AORRTC, which improve their path, stop."""
    star_checks: Count = 60_000
    """After so many RRT* gives up."""
    star_after: Count = 3_000
    """For so many it improves the first path it has found."""
    star_edge: Annotated[float, Field(gt=0.0)] = 0.35
    """Metres (weighed) of its edges: with one tree, longer ones seldom get out of a narrow place."""
    slice_checks: Count = 50
    """Between two chances to be stopped."""
    shortcut_rounds: Annotated[int, Field(ge=0, le=1_000_000)] = 30
    shortcut_checks: Annotated[int, Field(ge=0, le=1_000_000)] = 600
    shortcut_misses: Count = 8
    """Shortcutting ends when so many in a row brought nothing."""
    stomp: StompSettings = StompSettings()
    chomp: ChompSettings = ChompSettings()
