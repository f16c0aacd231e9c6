"""What the approaches of one arm share, from one goal to the next."""

from __future__ import annotations

from dataclasses import dataclass

from tandem.skills.arm.doubt import Doubt
from tandem.skills.arm.field.live import Live
from tandem.skills.arm.field.target import TargetTracker
from tandem.skills.arm.field.teller import Teller
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.problem import Arm
from tandem.skills.arm.right_of_way import Gate
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks


@dataclass(frozen=True)
class Parts:
    """What an arm's approaches share."""

    bus: Bus
    clocks: Clocks
    arm: Arm
    where: str
    """The action's name, for failures."""
    live: Live
    tracker: TargetTracker
    planner: MovePlanner
    gate: Gate
    teller: Teller
    doubt: Doubt
