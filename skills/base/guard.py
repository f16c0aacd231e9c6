"""Whether the base may move now, and if not, why not."""

from __future__ import annotations

from typing import Final

from tandem.skills.base.whereabouts import Whereabouts
from tandem.skills.ports.actions.arm import ArmState, ArmStatus, arm_status
from tandem.skills.ports.actions.base import ARM_MARGIN
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import BUMPERS, STOP_STATE, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.robot_description import RobotDescription

SILENCE: Final = 0.5
"""Robot seconds without odometry after which the base does not move."""
ARM_SILENCE: Final = 2.0
"""Robot seconds without a word from an arm after which the base does not move."""
AT_EASE: Final = frozenset({ArmState.ARM_IDLE, ArmState.ARM_SUCCESS})
"""States of an arm that stands still, as it was told to."""


class Guard:
    """Looks at stop, odometry, the sensor of the pose, localisation and arms.

    Args:
        bus: where the arms and the stop tell their state.
        clocks: robot time.
        description: which groups are arms, and the footprint.
        localiser: who hears odometry, and the sensor by which the robot knows where it is.
    """

    def __init__(
        self, bus: Bus, clocks: Clocks, description: RobotDescription, localiser: Whereabouts
    ) -> None:
        self._clocks, self._localiser = clocks, localiser
        self._extent = description.footprint_radius + ARM_MARGIN
        self._stop = Latest(bus, STOP_STATE)
        self._bumpers = Latest(bus, BUMPERS)
        names = dict.fromkeys(hand.group for hand in description.end_effectors)
        self._arms = {name: Latest(bus, arm_status(name)) for name in names}

    def refusal(self, where: str, *, anywhere: bool = False) -> Failure | None:
        """Return the first reason not to move, or None; ``anywhere``: where the base is need not be known."""
        stop = self._stop.refresh()
        arms = {name: latest.refresh() for name, latest in self._arms.items()}
        now = self._clocks.robot()
        if now is None:
            return Failure(kind=FailureKind.NOT_READY, message="the hardware has not been heard", where=where)
        if stop is not None and stop.stopped:
            return Failure(
                kind=FailureKind.HARDWARE_STOPPED,
                message="the hardware's stop is set",
                where=where,
                evidence={"by": stop.by, "reason": stop.reason},
            )
        found = self._senses(now, where, anywhere=anywhere)
        for name, status in arms.items():
            if found is not None:
                return found
            silent = None if status is None else now.since(status.stamp)
            if status is None or silent is None:
                found = Failure(
                    kind=FailureKind.NOT_READY, message=f"{name} has not told its state", where=where
                )
                continue
            if status.state not in AT_EASE or status.extent > self._extent or silent > ARM_SILENCE:
                found = Failure(
                    kind=FailureKind.BASE_HELD,
                    message=self._holds(name, status, silent),
                    where=where,
                    evidence={
                        "arm": name,
                        "state": status.state.value,
                        "extent_m": status.extent,
                        "allowed_m": self._extent,
                        "silent_s": silent,
                    },
                )
        return found

    def _holds(self, name: str, status: ArmStatus, silent: float) -> str:
        """Return what about an arm holds the base, in words."""
        if status.state not in AT_EASE:
            return f"{name} is at work ({status.state}): the base drives when it rests"
        if status.extent > self._extent:
            reach = f"{name} reaches {status.extent:.2f} m out"
            return f"{reach}: the base drives with {self._extent:.2f} m at most"
        return f"{name} has told nothing for {silent:.1f} s"

    @property
    def touching(self) -> tuple[str, ...]:
        """The bumpers that are pressed."""
        told = self._bumpers.refresh()
        return () if told is None else told.pressed

    @property
    def reach(self) -> float:
        """Metres from the base's axis to the farthest point of an arm, as last heard; 0 without arms."""
        told = [latest.refresh() for latest in self._arms.values()]
        return max((status.extent for status in told if status is not None), default=0.0)

    def close(self) -> None:
        """End the subscriptions."""
        self._stop.close()
        self._bumpers.close()
        for latest in self._arms.values():
            latest.close()

    def _senses(self, now: RobotTime, where: str, *, anywhere: bool) -> Failure | None:
        odometry = self._localiser.odometry
        silent = None if odometry is None else now.since(odometry.stamp)
        if silent is None:
            return Failure(kind=FailureKind.NOT_READY, message="no odometry has been heard", where=where)
        if silent > SILENCE:
            return Failure(
                kind=FailureKind.HARDWARE_LOST,
                message=f"no odometry for {silent:.1f} s",
                where=where,
                evidence={"silent_s": silent},
            )
        blind = self._localiser.silence(now, where)
        if blind is not None:
            return blind
        if not (anywhere or self._localiser.localised):
            return Failure(kind=FailureKind.NOT_LOCALISED, message=self._localiser.reason, where=where)
        return None
