"""GRIP: open, close, grasp, and say whether the hand is full.

Full means: the pads stopped before they met, at about the width expected, and press on something. A grasp
that closed all the way is empty. Pads that stand where they were not told to, and press on nothing, are
stuck: they are told again for ``PATIENCE`` before that is a failure. A cancel or a pause stops pads that
move; pads that squeeze go on squeezing.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Final

from tandem.skills.gripper.commands import Order, name_command
from tandem.skills.ports.actions.gripper import Grip, GripFeedback, GripGoal, GripResult, grip
from tandem.skills.ports.bus import Bus, Pending
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import Answer, GripperCommand, GripperMotion, GripperState
from tandem.skills.ports.keys import STOP_STATE, Latest, gripper_command, gripper_state
from tandem.skills.ports.robot_description import EndEffector
from tandem.skills.ports.skill import ActionType, Command, Outcome, Run, canceled, failed, succeeded

WIDTH_TOLERANCE: Final = 0.012
"""Metres by which a held item's width may differ from what was expected (it may be held askew)."""
REACHED: Final = 0.006
"""Metres from the commanded width that count as there."""
EMPTY_BELOW: Final = 0.006
"""Metres: pads that are closed but for this have met."""
HOLDING_FORCE: Final = 0.5
"""Newtons at the least between pads that hold something."""
SETTLE: Final = 0.2
"""Robot seconds at rest before the hand is judged; pads that are opened or closed, and have got there, hold
nothing that could still yield."""
PATIENCE: Final = 5.0
"""Robot seconds for which stuck pads are told again: as long as an arm waits for a joint that it doubts."""
SLOW: Final = 2.5
"""Times the motion's nominal time, and a second, after which a gripper is stuck."""
ANSWER_WITHIN: Final = 2.0
"""Robot seconds for the hardware's answer to a command."""
ASKS: Final = 3
"""How often a command is sent while no answer comes: a process that did not go on for a while misses one."""

Grips = Run[GripFeedback, GripResult]
Waiting = Generator[GripFeedback, Command, Failure | None]


