"""The watch over a hand: does it squeeze, and is what it squeezed still there?"""

from __future__ import annotations

from typing import Final

from tandem.skills.gripper.commands import Order, order_of
from tandem.skills.gripper.grip import EMPTY_BELOW, HOLDING_FORCE, WIDTH_TOLERANCE
from tandem.skills.ports.actions.gripper import HandState, HandStatus, hand_status
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import GripperMotion, GripperState
from tandem.skills.ports.keys import Latest, gripper_state
from tandem.skills.ports.message import RobotTimer
from tandem.skills.ports.robot_description import EndEffector

PERIOD: Final = 0.1
"""Robot seconds between two messages while the width or the force changes."""
SAME_PERIOD: Final = 0.5
"""Robot seconds between two messages without a change."""
SAME: Final = (0.0005, 0.5)
"""Metres of width and newtons of force within which nothing has changed."""
SURE_AFTER: Final = 0.1
"""Robot seconds for which a hand must look empty."""
SLACK_AFTER: Final = 0.2
"""Robot seconds for which a hand must press on nothing where its width alone does not tell."""


class HandWatch:
    """Tells what a hand is at; a ``Node``. While the gripper is silent, so is the watch.

    A hand that was told to close is EMPTY once its pads have met, or have left the width at which they
    first stalled by more than an item may turn, or press on nothing though they stalled. One that was told
    to open, or to stand where it is, is OPEN. Pads that move have not decided yet.

    Args:
        bus: where the gripper and the keeper are.
        hand: which gripper.
    """

    def __init__(self, bus: Bus, hand: EndEffector) -> None:
        self._bus, self._side = bus, hand.side
        self._met = hand.gripper.min_width + EMPTY_BELOW
        self._states, self._topic = Latest(bus, gripper_state(hand.side)), hand_status(hand.side)
        self._timer, self._command = RobotTimer(), ""
        self._stalled_at: float | None = None
        self._empty_since: float | None = None
        self._slack_since: float | None = None
        self._told: HandStatus | None = None

    @property
    def name(self) -> str:
        """The hand's name."""
        return f"gripper_{self._side}/state"

    def step(self) -> bool:
        """Judge what the gripper told, and tell it on each change and ten times a second."""
        for state in self._states.take():
            self._tell(state, self._judge(state))
        return False

    def close(self) -> None:
        """End the subscription."""
        self._states.close()

    def _judge(self, state: GripperState) -> HandState:
        told, now = self._told, self._timer.read(state.stamp)
        if state.command_id != self._command or (told is not None and state.stamp.since(told.stamp) is None):
            self._command, self._stalled_at = state.command_id, None
            self._empty_since = self._slack_since = None
        order = order_of(state.command_id)
        stalled = state.motion is GripperMotion.STALLED
        presses = stalled and state.force >= HOLDING_FORCE
        met = state.width <= self._met
        if order in {Order.OPEN, Order.HOLD}:
            return HandState.OPEN
        if presses and self._stalled_at is None:
            self._stalled_at = state.width
        left = self._stalled_at is not None and abs(state.width - self._stalled_at) > WIDTH_TOLERANCE
        slack = order is Order.CLOSE and stalled and not presses
        self._empty_since = _since(self._empty_since, now, holds=met or left)
        self._slack_since = _since(self._slack_since, now, holds=slack)
        empty = _for(self._empty_since, now, SURE_AFTER)
        if empty or _for(self._slack_since, now, SLACK_AFTER):
            return HandState.EMPTY
        return HandState.HOLDING if self._stalled_at is not None else HandState.OPEN

    def _tell(self, state: GripperState, judged: HandState) -> None:
        told, now = self._told, state.stamp
        passed = None if told is None else now.since(told.stamp)
        if told is not None and told.state is judged and passed is not None:
            same = abs(state.width - told.width) < SAME[0] and abs(state.force - told.force) < SAME[1]
            if passed < (SAME_PERIOD if same else PERIOD) - 1e-6:
                return
        self._told = HandStatus(
            stamp=now, side=self._side, state=judged, width=state.width, force=state.force
        )
        self._topic.publish(self._bus, self._told)


def _since(before: float | None, now: float, *, holds: bool) -> float | None:
    if not holds:
        return None
    return now if before is None else before


def _for(since: float | None, now: float, seconds: float) -> bool:
    return since is not None and now - since >= seconds - 1e-6
