"""Whether an arm may move: the order that the coordination has for its side (two-arm thesis, Algorithm 3)."""

from __future__ import annotations

from tandem.skills.ports.actions.bimanual import ORDER_LOST_AFTER, RIGHT_OF_WAY, ArmOrder, Order
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import HandName


class Gate:
    """Reads one side's order. Without coordination, or without a side, it is GO.

    Args:
        bus: where the coordination is.
        clocks: robot time.
        side: the hand's; None for a group without one.
    """

    def __init__(self, bus: Bus, clocks: Clocks, side: HandName | None) -> None:
        self._clocks, self._side = clocks, side
        self._orders = None if side is None else Latest(bus, RIGHT_OF_WAY)

    def order(self) -> ArmOrder | None:
        """Return what the arm must do instead of going on, or None when it may go on.

        An open episode of which nothing is heard any more means HOLD.
        """
        said = None if self._orders is None else self._orders.refresh()
        now = self._clocks.robot()
        if said is None or self._side is None or now is None:
            return None
        age, mine = now.since(said.stamp), said.of(self._side)
        if age is None:
            return None
        if said.open and age > ORDER_LOST_AFTER:
            return ArmOrder(side=self._side, order=Order.HOLD)
        return None if mine is None or mine.order is Order.GO else mine

    def gives_up(self) -> bool:
        """Whether the arm is told to come to rest and fail: both were stopped, and nobody coordinates."""
        order = self.order()
        return order is not None and order.order is Order.STOP

    def close(self) -> None:
        """End the subscription."""
        if self._orders is not None:
            self._orders.close()
