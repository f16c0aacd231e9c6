"""What the base does, told to everybody, and which skill has the wheels now."""

from __future__ import annotations

import math
from typing import Final

from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.actions.base import BASE_STATUS, BaseState, BaseStatus
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds

PERIOD: Final = 0.5
"""Robot seconds between two messages without a change."""


class BaseStatusBoard:
    """The one owner of ``skill/base/state``; skills take the wheels' pipeline through it; a ``Node``."""

    def __init__(self, bus: Bus, clocks: Clocks, pipeline: Pipeline) -> None:
        self._bus, self._clocks, self.pipeline = bus, clocks, pipeline
        self._published_at = -math.inf
        self._state = BaseState.BASE_IDLE
        self._serves_item: int | None = None
        self.anywhere = False
        """Whether whoever has the wheels may move without knowing where the base is."""

    @property
    def holder(self) -> str:
        """The skill that has the wheels; empty: none."""
        return self.pipeline.holder

    @property
    def name(self) -> str:
        """The node's name."""
        return "base/status"

    def claim(self, skill: str, serves_item: int | None = None, *, anywhere: bool = False) -> bool:
        """Take the wheels for a skill; False when another one, or a reflex, has them.

        ``anywhere``: it may move without knowing where the base is.
        """
        if not self.pipeline.claim(skill):
            return False
        self.anywhere = anywhere
        self._set(BaseState.BASE_TO_GOAL, serves_item)
        return True

    def release(self, skill: str, state: BaseState) -> None:
        """Give the wheels back and say how it ended."""
        self.pipeline.release(skill)
        self._set(state, self._serves_item)

    def step(self) -> bool:
        """Publish when it is time."""
        now = robot_seconds(self._clocks)
        if now - self._published_at >= PERIOD - 1e-6:
            self._publish()
        return False

    def close(self) -> None:
        """Nothing to leave."""

    def _set(self, state: BaseState, serves_item: int | None) -> None:
        self._state, self._serves_item = state, serves_item
        self._publish()

    def _publish(self) -> None:
        stamp = self._clocks.robot()
        if stamp is None:
            return
        self._published_at = robot_seconds(self._clocks)
        BASE_STATUS.publish(
            self._bus, BaseStatus(stamp=stamp, state=self._state, serves_item=self._serves_item)
        )
