"""An arm's set-points: made period by period, checked, streamed, recorded."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Final

import numpy as np

from tandem.skills.arm.field.approach_context import Parts
from tandem.skills.arm.field.record import Record
from tandem.skills.arm.field.reference import State, Stepper, standing
from tandem.skills.arm.field.setpoint_guard import Floors, Guard
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.hardware import CancelMotion, SetPoint
from tandem.skills.ports.keys import group_cancel, group_setpoint

PERIOD: Final = 0.01
"""Seconds between two set-points: the hardware's period."""
CATCH_UP: Final = 8
"""Periods at the most that are made up for at once, when the process was late. For so long the hardware goes
on as it was told; soon after, it takes the stream for dried up and brakes."""
LAG: Final = 12
"""Set-points among which the measured positions are looked for: what the arm may be behind."""
STRAY: Final = 0.15
"""Radians from all of those at which the arm is said to be held fast: a trajectory's path tolerance."""
QUIET: Final = 0.02
"""rad/s below which a joint is at rest, as the hardware sees it."""
CLOSE: Final = 0.004
"""Radians from the last set-point within which the arm has come to rest at it."""
MOVING: Final = 1e-7
"""Radians in a period that are no rounding."""
SETTLING: Final = 60
"""Periods that this may take."""

Make = Callable[[State], State]
"""The next state on the way to whatever is wanted."""


class Motion:
    """Streams to one group.

    Args:
        parts: the hardware, the clock, the group and what is around it.
        guard: says what is free.
        stepper: makes states within the limits.
    """

    def __init__(self, parts: Parts, guard: Guard, stepper: Stepper) -> None:
        self._bus, self._clocks, self._live, self._guard = parts.bus, parts.clocks, parts.live, guard
        self.stepper = stepper
        group = parts.arm.group
        self._topic, self._cancel = group_setpoint(group.name), group_cancel(group.name)
        self._sent: deque[Array] = deque(maxlen=LAG)
        self._at: float | None = None
        self._owed = 0
        self.record = Record()
        self.state = standing(np.zeros(len(group.joints)))
        self.blocked = False
        """Whether the last step that was wished for was not free."""
        self.streaming = False
        self.dried = False
        """Whether the process was so late that the hardware brakes by itself: begin anew once that stands."""
        self.begun = 0
        """How often it has begun."""
        self._settling = 0

    def begin(self) -> None:
        """Start from where the arm is measured to stand."""
        self.begun += 1
        self.dried = False
        self.state = standing(self._live.measured()[0])
        self._at, self._owed = robot_seconds(self._clocks), 0
        self._sent.clear()
        self.record.add(self.state.q, 0.0)

    def ticks(self) -> int:
        """Return how many periods have passed since something was sent; 0 within the same period."""
        if self._clocks.robot() is None:
            return 0
        now = robot_seconds(self._clocks)
        if self._at is None:
            self._at = now
            return 1
        passed = int((now - self._at) / PERIOD + 1e-6)
        if passed < 1:
            return 0
        self._at += passed * PERIOD
        self.dried |= self.streaming and passed + self._owed > CATCH_UP
        self._owed = min(passed + self._owed, CATCH_UP)
        return self._owed

    def advance(self, periods: int, make: Make, kept: Floors, *, recorded: bool) -> None:
        """Go on by so many periods as ``make`` says, or brake where that is not free; send the last state."""
        self.blocked = False
        for _ in range(periods):
            self._step(make(self.state), kept, recorded=recorded)
        self._send()

    def go_to(self, state: State, kept: Floors, *, recorded: bool) -> None:
        """Go to the next state of a motion that was made before, or brake where that is not free."""
        self.blocked = False
        # What has just come, or moved, is at an unknown distance until it is looked at.
        self._guard.look(self._live.full(self.state.q))
        self._step(state, kept, recorded=recorded)
        self._send()

    def _step(self, wished: State, kept: Floors, *, recorded: bool) -> None:
        if not self._guard.free(self._live.cases(wished.q), self.stepper.braking(wished), kept):
            self.blocked = True
            wished = self.stepper.brake(self.state)
        moves = bool(np.abs(wished.q - self.state.q).max() > MOVING)
        self.state = wished
        if recorded and moves:
            self.record.add(wished.q, PERIOD)

    def brake(self, periods: int, *, recorded: bool = True) -> bool:
        """Brake for so many periods; return whether the arm stands, as measured."""
        for _ in range(periods):
            self.state = self.stepper.brake(self.state)
            if recorded:
                self.record.add(self.state.q, PERIOD if not self.state.still else 0.0)
        self._send()
        if not self.state.still:
            self._settling = 0
            return False
        self._settling += periods
        near = bool(np.abs(self._live.measured()[0] - self.state.q).max() < CLOSE)
        return self.quiet and (near or self._settling > SETTLING)

    @property
    def quiet(self) -> bool:
        """Whether the arm is measured to be at rest."""
        return bool(np.abs(self._live.measured()[1]).max() < QUIET)

    def _send(self) -> None:
        now = self._clocks.robot()
        assert now is not None  # a period has passed
        self._owed = 0
        self._sent.append(self.state.q)
        self.streaming = True
        setpoint = SetPoint(
            stamp=now, positions=tuple(self.state.q.tolist()), velocities=tuple(self.state.v.tolist())
        )
        self._topic.publish(self._bus, setpoint)

    @property
    def stray(self) -> tuple[float, int]:
        """How far (rad) the arm is from where it may be by now, and which joint is farthest."""
        if not self._sent or not self.streaming:
            return 0.0, 0
        q = self._live.measured()[0]
        gaps = np.abs(np.array(self._sent) - q)
        nearest = gaps[int(np.argmin(gaps.max(axis=1)))]
        return float(nearest.max()), int(np.argmax(nearest))

    def release(self) -> None:
        """End the stream; the hardware holds."""
        if self.streaming:
            self._cancel.query(self._bus, CancelMotion(id=""))
            self.streaming = False
