"""What a group does and how far it reaches out, told to everyone: the base waits for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from tandem.skills.arm.problem import Arm
from tandem.skills.kinematics.bodies import Carried
from tandem.skills.kinematics.described import by_name, carried
from tandem.skills.kinematics.extent import Extent
from tandem.skills.ports.actions.arm import ArmState, ArmStatus, arm_status
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES, Latest
from tandem.skills.ports.world import SCENE

PERIOD: Final = 0.1
"""Robot seconds between two messages while the extent changes."""
SAME_PERIOD: Final = 0.5
"""Robot seconds between two messages without a change: a quarter of what the base calls silence."""
REACHED: Final = 0.005
"""Metres by which the extent has changed when it is told: less than the base allows for."""
SAME: Final = 1e-4
"""rad or m within which joints stand where they stood."""
SHOWN: Final = 0.3
"""Robot seconds for which success or failure is shown before the group is idle again."""


@dataclass(frozen=True)
class _Reach:
    """An extent in metres, and what it was reckoned from."""

    positions: tuple[float, ...]
    held: tuple[Carried, ...]
    metres: float


class ArmStatusBoard:
    """Publishes the group's state; a ``Node``. The skill sets it.

    Args:
        bus: where the base and the trees are.
        clocks: robot time.
        arm: the group.
    """

    def __init__(self, bus: Bus, clocks: Clocks, arm: Arm) -> None:
        self._bus, self._clocks, self._arm = bus, clocks, arm
        self._topic = arm_status(arm.group.name)
        self._joints, self._scene = Latest(bus, JOINT_STATES), Latest(bus, SCENE)
        self._extent = Extent(arm.hulls, arm.group.joints)
        self._known: _Reach | None = None
        self.state = ArmState.ARM_IDLE
        self._told: ArmState | None = None
        self._told_at, self._since, self._told_reach = float("-inf"), float("-inf"), 0.0

    @property
    def name(self) -> str:
        """The group's name."""
        return f"{self._arm.group.name}/state"

    def show(self, state: ArmState) -> None:
        """Set the state; told in the next step."""
        self.state = state
        self._since = robot_seconds(self._clocks)

    def step(self) -> bool:
        """Tell, if there is something new or it is time."""
        joints, scene = self._joints.refresh(), self._scene.refresh()
        stamp, now = self._clocks.robot(), robot_seconds(self._clocks)
        if stamp is None or joints is None:
            return False
        ended = self.state in {ArmState.ARM_SUCCESS, ArmState.ARM_FAIL}
        if ended and now - self._since >= SHOWN:
            self.state = ArmState.ARM_IDLE
        if self.state is self._told and now - self._told_at < PERIOD - 1e-6:
            return False
        held = () if scene is None else carried(scene, self._arm.description)
        mine = () if self._arm.hand is None else tuple(h for h in held if h.link == self._arm.hand.frame)
        reach = self._reached(joints, mine)
        news = self.state is not self._told or abs(reach - self._told_reach) > REACHED
        if not news and now - self._told_at < SAME_PERIOD - 1e-6:
            return False
        self._topic.publish(
            self._bus, ArmStatus(stamp=stamp, group=self._arm.group.name, state=self.state, extent=reach)
        )
        self._told, self._told_at, self._told_reach = self.state, now, reach
        return False

    def _reached(self, joints: JointStates, held: tuple[Carried, ...]) -> float:
        """Return the group's extent in metres; reckoned anew when something has moved."""
        known = self._known
        if known is not None and known.held == held and _same(known.positions, joints.positions):
            return known.metres
        metres = self._extent.metres(by_name(joints.names, joints.positions), held)
        self._known = _Reach(joints.positions, held, metres)
        return metres

    def close(self) -> None:
        """End the subscriptions."""
        self._joints.close()
        self._scene.close()


def _same(before: tuple[float, ...], now: tuple[float, ...]) -> bool:
    return len(before) == len(now) and all(abs(a - b) < SAME for a, b in zip(before, now, strict=True))
