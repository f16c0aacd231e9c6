"""What every part of an approach does: wait for the next period, come to rest, follow a planned motion.

Each of these ends early with what has interrupted it: a command, an order of the coordination, a failure.
"""

from __future__ import annotations

from collections.abc import Generator
from enum import StrEnum
from typing import Final

from tandem.skills.arm.field.approach_context import Parts
from tandem.skills.arm.field.ends import gone
from tandem.skills.arm.field.reference import Stepper, along, with_headroom
from tandem.skills.arm.field.setpoint_guard import PLANNED, Guard
from tandem.skills.arm.field.setpoints import PERIOD, STRAY, Motion
from tandem.skills.arm.field.target import Target
from tandem.skills.arm.trajectory import Trajectory
from tandem.skills.ports.actions.approach import ApproachFeedback, ApproachGoal, ApproachPhase
from tandem.skills.ports.actions.bimanual import ArmOrder
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.skill import Command, Slice

LEFT: Final = 0.03
"""Metres that the item may move while a planned motion is followed."""
HALTING: Final = 100
"""Periods for which the hardware's own rest is waited for."""
HEARD_AFTER: Final = 2
"""Periods after which what the hardware says of its rest is from after the end of the stream."""


class Why(StrEnum):
    """Why something has ended."""

    DONE = "DONE"
    STUCK = "STUCK"
    COMMAND = "COMMAND"
    ORDER = "ORDER"
    FAILED = "FAILED"


Steps = Generator[ApproachFeedback | Slice, Command, Why]


class Ride:
    """One approach's motion and what it has heard.

    Args:
        parts: of the arm.
        goal: what is approached.
    """

    def __init__(self, parts: Parts, goal: ApproachGoal) -> None:
        self.parts, self._item = parts, goal.item
        live, arm = parts.live, parts.arm
        live.hand_width = goal.hand_width
        parts.tracker.begin(goal)
        self.limits = arm.motion_limits.scaled(goal.speed)
        self.guard = Guard(live.proximity, arm.limits, live.columns, live.other_links)
        self.motion = Motion(parts, self.guard, Stepper(self.limits, PERIOD))
        self.target: Target | None = None
        self.command = Command.GO_ON
        self.failure: Failure | None = None
        self.distance = 0.0
        """Metres from the hand to its proximity pose."""
        self.goal_positions: tuple[float, ...] = ()
        """The joints' where it will end, as things are; none before that is known."""
        self.at = 0
        """The sample at which the arm stands or to which it goes back."""

    def next(self, phase: ApproachPhase) -> Generator[ApproachFeedback | Slice, Command, int]:
        """Wait for the next period; return how many have passed, with all that came taken in.

        When the process was too late, so that the hardware has braked by itself, this waits until the arm
        stands, and begins anew from there: set-points from before would pull it back.
        """
        while True:
            goal = None if self.target is None else self.target.item.position
            self.parts.teller.tell(
                phase, self.distance, goal, self.goal_positions, record=self.motion.record, at=self.at
            )
            self.hear((yield self.feedback(phase)))
            periods = self.motion.ticks()
            if not periods:
                continue
            self.refresh()
            live = self.parts.live
            if self.motion.dried and not (live.silent or live.stopped):
                if not self.motion.quiet:
                    continue
                self.motion.begin()
                return 1
            return periods

    def refresh(self) -> None:
        """Take in what has come."""
        self.parts.live.refresh()
        self.target = self.parts.tracker.refresh()

    def hear(self, command: Command) -> None:
        """Keep the command that holds: a cancel stands, a pause until it is resumed."""
        if self.command is not Command.CANCEL and command is not Command.GO_ON:
            self.command = Command.GO_ON if command is Command.RESUME else command

    def feedback(self, phase: ApproachPhase) -> ApproachFeedback:
        """Return what clients are told."""
        return ApproachFeedback(phase=phase, distance=round(self.distance, 4))

    def rest(self, phase: ApproachPhase, *, obeying: bool = False) -> Steps:
        """Brake until the arm stands, as measured; then tell what has interrupted it meanwhile."""
        while True:
            periods = yield from self.next(phase)
            if self.motion.brake(periods) or self.parts.live.silent or self.parts.live.stopped:
                return self.interrupted(obeying=obeying) or Why.DONE

    def halt(self) -> Generator[ApproachFeedback | Slice, Command, None]:
        """Send nothing more, and wait until the hardware says that it is at rest, and takes motions again."""
        if not self.motion.streaming:
            return
        self.motion.release()
        for number in range(HALTING):
            yield from self.next(ApproachPhase.STOPPING)
            if self.parts.live.silent or (number >= HEARD_AFTER and self.parts.live.at_rest):
                return

    def follow(
        self, trajectory: Trajectory, phase: ApproachPhase, target: Target | None, order: ArmOrder | None
    ) -> Steps:
        """Follow a checked motion from rest to rest, as long as it is free.

        With a target, until that has moved (DONE: the field takes over); with an order, until there is
        another one. STUCK when it is not free, or when the arm has left it because the process was late.
        """
        trajectory = with_headroom(trajectory, self.parts.arm.motion_limits)
        at, parts, begun = 0.0, self.parts, self.motion.begun
        while at < trajectory.duration or not self.motion.state.still:
            at += PERIOD * (yield from self.next(phase))
            why = self.interrupted(obeying=order is not None)
            if why is not None:
                return why
            if self.motion.begun != begun:
                return Why.STUCK
            if target is not None and self.target is not None and self.target.moved(target)[0] > LEFT:
                return Why.DONE
            if order is not None and parts.gate.order() != order:
                return Why.ORDER
            there = along(trajectory, at, PERIOD)
            self.motion.go_to(there, PLANNED, recorded=order is None)
            if self.motion.blocked:
                return Why.STUCK
        return Why.DONE

    def interrupted(self, *, obeying: bool = False) -> Why | None:
        """Return what must be seen to before anything else. ``obeying``: an order is being seen to."""
        if self.failure is not None or self._broken():
            return Why.FAILED
        if self.command is not Command.GO_ON:
            return Why.COMMAND
        if self.target is None:
            self.failure = gone(self.parts.where, self._item)
            return Why.FAILED
        return Why.ORDER if not obeying and self.parts.gate.order() is not None else None

    def fail(self, kind: FailureKind, message: str, **evidence: str | float | bool) -> Why:
        """Note a failure."""
        self.failure = Failure(kind=kind, message=message, where=self.parts.where, evidence=evidence)
        return Why.FAILED

    def _broken(self) -> bool:
        """Say whether the hardware doesn't do what it is told; noted as the failure."""
        live = self.parts.live
        if live.stopped:
            self.fail(FailureKind.HARDWARE_STOPPED, "the hardware's stop is set")
        else:
            stray, number = self.motion.stray
            joint = self.parts.arm.group.joints[number]
            if stray > STRAY:
                self.parts.doubt.note(joint)
                self.fail(
                    FailureKind.ARM_STOPPED, f"{joint} strayed by {stray:.3f}", joint=joint, error_rad=stray
                )
        return self.failure is not None
