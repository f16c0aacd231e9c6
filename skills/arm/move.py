"""MOVE: bring a group to joint positions, a named posture, or the hand to a pose, through free space only.

Nothing moves before the whole motion was checked against the newest planning scene. A paused move stops,
and plans anew from where it stands when it goes on. So does one whose side must hold or step back by the
coordination's order: it goes on when it may.
"""

from __future__ import annotations

import zlib
from collections.abc import Generator
from typing import Final

import numpy as np

from tandem.skills.arm.doubt import STEP_ENDS, STUCK_AFTER, Doubt, small_step
from tandem.skills.arm.followed import FollowedItem
from tandem.skills.arm.hand_way import hand_way
from tandem.skills.arm.motion import Ended, GroupDriver
from tandem.skills.arm.motion_watch import MotionWatch
from tandem.skills.arm.plan_move import MovePlanner, Steps
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Moment, Plan
from tandem.skills.arm.pushed import PushedBase
from tandem.skills.arm.right_of_way import Gate
from tandem.skills.arm.slices import BREATH, UNIT_COST, due
from tandem.skills.arm.status import ArmStatusBoard
from tandem.skills.geometry.poses import distance
from tandem.skills.ports.actions.arm import ArmState, MoveFeedback, MoveGoal, MovePhase, MoveResult, move
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import GroupStatus, MotionState
from tandem.skills.ports.keys import JOINT_STATES, Latest
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.skill import ActionType, Command, Outcome, Run, Slice, canceled, failed, succeeded
from tandem.skills.ports.world import ROBOT_POSE, SCENE, PlanningScene

HEARD_WITHIN: Final = 2.0
"""Robot seconds for which a move waits for joint states, the scene and the robot's pose."""
POSE_TOLERANCE: Final = 0.015
"""Metres between the pose asked for and reached, beyond which the move failed."""
JOINT_TOLERANCE: Final = 0.05
"""Radians (or metres), the same for joints."""

STEPS_AGAIN: Final = frozenset({FailureKind.ARM_STOPPED, FailureKind.PATH_IN_COLLISION})
"""Ends of a small step after which another one is tried: the joint did not follow, or the scene changed."""

Moves = Run[MoveFeedback, MoveResult]


