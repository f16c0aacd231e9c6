"""One run of a skill that sees: waits that hear cancel, pause and the hardware's stop."""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import TypeAlias

from tandem.skills.ports.actions.perception import LookFeedback
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import StopState
from tandem.skills.ports.keys import Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.skill import Command, Slice

Steps: TypeAlias = Generator[LookFeedback | Slice, Command, bool]
"""A part of a run; returns whether what it waited for came true."""


class Canceled(Exception):  # noqa: N818 - no error: the wish of the client
    """The goal was cancelled."""


class LookError(Exception):
    """The goal failed; the skill adds where."""

    def __init__(self, kind: FailureKind, message: str, **evidence: str | float | bool) -> None:
        super().__init__(message)
        self.failure = Failure(kind=kind, message=message, evidence=dict(evidence))


class Session:
    """What one run knows of itself: what was seen, and whether it is held up.

    Args:
        clocks: robot time.
        stop: the hardware's stop.
    """

    def __init__(self, clocks: Clocks, stop: Latest[StopState]) -> None:
        self.clocks = clocks
        self.refresh: Callable[[], None] = _nothing
        """Reads the run's inboxes; called at each resumption."""
        self.pictures = 0
        self.seen: tuple[int, ...] = ()
        self.paused = False
        self.on_pause: Callable[[], None] = _nothing
        """Called once when the client pauses the run."""
        self._stop = stop

    @property
    def now(self) -> float:
        """Robot seconds."""
        return robot_seconds(self.clocks)

    @property
    def stamp(self) -> RobotTime:
        """The moment that it is: what is seen is later or earlier than this.

        Raises:
            LookError: HARDWARE_LOST when the hardware has not been heard.
        """
        now = self.clocks.robot()
        if now is None:
            raise LookError(FailureKind.HARDWARE_LOST, "the hardware's clock has not been heard")
        return now

    def breathe(self, slice_of: float | None = None) -> Generator[LookFeedback | Slice, Command, None]:
        """Yield once; then read the inboxes and heed the command.

        Args:
            slice_of: robot seconds charged for a slice of a computation that goes on as soon as it can.

        Raises:
            Canceled: when the client wishes so.
            LookError: when the hardware's stop is set.
        """
        feedback = LookFeedback(pictures=self.pictures, seen=self.seen)
        command = yield feedback if slice_of is None else Slice(slice_of)
        self.refresh()
        if command is Command.CANCEL:
            raise Canceled
        if command is Command.PAUSE:
            self.paused = True
            self.on_pause()
        elif command is Command.RESUME:
            self.paused = False
        state = self._stop.refresh()
        if state is not None and state.stopped:
            raise LookError(
                FailureKind.HARDWARE_STOPPED, f"stopped by {state.by}: {state.reason}", by=state.by
            )

    def until(self, ready: Callable[[], bool], seconds: float) -> Steps:
        """Wait until ``ready``; return False when it takes longer than ``seconds``. Pauses don't count."""
        end = self.now + seconds
        while self.paused or not ready():
            if self.paused:
                end += yield from self._idle()
            elif self.now >= end:
                return False
            yield from self.breathe()
        return True

    def _idle(self) -> Generator[LookFeedback | Slice, Command, float]:
        """Stay paused; return the seconds that it took."""
        since = self.now
        while self.paused:
            yield from self.breathe()
        return self.now - since


def _nothing() -> None:
    """Do nothing."""
