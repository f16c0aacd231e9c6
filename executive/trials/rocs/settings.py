"""What may be chosen of an experiment."""

from __future__ import annotations

from typing import Literal

from tandem.skills.ports.actions.base import FollowSource
from tandem.skills.ports.message import Count, Message

Case = Literal[1, 2, 3]
"""The number of the experiment: ``executive.trials.rocs.run.PLANS`` says what is asked of whom."""
Route = Literal["both", "deliberative", "reactive"]
"""Both routes; or a baseline: without the reflex, or by reflexes alone (EXP1 and EXP2)."""


class RocsOptions(Message):
    """Of all runs of one experiment."""

    case: Case
    route: Route = "both"
    source: FollowSource = FollowSource.SENSOR
    """EXP3: how the follower knows where the other is."""
    seed: Count = 1
