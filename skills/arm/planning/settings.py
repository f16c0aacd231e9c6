"""How paths are planned: typed, frozen, read in one place."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from tandem.skills.arm.optimising.settings import ChompSettings, StompSettings
from tandem.skills.ports.message import Message
from tandem.skills.ports.planners import PlannerName

Count = Annotated[int, Field(gt=0, le=1_000_000)]


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
    field: bool = False
    """Check states in a distance field; takes numba (extra ``fast``), and 120 MB more in the process."""
    slice_checks: Count = 50
    """Between two chances to be stopped."""
    shortcut_rounds: Annotated[int, Field(ge=0, le=1_000_000)] = 30
    shortcut_checks: Annotated[int, Field(ge=0, le=1_000_000)] = 600
    shortcut_misses: Count = 8
    """Shortcutting ends when so many in a row brought nothing."""
    stomp: StompSettings = StompSettings()
    chomp: ChompSettings = ChompSettings()