class Gripping:
    """The skill of one gripper.

    Args:
        bus: where the hardware is.
        clocks: robot time.
        hand: which gripper.
    """

    def __init__(self, bus: Bus, clocks: Clocks, hand: EndEffector) -> None:
        self._bus, self._clocks, self._hand = bus, clocks, hand
        self._action = grip(hand.side)
        self._service = gripper_command(hand.side)
        self._state, self._stop = Latest(bus, gripper_state(hand.side)), Latest(bus, STOP_STATE)
        self._command = Command.GO_ON
        self._sent = ""

    @property
    def action(self) -> ActionType[GripGoal, GripFeedback, GripResult]:
        """The contract."""
        return self._action

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.02

    def check(self, goal: GripGoal) -> Failure | None:
        """Refuse widths and forces that the gripper does not have."""
        gripper = self._hand.gripper
        if goal.width > gripper.max_width + WIDTH_TOLERANCE:
            return self._failure(
                FailureKind.INVALID_GOAL, f"at most {gripper.max_width} m wide, not {goal.width}"
            )
        if goal.grip is Grip.GRASP and goal.width <= gripper.min_width + EMPTY_BELOW:
            return self._failure(FailureKind.INVALID_GOAL, "a grasp needs the width of what is grasped")
        if goal.force is not None and goal.force > gripper.force:
            return self._failure(FailureKind.INVALID_GOAL, f"at most {gripper.force} N, not {goal.force}")
        return None

    def run(self, goal: GripGoal, goal_id: str) -> Grips:
        """Move the pads, wait for rest, judge."""
        self._command, self._sent = Command.GO_ON, ""
        resting = False
        try:
            wrong = yield from self._heard()
            if wrong is None and goal.grip is not Grip.CHECK and self._command is not Command.CANCEL:
                wrong = yield from self._move(goal, goal_id)
            if self._command is Command.CANCEL:
                yield from self._hold(goal_id)
                resting = True
                return canceled()
            resting = True
            return failed(wrong) if wrong is not None else self._judge(goal)
        finally:
            if not resting and self._moves():
                self._send(name_command(goal_id, 0, Order.HOLD), self._now().width)

    def _target(self, goal: GripGoal) -> float:
        if goal.grip is Grip.OPEN:
            return min(goal.width or self._hand.gripper.max_width, self._hand.gripper.max_width)
        return self._hand.gripper.min_width

    def _heard(self) -> Waiting:
        until = robot_seconds(self._clocks) + ANSWER_WITHIN
        while self._state.refresh() is None:
            if robot_seconds(self._clocks) > until:
                return self._failure(FailureKind.NOT_READY, "the gripper's state was not heard")
            self._look((yield GripFeedback(width=0.0, force=0.0)))
            if self._command is Command.CANCEL:
                return None
        return None

    def _move(self, goal: GripGoal, goal_id: str) -> Waiting:
        """Command the width and wait until the pads are at rest there or before; a pause comes in between."""
        order = Order.OPEN if goal.grip is Grip.OPEN else Order.CLOSE
        number, until = 0, robot_seconds(self._clocks) + PATIENCE
        while True:
            wrong = yield from self._go(goal, name_command(goal_id, number, order))
            if wrong is not None or self._command is Command.CANCEL:
                return wrong
            if self._command is Command.PAUSE:
                if self._moves():
                    yield from self._hold(goal_id, number)
                    number += 1
                if (yield from self._paused()):
                    return None
            elif self._stuck(goal) and robot_seconds(self._clocks) < until:
                number += 1
            else:
                return None

    def _paused(self) -> Generator[GripFeedback, Command, bool]:
        """Wait until the goal is resumed; True when it was cancelled instead."""
        while self._command is Command.PAUSE:
            self._look((yield self._feedback()))
        return self._command is Command.CANCEL

    def _go(self, goal: GripGoal, command_id: str) -> Waiting:
        """Move until the pads are at rest, or a command comes in between."""
        start, width = self._now().width, self._target(goal)
        refused = yield from self._answered(lambda: self._send(command_id, width, goal.force))
        if refused is not None or self._command is not Command.GO_ON:
            return refused
        began = robot_seconds(self._clocks)
        late = began + SLOW * abs(width - start) / self._hand.gripper.speed + 1.0
        rest_since: float | None = None
        while True:
            now, state = robot_seconds(self._clocks), self._now()
            done = state.command_id == command_id and state.motion is not GripperMotion.MOVING
            rest_since = (now if rest_since is None else rest_since) if done else None
            there = state.motion is GripperMotion.AT_WIDTH and goal.grip is not Grip.GRASP
            if rest_since is not None and (there or now - rest_since >= SETTLE):
                return None
            if now > late:
                return self._failure(
                    FailureKind.GRIPPER_STUCK,
                    f"still {state.motion} after {now - began:.1f} s",
                    width_m=state.width,
                    commanded_m=width,
                    force_n=state.force,
                )
            if self._look((yield self._feedback())):
                return None

    def _answered(self, send: Callable[[], Pending]) -> Waiting:
        """Send until it is answered; to do the same command again changes nothing."""
        asks, pending, until = 1, send(), robot_seconds(self._clocks) + ANSWER_WITHIN
        while (payload := pending.poll()) is None:
            if pending.done() or robot_seconds(self._clocks) > until:
                if asks == ASKS:
                    return self._failure(FailureKind.HARDWARE_LOST, "the gripper did not answer")
                asks, pending, until = asks + 1, send(), robot_seconds(self._clocks) + ANSWER_WITHIN
            if self._look((yield self._feedback())):
                return None
        answer: Answer = self._service.decode_answer(payload)
        if answer.accepted:
            return None
        stop = self._stop.refresh()
        stopped = stop is not None and stop.stopped
        kind = FailureKind.HARDWARE_STOPPED if stopped else FailureKind.NOT_READY
        return self._failure(kind, f"the gripper refused: {answer.reason}")

    def _moves(self) -> bool:
        """Whether the pads are under way, as far as is known, by a command of this run."""
        state = self._state.value
        if state is None or not self._sent:
            return False
        return state.command_id != self._sent or state.motion is GripperMotion.MOVING

    def _hold(self, goal_id: str, number: int = 0) -> Generator[GripFeedback, Command, None]:
        """Stop where the pads are, and wait for rest; pads at rest squeeze on."""
        if not self._moves():
            return
        hold = name_command(goal_id, number, Order.HOLD)
        self._send(hold, self._now().width)
        until = robot_seconds(self._clocks) + ANSWER_WITHIN
        while robot_seconds(self._clocks) < until:
            state = self._now()
            if state.command_id == hold and state.motion is not GripperMotion.MOVING:
                return
            self._look((yield self._feedback()))

    def _judge(self, goal: GripGoal) -> Outcome[GripResult]:
        state = self._now()
        at_width = self._at_width(state, goal)
        pressed = state.force >= HOLDING_FORCE
        full = not self._met(state) and pressed and (at_width or goal.width == 0.0)
        result = GripResult(width=state.width, force=state.force, full=full)
        evidence = {"width_m": state.width, "force_n": state.force, "expected_m": goal.width}
        if self._stuck(goal):
            text = (
                "did not open all the way"
                if goal.grip is Grip.OPEN
                else "stopped before it closed, and presses on nothing"
            )
            return failed(self._failure(FailureKind.GRIPPER_STUCK, text, **evidence))
        if goal.grip is Grip.GRASP and not full:
            text = "the pads met" if self._met(state) else "what is between the pads is no such item"
            return failed(self._failure(FailureKind.GRASP_EMPTY, text, **evidence))
        if goal.grip is Grip.CLOSE and not self._met(state):
            return failed(self._failure(FailureKind.GRIPPER_STUCK, "did not close all the way", **evidence))
        if goal.grip in {Grip.OPEN, Grip.CLOSE}:
            result = result.model_copy(update={"full": False})
        return succeeded(result)

    def _stuck(self, goal: GripGoal) -> bool:
        """Say whether the pads stand short of open, or apart though nothing that is expected holds them."""
        state = self._now()
        match goal.grip:
            case Grip.OPEN:
                return state.width < self._target(goal) - REACHED
            case Grip.GRASP | Grip.CLOSE:
                at_width = goal.grip is Grip.GRASP and self._at_width(state, goal)
                return not self._met(state) and not at_width and state.force < HOLDING_FORCE
            case Grip.CHECK:
                return False

    def _at_width(self, state: GripperState, goal: GripGoal) -> bool:
        return abs(state.width - goal.width) <= WIDTH_TOLERANCE

    def _met(self, state: GripperState) -> bool:
        return state.width <= self._hand.gripper.min_width + EMPTY_BELOW

    def _send(self, command_id: str, width: float, force: float | None = None) -> Pending:
        gripper, self._sent = self._hand.gripper, command_id
        command = GripperCommand(
            id=command_id, width=max(0.0, width), speed=gripper.speed, force=force or gripper.force
        )
        return self._service.query(self._bus, command)

    def _look(self, command: Command) -> bool:
        """Take a command, of which a cancel stands; True when the pads have to stand."""
        if self._command is not Command.CANCEL and command is not Command.GO_ON:
            self._command = Command.GO_ON if command is Command.RESUME else command
        return self._command is not Command.GO_ON

    def _now(self) -> GripperState:
        state = self._state.refresh()
        assert state is not None  # heard at the start of the run
        return state

    def _feedback(self) -> GripFeedback:
        state = self._now()
        return GripFeedback(width=state.width, force=state.force)

    def _failure(self, kind: FailureKind, message: str, **evidence: str | float) -> Failure:
        return Failure(kind=kind, message=message, where=self._action.name, evidence=dict(evidence))
