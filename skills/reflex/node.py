"""The arms crossing control as a node: at the rate of the joints' messages, whatever the trees do."""

from __future__ import annotations

from operator import sub
from typing import Final

from tandem.skills.ports.actions.bimanual import CROSSING, Crossing
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.world import SCENE, PlanningScene
from tandem.skills.reflex.crossing_watch import STILL, ArmsWatch, Seen

MOVING_PERIOD: Final = 0.02
"""Robot seconds between two messages while an arm moves."""
SAME: Final = 1e-4
"""rad or m within which joints stand where they stood: 0.1 mm of a hand, of 3 cm that arms keep apart."""
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
        self._seen: Seen | None = None
        self._seen_in: tuple[JointStates, PlanningScene | None] | None = None

    def step(self) -> bool:
        """Look at the newest joints, if they are new, and tell when it is time or the verdict has changed."""
        joints, scene = self._joints.refresh(), self._scene.refresh()
        if joints is None or joints.stamp == self._looked_at:
            return False
        self._looked_at = joints.stamp
        if self._seen is None or not self._same(joints, scene):
            self._seen, self._seen_in = self._watch.look(joints, scene), (joints, scene)
        seen = self._seen
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

    def _same(self, joints: JointStates, scene: PlanningScene | None) -> bool:
        """Say whether the arms stand as they stood when they were looked at, with the same in their hands."""
        if self._seen_in is None or self._seen_in[1] is not scene:
            return False
        before = self._seen_in[0]
        return (
            before.names == joints.names
            and max(map(abs, joints.velocities), default=0.0) < STILL
            and max(map(abs, map(sub, joints.positions, before.positions)), default=0.0) < SAME
        )

    def _due(self, message: Crossing, *, moving: bool) -> bool:
        told = self._told
        passed = None if told is None else message.stamp.since(told.stamp)
        if told is None or passed is None or (told.risk, told.near) != (message.risk, message.near):
            return True
        return passed >= (MOVING_PERIOD if moving else RESTING_PERIOD) - 1e-6
