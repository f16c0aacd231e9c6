"""How paths are planned: typed, frozen, read in one place."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

from pydantic import Field

from tandem.skills.ports.message import Message

Count = Annotated[int, Field(gt=0, le=1_000_000)]


class PlannerName(StrEnum):
    """The planners of OMPL that can be chosen."""

    RRT_CONNECT = "RRTConnect"
    RRT_STAR = "RRTstar"
    BIT_STAR = "BITstar"
    AORRTC = "AORRTC"

    @property
    def improves(self) -> bool:
        """Whether it goes on improving its path until its checks are used up."""
        return self is not PlannerName.RRT_CONNECT


class PlannerSettings(Message):
    """Bounds are counts of collision checks, never times, so that a seed gives one path."""

    planner: PlannerName = PlannerName.RRT_CONNECT
    longest_edge: Annotated[float, Field(gt=0.0)] = 0.7
    """Metres (weighed) of the tree's edges."""
    checks: Count = 6_000
    """After so many the planner gives up."""
    improving_checks: Count = 6_000
    """After so many a planner that improves its path stops."""
    slice_checks: Count = 50
    """Between two chances to be stopped."""
    shortcut_rounds: Annotated[int, Field(ge=0, le=1_000_000)] = 30
    shortcut_checks: Annotated[int, Field(ge=0, le=1_000_000)] = 600
    shortcut_misses: Count = 8
    """Shortcutting ends when so many in a row brought nothing."""
