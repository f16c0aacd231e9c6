"""Tells everybody what an approach is at."""

from __future__ import annotations

from typing import Final

from tandem.skills.arm.field.record import Record
from tandem.skills.ports.actions.approach import ApproachPhase, ApproachStatus, approach_status
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.message import HandName, Vector3

PERIOD: Final = 0.05
"""Robot seconds between two messages without a change."""


class Teller:
    """Publishes one side's ``ApproachStatus``: 20 Hz while an approach runs, and on each change.

    Args:
        bus: where the other arm and the coordination are.
        clocks: robot time.
        group: the group's name.
        side: its hand's.
    """

    def __init__(self, bus: Bus, clocks: Clocks, group: str, side: HandName) -> None:
        self._bus, self._clocks, self._side = bus, clocks, side
        self._topic = approach_status(group)
        self._told_at = float("-inf")
        self._told: ApproachPhase | None = None

    def tell(
        self,
        phase: ApproachPhase,
        distance: float,
        goal_in_base: Vector3 | None,
        goal_positions: tuple[float, ...],
        *,
        record: Record,
        at: int,
    ) -> None:
        """Tell, if there is something new or it is time."""
        stamp, now = self._clocks.robot(), robot_seconds(self._clocks)
        if stamp is None or (phase is self._told and now - self._told_at < PERIOD - 1e-6):
            return
        self._told, self._told_at = phase, now
        status = ApproachStatus(
            stamp=stamp,
            side=self._side,
            active=True,
            phase=phase,
            distance=distance,
            goal_in_base=goal_in_base,
            goal_positions=goal_positions,
            recorded=record.samples,
            at=at,
        )
        self._topic.publish(self._bus, status)

    def end(self) -> None:
        """Tell that no approach runs any more."""
        now = self._clocks.robot()
        self._told, self._told_at = None, float("-inf")
        if now is not None:
            self._topic.publish(self._bus, ApproachStatus(stamp=now, side=self._side, active=False))
