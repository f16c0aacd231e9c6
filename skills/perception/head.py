"""Moves the head from rest to rest, and knows when it is there."""

from __future__ import annotations

import logging
import math
from collections.abc import Generator
from typing import Final

from pydantic import ValidationError

from tandem.skills.perception.aim import HEAD
from tandem.skills.perception.camera_frames import JointHistory
from tandem.skills.perception.ramp import rest_to_rest
from tandem.skills.perception.session import LookError, Session
from tandem.skills.ports.actions.perception import LookFeedback
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.failure import FailureKind
from tandem.skills.ports.hardware import CancelMotion, GroupStatus, MotionState, TrajectoryGoal
from tandem.skills.ports.keys import Latest, group_cancel, group_goal, group_status
from tandem.skills.ports.robot_description import JointGroup
from tandem.skills.ports.skill import Command, Slice

SETTLE: Final = 0.05
"""Robot seconds between the head's rest and the picture: what still swings, settles."""
REST_AFTER: Final = 3.0
"""Robot seconds for the head to come to rest after a cancel."""
_NEAR: Final = 0.003
"""Radians: nearer than this, the head need not move."""
_ANSWER: Final = 1.0
"""Robot seconds for the hardware to answer a goal."""
_OVERTIME: Final = 2.0
"""Robot seconds beyond the trajectory's own for the head to be at rest."""
SHORT: Final = 0.05
"""Radians (3 degrees) by which a head may rest beside its aim and is there all the same: a twentieth of what
a picture spans. A camera that touched its own tower was held up 0.4 rad short."""

_LOG = logging.getLogger(__name__)

Steps = Generator[LookFeedback | Slice, Command, None]


class Head:
    """The head of one run of a skill that looks.

    Args:
        bus: where the hardware is.
        group: the head's joints and limits.
        goal_id: of the run; each motion gets a number behind it.
    """

    def __init__(self, bus: Bus, group: JointGroup, goal_id: str) -> None:
        self._bus, self._group, self._goal_id = bus, group, goal_id
        self._status: Latest[GroupStatus] = Latest(bus, group_status(HEAD))
        self._sent = 0
        self.short = 0.0
        """Radians by which the last motion ended short of its aim, if by more than ``SHORT``; else 0.0."""
        self._moving = ""
        self._interrupted = False

    def refresh(self) -> None:
        """Read the inbox."""
        status = self._status.refresh()
        ended = (
            status is not None and status.goal_id == self._moving and status.state is not MotionState.ACTIVE
        )
        if ended and status is not None and status.at_rest:
            self._moving = ""

    @property
    def at_rest(self) -> bool:
        """Whether no motion of ours is under way."""
        return not self._moving

    def move(
        self, session: Session, joints: JointHistory, end: tuple[float, ...], meanwhile: Steps | None = None
    ) -> Steps:
        """Go to the end positions (rad) and come to rest there. A motion that strayed counts as over.

        Where the camera is, is measured; so a head that stops short spoils the view and not the poses;
        ``short`` tells by how much. A pause halts the head; afterwards it goes on to where it was going.

        Args:
            session: of the run.
            joints: where the head is.
            end: one position for each joint of the head.
            meanwhile: is done once while the head moves, and before this returns.

        Raises:
            LookError: when the hardware refuses, or the head does not come to rest.
        """
        session.on_pause = self._interrupt
        self.short = 0.0
        while True:
            self._interrupted = False
            newest = joints.newest
            assert newest is not None
            start = newest.position_of(self._group.joints)
            if all(math.isclose(a, b, abs_tol=_NEAR) for a, b in zip(start, end, strict=True)):
                yield from meanwhile or ()
                return
            yield from self._go(session, start, end, meanwhile)
            meanwhile = None
            if not self._interrupted:
                self._note_miss(joints, end)
                return

    def _note_miss(self, joints: JointHistory, end: tuple[float, ...]) -> None:
        newest = joints.newest
        assert newest is not None
        reached = newest.position_of(self._group.joints)
        misses = [abs(a - b) for a, b in zip(reached, end, strict=True)]
        miss = max(misses)
        if miss > SHORT:
            self.short = miss
            joint = self._group.joints[misses.index(miss)]
            _LOG.warning("the head stopped short", extra={"joint": joint, "rad": round(miss, 3)})

    def _interrupt(self) -> None:
        self._interrupted = True
        self.halt()

    def _go(
        self, session: Session, start: tuple[float, ...], end: tuple[float, ...], meanwhile: Steps | None
    ) -> Steps:
        points = rest_to_rest(start, end, self._group.limits)
        self._sent += 1
        goal = TrajectoryGoal(id=f"{self._goal_id}/head{self._sent}", points=points)
        # From here on the hardware may have it, whatever becomes of the answer.
        self._moving = goal.id
        service = group_goal(HEAD)
        pending = service.query(self._bus, goal)
        yield from session.until(lambda: pending.poll() is not None or pending.done(), _ANSWER)
        refused = self._refusal(pending)
        if refused is not None:
            self._moving = ""
            raise LookError(FailureKind.NOT_READY, f"the head's goal was not taken: {refused}")
        yield from meanwhile or ()
        if not (yield from session.until(lambda: self.at_rest, points[-1].time + _OVERTIME)):
            raise LookError(FailureKind.TIMED_OUT, "the head did not come to rest", goal=goal.id)

    def come_to_rest(self, session: Session) -> Steps:
        """Stop our motion and wait for its end; a second cancel changes nothing."""
        self.halt()
        end = session.now + REST_AFTER
        while not self.at_rest and session.now < end:
            yield LookFeedback(pictures=session.pictures, seen=session.seen)
            self.refresh()

    def halt(self) -> None:
        """Ask the hardware to stop our motion, if there is one; ``at_rest`` tells when it has."""
        if self._moving:
            group_cancel(HEAD).query(self._bus, CancelMotion(id=self._moving))

    def close(self) -> None:
        """End the subscription; what moves is stopped."""
        self.halt()
        self._status.close()

    def _refusal(self, pending: Pending) -> str | None:
        payload = pending.poll()
        if payload is None:
            return "no answer"
        try:
            answer = group_goal(HEAD).decode_answer(payload)
        except ValidationError:
            return "an answer that is none"
        return None if answer.accepted else answer.reason
