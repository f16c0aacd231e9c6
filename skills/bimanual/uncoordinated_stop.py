"""What is done about a risk when nobody coordinates: both arms stop and give up what they were at.

Only when both move: the motion of one was checked against the other where it stands. Once both stand they
may move again; they are stopped anew when the risk has passed and comes back, or when it gets worse.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from tandem.skills.bimanual.coordination import WORSE, Situation
from tandem.skills.ports.actions.bimanual import PAIR, ArmOrder, Order


@dataclass(frozen=True)
class UncoordinatedStop:
    """The state: how often both were stopped, whether they are just now, and how near they were then (m)."""

    episode: int = 0
    stopping: bool = False
    armed: bool = True
    clearance: float = 0.0

    @property
    def orders(self) -> tuple[ArmOrder, ...]:
        """What each arm may do, left first."""
        return tuple(ArmOrder(side=side, order=Order.STOP if self.stopping else Order.GO) for side in PAIR)

    def after(self, seen: Situation) -> UncoordinatedStop:
        """Return the state after what is seen."""
        both, still = seen.left.moving and seen.right.moving, not (seen.left.moving or seen.right.moving)
        if self.stopping:
            return replace(self, stopping=not still, armed=False, clearance=seen.clearance)
        if not seen.risk:
            return self if self.armed else replace(self, armed=True)
        if both and (self.armed or seen.clearance < self.clearance - WORSE):
            return replace(self, episode=self.episode + 1, stopping=True, clearance=seen.clearance)
        return self
