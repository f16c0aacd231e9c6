"""One run of an approach: from what to what it goes."""

from __future__ import annotations

from collections.abc import Generator
from typing import Final

import numpy as np

from tandem.skills.arm.curve import through
from tandem.skills.arm.field.approach_context import Parts
from tandem.skills.arm.field.approach_steps import LEFT, Ride, Steps, Why
from tandem.skills.arm.field.ends import End, Ends
from tandem.skills.arm.field.field_controller import FieldController
from tandem.skills.arm.field.target import HIDDEN_FOR, Target
from tandem.skills.arm.problem import Plan
from tandem.skills.arm.timing import time_curve
from tandem.skills.geometry.poses import distance
from tandem.skills.ports.actions.approach import ApproachFeedback, ApproachGoal, ApproachPhase, ApproachResult
from tandem.skills.ports.actions.bimanual import ArmOrder, Order
from tandem.skills.ports.clocks import robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.skill import Command, Outcome, Run, Slice, canceled, failed, succeeded

HEARD_WITHIN: Final = 2.0
"""Robot seconds for joint states, the scene, the robot's pose and the beliefs."""
PLAN_UNITS: Final = 80
"""Units of planning in one period, while the arm stands: about 2 ms."""
PLANS: Final = 4
"""How often a stuck field is given to the planner before it is said that there is no way."""
LOST_AFTER: Final = 5
"""Choices in a row that may find no grasp while the arm moves, or while the other arm is in the way."""
OFFS: Final = 3
"""How often the measured pose may be off the goal at rest."""

Phase = ApproachPhase
Parting = Generator[ApproachFeedback | Slice, Command, tuple[Why, ApproachResult | None]]