class Move:
    """The skill of moving one group.

    Args:
        bus: the hardware, the world, the clients.
        clocks: robot time.
        arm: the group.
        board: tells what the group does.
        settings: the planner and its bounds.
        seed: with a goal's id, seeds its plan.
        compute: plans what can't be sliced; without one it is done in place.
        doubt: the joint that stayed behind last, shared with the group's other skills.
    """

    def __init__(
        self,
        bus: Bus,
        clocks: Clocks,
        arm: Arm,
        board: ArmStatusBoard,
        settings: PlannerSettings,
        *,
        seed: int = 0,
        compute: Compute | None = None,
        doubt: Doubt | None = None,
    ) -> None:
        self._clocks, self._arm, self._board, self._seed = clocks, arm, board, seed
        self._doubt = Doubt() if doubt is None else doubt
        self._action = move(arm.group.name)
        self._planner = MovePlanner(arm, settings, self._action.name, compute)
        self._driver = GroupDriver(bus, clocks, arm.group, self._action.name)
        self._joints = Latest(bus, JOINT_STATES)
        self._scene, self._pose = Latest(bus, SCENE), Latest(bus, ROBOT_POSE)
        self._gate = Gate(bus, clocks, None if arm.hand is None else arm.hand.side)
        self._followed = FollowedItem(bus, self._action.name)
        self._pushed = PushedBase(self._pose, self._action.name)
        self._way: tuple[Vector3, ...] = ()

    @property
    def action(self) -> ActionType[MoveGoal, MoveFeedback, MoveResult]:
        """The contract."""
        return self._action

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.02

    def check(self, goal: MoveGoal) -> Failure | None:
        """Say why the goal can't be taken: wrong number of joints, unknown posture, a pose without a hand."""
        joints = self._arm.group.joints
        if goal.joints is not None and len(goal.joints) != len(joints):
            return self._failure(
                FailureKind.INVALID_GOAL, f"expected {len(joints)} joints, {len(goal.joints)} given"
            )
        outside = self._outside(goal.joints or ())
        if outside:
            return self._failure(FailureKind.INVALID_GOAL, outside)
        if goal.posture is not None:
            try:
                self._arm.description.posture(self._arm.group.name, goal.posture)
            except KeyError as error:
                return self._failure(FailureKind.INVALID_GOAL, str(error.args[0]))
        if (goal.candidates or goal.retreats) and self._arm.hand is None:
            return self._failure(FailureKind.INVALID_GOAL, f"{self._arm.group.name} has no hand: joints only")
        if self._driver.stopped:
            return self._failure(FailureKind.HARDWARE_STOPPED, "the hardware's stop is set")
        return None

    def _outside(self, positions: tuple[float, ...]) -> str:
        """Return in words which position is outside its joint's limits, or nothing."""
        for limit, value in zip(self._arm.group.limits, positions, strict=False):
            if not limit.lower <= value <= limit.upper:
                span = f"{limit.lower:.3f} to {limit.upper:.3f}"
                return f"{limit.joint}: expected {span}, {value:.3f} given"
        return ""

    def run(self, goal: MoveGoal, goal_id: str) -> Moves:
        """Plan, check, move, verify."""
        self._board.show(ArmState.ARM_RUNNING)
        state = ArmState.ARM_FAIL
        try:
            outcome = yield from self._attempts(goal, goal_id)
            if outcome.canceled:
                state = ArmState.ARM_IDLE
            elif outcome.result is not None:
                state = ArmState.ARM_SUCCESS
            return outcome
        finally:
            if self._driver.moving:
                self._driver.stop()
                self._driver.moving = False
            self._board.show(state)

    def _attempts(self, goal: MoveGoal, goal_id: str) -> Moves:
        steps, number = 0, 0
        began = robot_seconds(self._clocks)
        while True:
            self._way = ()
            if (yield from self._held()):
                return canceled()
            moment = yield from self._listen(goal)
            if moment is None or isinstance(moment, Failure):
                return canceled() if moment is None else failed(moment)
            self._followed.begin(goal)
            self._pushed.begin(goal, moment.base_in_map)
            rng = np.random.default_rng([self._seed, zlib.crc32(goal_id.encode()), number])
            planned, slices, command = yield from self._sliced(self._next(goal, moment, rng))
            steps += slices
            if command is Command.CANCEL:
                return canceled()
            if isinstance(planned, Failure):
                return failed(planned)
            if isinstance(planned, Plan):
                motion_id = f"{goal_id}#{number}"
                outcome, command = yield from self._execute(goal, motion_id, moment, planned, steps)
                outcome = self._after_step(outcome, began) if planned.proves else outcome
                if outcome is not None:
                    return outcome
            number += 1
            if command is Command.PAUSE and (yield from self._paused()):
                return canceled()

    def _listen(self, goal: MoveGoal) -> Generator[MoveFeedback | Slice, Command, Moment | Failure | None]:
        """Return what is believed now, None when cancelled."""
        until = robot_seconds(self._clocks) + HEARD_WITHIN
        while True:
            joints, scene, pose = self._joints.refresh(), self._scene.refresh(), self._pose.refresh()
            missing = [
                name
                for name, value in (("joint states", joints), ("planning scene", scene), ("robot pose", pose))
                if value is None
            ]
            if joints is not None and scene is not None and pose is not None:
                if not pose.localised and (lost := _needs_the_map(goal, scene)):
                    return self._failure(FailureKind.NOT_LOCALISED, lost)
                return Moment(joints, scene, pose.base_in_map)
            if robot_seconds(self._clocks) > until:
                return self._failure(FailureKind.NOT_READY, f"not heard: {', '.join(missing)}")
            if (yield self._feedback(MovePhase.PLANNING)) is Command.CANCEL:
                return None

    def _sliced(
        self, steps: Steps
    ) -> Generator[MoveFeedback | Slice, Command, tuple[Plan | Failure | None, int, Command]]:
        """Run a computation in slices; ends early with the command that stops it."""
        units, slices = 0, 0
        while True:
            before = units
            try:
                units += next(steps)
            except StopIteration as stop:
                return stop.value, slices, Command.GO_ON
            if units == before:  # a worker is waited for
                command = yield self._feedback(MovePhase.PLANNING)
                if command in {Command.CANCEL, Command.PAUSE}:
                    return None, slices, command
            slice_ = due(units, units - before)
            if slice_ is not None:
                command = yield slice_
                if slice_ is not BREATH:
                    units, slices = 0, slices + 1
                if command in {Command.CANCEL, Command.PAUSE}:
                    return None, slices, command

    def _next(self, goal: MoveGoal, moment: Moment, rng: np.random.Generator) -> Steps:
        """Plan what to do now: the small step of a joint in doubt, else the goal's own motion."""
        if self._doubt.joint:
            step = yield from small_step(self._planner, self._arm, goal, moment, self._doubt)
            if step is not None:
                return step
        return (yield from self._planner.plan(goal, moment, rng))

    def _after_step(self, outcome: Outcome[MoveResult] | None, began: float) -> Outcome[MoveResult] | None:
        """Return how the move ends after a joint's small step; None: it goes on."""
        if outcome is None:
            return None
        if outcome.result is not None:
            self._doubt.settle()
            return None
        seconds = robot_seconds(self._clocks) - began
        if outcome.failure is None or outcome.failure.kind not in STEPS_AGAIN:
            return outcome
        if seconds <= STUCK_AFTER:
            return None
        message = f"{self._doubt.joint} has not followed a small step for {seconds:.1f} s"
        return failed(outcome.failure.model_copy(update={"message": message}))

    def _execute(  # noqa: PLR0911 - one way out for each way a motion can end
        self, goal: MoveGoal, motion_id: str, moment: Moment, plan: Plan, steps: int
    ) -> Generator[MoveFeedback | Slice, Command, tuple[Outcome[MoveResult] | None, Command]]:
        """Move along the plan; without an outcome it was paused or held, and has to be planned again."""
        changed, command = yield from self._against_newest(goal, moment, plan)
        if command is Command.CANCEL:
            return canceled(), command
        changed = changed or self._followed.moved() or self._pushed.moved()
        if changed is not None and command is not Command.PAUSE:
            return failed(changed), command
        if command is Command.PAUSE or self._gate.order() is not None:
            return None, command
        if len(plan.trajectory.times) == 1:
            return self._verify(plan, steps, 0.0), command
        self._way = self._way_of(plan)
        watch = MotionWatch(self._planner, self._scene, goal, moment, plan)
        began = robot_seconds(self._clocks)
        refused, command = yield from self._send(motion_id, plan)
        if refused is not None:
            return canceled() if command is Command.CANCEL else failed(refused), command
        ended, command, held = yield from self._watch(command, watch)
        self._note_doubt(ended.status, plan)
        if command is Command.CANCEL:
            return canceled(), command
        if ended.failure is not None:
            return failed(ended.failure), command
        if held:
            return None, command
        return self._verify(plan, steps, robot_seconds(self._clocks) - began), command

    def _note_doubt(self, status: GroupStatus | None, plan: Plan) -> None:
        """Note the joint that stayed behind its motion, and on which side of where it should be."""
        joints, heard = self._arm.group.joints, self._joints.refresh()
        if status is None or heard is None or status.state is not MotionState.ABORTED:
            return
        if status.joint not in joints:  # stopped by an operator, say
            return
        at = plan.trajectory.sample(np.array([self._driver.elapsed]))[0]
        column = joints.index(status.joint)
        self._doubt.note(status.joint, float(at[column]) - heard.position_of((status.joint,))[0])

    def _send(
        self, motion_id: str, plan: Plan
    ) -> Generator[MoveFeedback | Slice, Command, tuple[Failure | None, Command]]:
        """Hand the motion over; commands that come meanwhile are kept."""
        command = Command.GO_ON
        arrives = STEP_ENDS if plan.proves else None
        sending = self._driver.send(motion_id, plan.trajectory, arrives)
        while True:
            try:
                next(sending)
            except StopIteration as stop:
                refused: Failure | None = stop.value
                return refused, command
            command = _graver(command, (yield self._feedback(MovePhase.MOVING)))

    def _against_newest(
        self, goal: MoveGoal, moment: Moment, plan: Plan
    ) -> Generator[MoveFeedback | Slice, Command, tuple[Failure | None, Command]]:
        """Check the motion again if the scene has changed meanwhile; ends early with a command."""
        scene = self._scene.refresh()
        if scene is None or scene.version == moment.scene.version:
            return None, Command.GO_ON
        newest = Moment(moment.joints, scene, moment.base_in_map)
        recheck = self._planner.recheck(plan.trajectory, goal, newest)
        while True:
            try:
                units = next(recheck)
            except StopIteration as stop:
                found: Failure | None = stop.value
                return found, Command.GO_ON
            command = yield Slice(units * UNIT_COST)
            if command in {Command.CANCEL, Command.PAUSE}:
                return None, command

    def _watch(
        self, command: Command, watch: MotionWatch
    ) -> Generator[MoveFeedback | Slice, Command, tuple[Ended, Command, bool]]:
        """Wait for the end, and say whether an order or a pause has brought it about.

        A cancel, a pause, an order, an obstacle, an item that has moved or a pushed base stop the hardware;
        its rest is awaited. Who is resumed before that has stopped short all the same.
        """
        stopping = held = False
        wrong: Failure | None = None
        while True:
            wrong = wrong or watch.found or self._followed.moved() or self._pushed.moved()
            held = held or command is Command.PAUSE or self._gate.order() is not None
            if (command is Command.CANCEL or held or wrong is not None) and not stopping:
                self._driver.stop()
                stopping = True
            ended = self._driver.poll()
            if ended is not None:
                return Ended(ended.status, wrong or ended.failure), command, held
            units = 0 if stopping else watch.look(self._driver.elapsed)
            if units:
                command = _graver(command, (yield Slice(units * UNIT_COST)))
                continue
            phase = MovePhase.STOPPING if stopping else MovePhase.MOVING
            command = _graver(command, (yield self._feedback(phase)))

    def _held(self) -> Generator[MoveFeedback | Slice, Command, bool]:
        """Wait until the coordination lets the group go on; True when it was cancelled instead."""
        command = Command.GO_ON
        while self._gate.order() is not None or command is Command.PAUSE:
            command = _graver(command, (yield self._feedback(MovePhase.STOPPING)))
            if command is Command.CANCEL:
                return True
        return False

    def _paused(self) -> Generator[MoveFeedback | Slice, Command, bool]:
        """Wait for RESUME; True when it was cancelled instead."""
        while True:
            command = yield self._feedback(MovePhase.STOPPING)
            if command in {Command.RESUME, Command.CANCEL}:
                return command is Command.CANCEL

    def _verify(self, plan: Plan, steps: int, duration: float) -> Outcome[MoveResult]:
        joints = self._joints.refresh()
        assert joints is not None  # heard before planning
        reached = joints.position_of(self._arm.group.joints)
        target, hand = plan.target_in_base, self._arm.hand
        if target is not None and hand is not None:
            positions = dict(zip(joints.names, joints.positions, strict=True))
            error = distance(self._arm.hulls.robot.pose(hand.frame, positions), target)
            allowed, unit = POSE_TOLERANCE, "error_m"
        else:
            error = float(np.max(np.abs(np.array(reached) - plan.trajectory.positions[-1])))
            allowed, unit = JOINT_TOLERANCE, "error_rad"
        if error > allowed:
            return failed(
                self._failure(
                    FailureKind.ARM_OFF_GOAL, f"{error:.3f} off, {allowed} are allowed", **{unit: error}
                )
            )
        return succeeded(
            MoveResult(
                candidate=plan.candidate,
                positions=reached,
                error=error,
                planning_steps=steps,
                duration=duration,
                turned=plan.turned,
            )
        )

    def _way_of(self, plan: Plan) -> tuple[Vector3, ...]:
        joints = self._joints.refresh()
        assert joints is not None  # heard before planning
        return hand_way(self._arm, dict(zip(joints.names, joints.positions, strict=True)), plan.trajectory)

    def _feedback(self, phase: MovePhase) -> MoveFeedback:
        if phase is MovePhase.PLANNING:
            return MoveFeedback(phase=phase, progress=0.0)
        return MoveFeedback(phase=phase, progress=self._driver.progress, way=self._way)

    def _failure(self, kind: FailureKind, message: str, **evidence: str | float | bool) -> Failure:
        return Failure(kind=kind, message=message, where=self._action.name, evidence=evidence)


def _graver(before: Command, now: Command) -> Command:
    """Return which command holds: a cancel stands; a pause stands until it is resumed or cancelled."""
    if before is Command.CANCEL or now is Command.GO_ON:
        return before
    return now


def _needs_the_map(goal: MoveGoal, scene: PlanningScene) -> str:
    """Say for what a motion needs to know where the robot is; nothing when it does not."""
    if goal.candidates and goal.frame == "map":
        return "a pose in the map needs the robot's own"
    around = [each for each in scene.objects if each.attached_to is None]
    if around or scene.occupied is not None:
        return "where the robot is is not known, nor therefore where from it things stand"
    return ""
