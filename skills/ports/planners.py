"""The planners of an arm by name: what a site file may choose, and what planning runs."""

from __future__ import annotations

from enum import StrEnum


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