class Episode:
    """One approach.

    Args:
        parts: of the arm.
        goal: what is approached.
        rng: of the planner.
    """

    def __init__(self, parts: Parts, goal: ApproachGoal, rng: np.random.Generator) -> None:
        self._parts, self._goal, self._rng = parts, goal, rng
        self._live, self._ride = parts.live, Ride(parts, goal)
        self._motion = self._ride.motion
        self._controller = FieldController(parts.arm, self._live, self._ride.guard, self._motion, goal.speed)
        self._ends = Ends(parts.arm, parts.planner, self._live, goal)
        self._planned, self._stops, self._offs = 0, 0, 0

    def close(self) -> None:
        """Stop what moves, and tell that it is over."""
        self._motion.release()
        self._parts.teller.end()

    def run(self) -> Run[ApproachFeedback, ApproachResult]:
        """Listen, choose, go down the field until it is there."""
        began = robot_seconds(self._parts.clocks)
        why = yield from self._listen()
        if why is not Why.DONE:
            return self._ended()
        while True:
            if why is Why.DONE:
                why, result = yield from self._onward(began)
                if result is not None:
                    yield from self._ride.halt()
                    return succeeded(result)
            elif why is Why.STUCK:
                why = yield from self._go_planned()
            elif why is Why.ORDER:
                why = yield from self._obey()
            elif why is Why.COMMAND:
                why = yield from self._halted()
                if self._ride.command is Command.CANCEL:
                    yield from self._ride.halt()
                    return canceled()
            else:
                yield from self._give_up()
                return self._ended()

    def _ended(self) -> Outcome[ApproachResult]:
        failure = self._ride.failure
        return canceled() if failure is None or self._ride.command is Command.CANCEL else failed(failure)

    def _listen(self) -> Steps:
        until = robot_seconds(self._parts.clocks) + HEARD_WITHIN
        while True:
            self._ride.refresh()
            missing = self._live.missing or ("" if self._parts.tracker.heard else "the world's state")
            if not missing:
                break
            if robot_seconds(self._parts.clocks) > until:
                return self._ride.fail(FailureKind.NOT_READY, f"not heard: {missing}")
            self._ride.hear((yield self._ride.feedback(Phase.FIELD)))
            if self._ride.command is Command.CANCEL:
                return Why.COMMAND
        until = robot_seconds(self._parts.clocks) + HIDDEN_FOR
        while self._ride.target is None and robot_seconds(self._parts.clocks) < until:
            self._ride.hear((yield self._ride.feedback(Phase.FIELD)))
            if self._ride.command is Command.CANCEL:
                return Why.COMMAND
            self._ride.refresh()
        if not self._parts.tracker.localised:
            message = "an item in the map needs the robot's own pose"
            return self._ride.fail(FailureKind.NOT_LOCALISED, message)
        self._motion.begin()
        return Why.DONE

    def _onward(self, began: float) -> Parting:
        """Choose a grasp if there is none yet, go down the field, and see whether the hand is there."""
        if self._ends.end is None:
            why = yield from self._choose()
            if why is not Why.DONE:
                return why, None
        why = yield from self._seek()
        if why is not Why.DONE:
            return why, None
        return (yield from self._verify(began))

    def _choose(self) -> Steps:
        """Find the first grasp that can be reached, standing."""
        ride = self._ride
        while self._ends.end is None:
            periods = yield from ride.next(Phase.FIELD)
            why = ride.interrupted()
            if why is not None:
                return why
            assert ride.target is not None  # not interrupted
            self._think(ride.target)
            failure = self._ends.failure
            if failure is not None and not (
                self._live.in_the_way(failure) and self._ends.failures < LOST_AFTER
            ):
                ride.failure = failure
                return Why.FAILED
            self._motion.brake(periods)
        return Why.DONE

    def _think(self, target: Target) -> None:
        """Look on for the best end, and have it told."""
        self._ends.think(target, self._motion.state.q)
        self._tell_end()

    def _tell_end(self) -> None:
        end = self._ends.end
        self._ride.goal_positions = () if end is None else tuple(map(float, end.q))

    def _seek(self) -> Steps:
        """Go down the field until the set-points have arrived."""
        self._controller.reset()
        self._ends.failures = 0
        ride, phase, before = self._ride, Phase.FIELD, self._ride.target
        while True:
            periods = yield from ride.next(phase)
            why = ride.interrupted()
            if why is not None:
                return why
            if self._parts.tracker.hidden:  # stand: the hand would hide what is looked for
                self._motion.brake(periods)
                self._controller.reset()
                continue
            target = ride.target
            assert target is not None  # not interrupted
            self._think(target)
            if self._ends.failures >= LOST_AFTER and self._ends.failure is not None:
                ride.failure = self._ends.failure
                return Why.FAILED
            end = self._ends.end
            assert end is not None  # chosen before, and kept until there is a better one
            if before is None or target.moved(before)[0] > LEFT:
                self._controller.reset()
                before = target
            step = self._controller.step(periods, target, end)
            ride.distance, ride.at = step.distance, self._motion.record.samples - 1
            phase = Phase.ESCAPING if step.escaping else Phase.FIELD
            if step.stuck or step.arrived:
                return Why.DONE if step.arrived else Why.STUCK

    def _verify(self, began: float) -> Parting:
        """Wait for rest, and measure where the hand is. Without a result, the field goes on."""
        ride, arm = self._ride, self._parts.arm
        why = yield from ride.rest(Phase.FIELD)
        if why is not Why.DONE:
            return why, None
        target, end, hand = ride.target, self._ends.end, arm.hand
        assert target is not None  # not interrupted
        assert end is not None  # arrived there
        assert hand is not None  # the skill is for groups with one
        q = self._live.measured()[0]
        there = arm.hulls.robot.pose(hand.frame, self._live.moment(q).positions)
        error = ride.distance = distance(there, target.before(end.grasp, end.turn))
        if error <= self._goal.tolerance:
            return why, ApproachResult(
                grasp=end.grasp,
                positions=tuple(map(float, q)),
                error=error,
                turned=end.turn,
                item_in_map=self._parts.tracker.item_in_map,
                duration=robot_seconds(self._parts.clocks) - began,
                escapes=self._controller.escapes,
                planned=self._planned,
                stops=self._stops,
            )
        self._offs += target.moved(end.target)[0] < self._goal.tolerance
        if self._offs >= OFFS:
            message = f"{error:.3f} m off at rest, {self._goal.tolerance} are allowed"
            return ride.fail(FailureKind.ARM_OFF_GOAL, message, error_m=error), None
        self._motion.begin()
        return Why.DONE, None

    def _go_planned(self) -> Steps:
        """Have the planner find a way to the proximity pose, and follow it."""
        self._planned += 1
        ride = self._ride
        why = yield from ride.rest(Phase.PLANNED)
        if why is not Why.DONE:
            return why
        self._motion.begin()
        target = ride.target
        assert target is not None  # not interrupted
        moment = self._live.moment(self._motion.state.q)
        job = self._parts.planner.plan(target.as_move(self._goal), moment, self._rng)
        plan: Plan | Failure | None = None
        while plan is None:
            periods = yield from ride.next(Phase.PLANNED)
            why_not = ride.interrupted()
            if why_not is not None:
                return why_not
            self._motion.brake(periods)
            units = 0
            try:
                while units < PLAN_UNITS:
                    units += next(job) or PLAN_UNITS  # 0: a worker is waited for
            except StopIteration as stop:
                plan = stop.value
        if isinstance(plan, Failure):
            if self._planned < PLANS and self._live.in_the_way(plan):
                return Why.STUCK
            return self._no_way(plan)
        self._ends.take(End(plan.candidate, plan.trajectory.positions[-1], target, plan.turned))
        self._tell_end()
        why = yield from ride.follow(plan.trajectory, Phase.PLANNED, target, None)
        if why is Why.STUCK and self._planned >= PLANS:
            return ride.fail(FailureKind.NO_PATH, "neither the field nor planned motions stay free")
        return why

    def _no_way(self, failure: Failure) -> Why:
        kind = FailureKind.NO_IK if failure.kind is FailureKind.NO_IK else FailureKind.NO_PATH
        why = self._ride.fail(kind, f"the field was stuck, and the planner says: {failure.message}")
        assert self._ride.failure is not None
        update = {"evidence": failure.evidence, "causes": (failure,)}
        self._ride.failure = self._ride.failure.model_copy(update=update)
        return why

    def _obey(self) -> Steps:
        """Stand, or go back along the record, until the coordination lets the arm go on."""
        self._stops += 1
        ride = self._ride
        while True:
            if self._parts.gate.gives_up():
                return ride.fail(FailureKind.ARMS_CROSSING, "both arms were stopped before they met")
            why = yield from ride.rest(Phase.HELD, obeying=True)
            if why is not Why.DONE:
                return why
            order = self._parts.gate.order()
            if order is None:
                self._motion.begin()
                return Why.DONE
            if order.order is Order.BACK and order.sample < ride.at:
                why = yield from self._back(order)
                if why in {Why.COMMAND, Why.FAILED}:
                    return why

    def _back(self, order: ArmOrder) -> Steps:
        ride, record = self._ride, self._motion.record
        self._motion.begin()
        ride.at = max(0, min(order.sample, record.samples - 1))
        way = record.way_back(self._motion.state.q, ride.at)
        why = Why.DONE
        if len(way) > 1:
            trajectory = time_curve(through(way), ride.limits)
            why = yield from ride.follow(trajectory, Phase.BACK, None, order)
        if why is Why.DONE:
            record.cut(ride.at)
        else:
            record.cut_at(self._motion.state.q)
            ride.at = record.samples - 1
        return why

    def _halted(self) -> Steps:
        """Come to rest; if it was a pause, wait for its end, the hardware holding meanwhile."""
        ride = self._ride
        yield from ride.rest(Phase.STOPPING, obeying=True)
        if ride.command is Command.PAUSE:
            self._motion.release()
        while ride.command is Command.PAUSE:
            ride.hear((yield ride.feedback(Phase.STOPPING)))
            ride.refresh()
        self._motion.begin()
        return Why.DONE

    def _give_up(self) -> Generator[ApproachFeedback | Slice, Command, None]:
        """Come to rest before failing; what is held fast, or stops by itself, is not pushed on."""
        failure = self._ride.failure
        assert failure is not None
        untouched = {FailureKind.ARM_STOPPED, FailureKind.HARDWARE_STOPPED, FailureKind.HARDWARE_LOST}
        if failure.kind not in untouched and self._motion.streaming:
            yield from self._ride.rest(Phase.STOPPING, obeying=True)
        yield from self._ride.halt()
