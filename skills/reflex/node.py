"""The arms crossing control as a node: at the rate of the joints' messages, whatever the trees do."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.actions.bimanual import CROSSING, Crossing
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.keys import JOINT_STATES, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.world import SCENE
from tandem.skills.reflex.watch import ArmsWatch

MOVING_PERIOD: Final = 0.02
"""Robot seconds between two messages while an arm moves."""
RESTING_PERIOD: Final = 1.0
"""Robot seconds between two messages while both stand."""


class CrossingReflex:
    """Tells ``skill/reflex/crossing``; a ``Node``.

    Args:
        bus: where joints are told, and risks.
        watch: looks at the arms.
    """

    name = "reflex/crossing"

    def __init__(self, bus: Bus, watch: ArmsWatch) -> None:
        self._bus, self._watch = bus, watch
        self._joints, self._scene = Latest(bus, JOINT_STATES), Latest(bus, SCENE, depth=4)
        self._looked_at: RobotTime | None = None
        self._told: Crossing | None = None

    def step(self) -> bool:
        """Look at the newest joints, if they are new, and tell when it is time or the verdict has changed."""
        joints, scene = self._joints.refresh(), self._scene.refresh()
        if joints is None or joints.stamp == self._looked_at:
            return False
        self._looked_at = joints.stamp
        seen = self._watch.look(joints, scene)
        message = Crossing(
            stamp=joints.stamp,
            risk=seen.risk,
            distance=seen.distance,
            threshold=seen.threshold,
            clearance=seen.clearance,
            near=seen.near,
        )
        if self._due(message, moving=seen.moving):
            CROSSING.publish(self._bus, message)
            self._told = message
        return False

    def close(self) -> None:
        """End the subscriptions."""
        self._joints.close()
        self._scene.close()

    def _due(self, message: Crossing, *, moving: bool) -> bool:
        told = self._told
        passed = None if told is None else message.stamp.since(told.stamp)
        if told is None or passed is None or (told.risk, told.near) != (message.risk, message.near):
            return True
        return passed >= (MOVING_PERIOD if moving else RESTING_PERIOD) - 1e-6
