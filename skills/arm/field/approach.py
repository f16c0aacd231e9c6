"""APPROACH: bring the hand to the proximity pose of an item that may move, by the improved potential field.

The two-arm thesis has the method (2.4, 4.2, 4.3); what is different here, and why, stands in ``potential.py``
(bounded, and not slow near the goal), ``escape.py`` (the choice of a pole), ``velocities.py`` (the whole
arm keeps clear), ``guard.py`` (nothing is sent that is not free) and ``reference.py`` (jerk-limited).
"""

from __future__ import annotations

import zlib

import numpy as np

from tandem.skills.arm.doubt import Doubt
from tandem.skills.arm.field.approach_context import Parts
from tandem.skills.arm.field.episode import Episode
from tandem.skills.arm.field.live import Live
from tandem.skills.arm.field.target import TargetTracker
from tandem.skills.arm.field.teller import Teller
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.settings import PlannerSettings
from tandem.skills.arm.problem import Arm
from tandem.skills.arm.right_of_way import Gate
from tandem.skills.arm.status import ArmStatusBoard
from tandem.skills.ports.actions.approach import ApproachFeedback, ApproachGoal, ApproachResult, approach
from tandem.skills.ports.actions.arm import ArmState
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.compute import Compute
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.keys import STOP_STATE, Latest
from tandem.skills.ports.skill import ActionType, Run


class Approach:
    """The skill of approaching with one arm.

    Args:
        bus: the hardware, the world, the coordination, the other arm.
        clocks: robot time.
        arm: the group; it has a hand.
        board: tells what the group does.
        settings: the planner and its bounds.
        seed: with a goal's id, seeds what is planned.
        compute: plans what can't be sliced; without one it is done in place.
        doubt: takes note of a joint that stays behind; the group's moves ask it to follow first.
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
        hand = arm.hand
        assert hand is not None, "only a group with a hand approaches"
        self._board, self._seed = board, seed
        self._action = approach(arm.group.name)
        self._parts = Parts(
            bus=bus,
            clocks=clocks,
            arm=arm,
            where=self._action.name,
            live=Live(bus, clocks, arm),
            tracker=TargetTracker(bus, clocks),
            planner=MovePlanner(arm, settings, self._action.name, compute),
            gate=Gate(bus, clocks, hand.side),
            teller=Teller(bus, clocks, arm.group.name, hand.side),
            doubt=Doubt() if doubt is None else doubt,
        )
        self._stop = Latest(bus, STOP_STATE)

    @property
    def action(self) -> ActionType[ApproachGoal, ApproachFeedback, ApproachResult]:
        """The contract."""
        return self._action

    @property
    def period(self) -> float:
        """Robot seconds between two resumptions: those of the set-points."""
        return 0.01

    def check(self, goal: ApproachGoal) -> Failure | None:  # noqa: ARG002 - any item may be believed in by then
        """Refuse while the hardware's stop is set."""
        state = self._stop.refresh()
        if state is not None and state.stopped:
            message = "the hardware's stop is set"
            return Failure(kind=FailureKind.HARDWARE_STOPPED, message=message, where=self._action.name)
        return None

    def run(self, goal: ApproachGoal, goal_id: str) -> Run[ApproachFeedback, ApproachResult]:
        """Go down the field until the hand is there, at rest, as measured."""
        self._board.show(ArmState.ARM_RUNNING)
        rng = np.random.default_rng([self._seed, zlib.crc32(goal_id.encode())])
        episode = Episode(self._parts, goal, rng)
        state = ArmState.ARM_FAIL
        try:
            outcome = yield from episode.run()
            if outcome.canceled:
                state = ArmState.ARM_IDLE
            elif outcome.result is not None:
                state = ArmState.ARM_SUCCESS
            return outcome
        finally:
            episode.close()
            self._board.show(state)
