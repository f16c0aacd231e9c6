"""The skill of telling from where the hand could do something: the base is asked to go only where it helps.

Inverse reachability by trial: for each base pose, the planner's own collision-checked inverse kinematics and
straight lines, in the world as it is believed. Nothing moves.
See docs/decisions/003-survey-before-driving.md.
"""

from __future__ import annotations

import zlib
from collections.abc import Generator
from typing import Final

import numpy as np

from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm, Moment
from tandem.skills.arm.slices import BREATH, UNIT_COST, due
from tandem.skills.ports.actions.arm import MoveGoal, SurveyFeedback, SurveyGoal, SurveyResult, survey
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import JOINT_STATES, Latest
from tandem.skills.ports.skill import ActionType, Command, Run, Slice, canceled, failed, succeeded
from tandem.skills.ports.world import SCENE

HEARD_WITHIN: Final = 2.0
"""Robot seconds in which joint states and scene must have come."""


class Survey:
    """Looks at one base pose after the other.

    Args:
        bus: the hardware and the world.
        clocks: robot time.
        arm: the group; it has a hand.
        settings: the planner's.
        seed: with a goal's id, seeds the search for joint positions.
    """

    def __init__(self, bus: Bus, clocks: Clocks, arm: Arm, settings: PlannerSettings, seed: int = 0) -> None:
        self._clocks, self._arm, self._seed = clocks, arm, seed
        self._action = survey(arm.group.name)
        self._planner = MovePlanner(arm, settings, self._action.name)
        self._joints, self._scene = Latest(bus, JOINT_STATES), Latest(bus, SCENE)

    @property
    def action(self) -> ActionType[SurveyGoal, SurveyFeedback, SurveyResult]:
        """The contract."""
        return self._action

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions."""
        return 0.02

    def check(self, goal: SurveyGoal) -> Failure | None:  # noqa: ARG002 - the goal's model has said it all
        """Take any goal, for an arm with a hand."""
        if self._arm.hand is None:
            return self._failure(FailureKind.INVALID_GOAL, f"{self._arm.group.name} has no hand")
        return None

    def run(self, goal: SurveyGoal, goal_id: str) -> Run[SurveyFeedback, SurveyResult]:
        """Try the bases in order until enough are found."""
        rng = np.random.default_rng([self._seed, zlib.crc32(goal_id.encode())])
        as_move = MoveGoal(
            candidates=goal.candidates,
            touch_item=goal.touch_item,
            touch_support=goal.touch_support,
            hand_width=goal.hand_width,
            turn=goal.turn,
        )
        until = robot_seconds(self._clocks) + HEARD_WITHIN
        while (heard := self._hear()) is None:
            if robot_seconds(self._clocks) > until:
                return failed(
                    self._failure(FailureKind.NOT_READY, "joint states or planning scene not heard")
                )
            if (yield SurveyFeedback(looked_at=0, found=0)) is Command.CANCEL:
                return canceled()
        found: list[int] = []
        for number, base in enumerate(goal.bases):
            moment = Moment(heard.joints, heard.scene, base)
            steps = self._planner.reaches(as_move, moment, rng)
            within = yield from self._sliced(steps, SurveyFeedback(looked_at=number, found=len(found)))
            if within is None:
                return canceled()
            if within:
                found.append(number)
            if len(found) >= goal.enough:
                break
        return succeeded(SurveyResult(bases=tuple(found)))

    def _hear(self) -> Moment | None:
        joints, scene = self._joints.refresh(), self._scene.refresh()
        return None if joints is None or scene is None else Moment(joints, scene, None)

    def _sliced(
        self, steps: Generator[int, None, bool], feedback: SurveyFeedback
    ) -> Generator[SurveyFeedback | Slice, Command, bool | None]:
        """Run one trial in slices; None when it is cancelled."""
        units, reached = 0, None
        while reached is None:
            before = units
            try:
                units += next(steps)
                slice_ = due(units, units - before)
            except StopIteration as stop:
                reached = bool(stop.value)
                slice_ = Slice(units * UNIT_COST)
            if slice_ is None:
                continue
            command = yield slice_
            units = units if slice_ is BREATH else 0
            while command is Command.PAUSE:
                command = yield feedback
                command = Command.PAUSE if command is Command.GO_ON else command
            if command is Command.CANCEL:
                return None
        return reached

    def _failure(self, kind: FailureKind, message: str) -> Failure:
        return Failure(kind=kind, message=message, where=self._action.name)
