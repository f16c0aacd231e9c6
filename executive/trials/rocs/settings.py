"""What may be chosen of an experiment."""

from __future__ import annotations

from typing import Literal

from tandem.skills.ports.message import Count, Message

Case = Literal[1, 2, 3]
"""EXP1: the Pioneer goes to the origin. EXP2: the SUMMIT-XL does, and stays. EXP3: it follows the Pioneer."""
Route = Literal["both", "deliberative"]
"""Both routes, or the baseline without the reflex."""


class RocsOptions(Message):
    """Of all runs of one experiment."""

    case: Case
    route: Route = "both"
    seed: Count = 1
