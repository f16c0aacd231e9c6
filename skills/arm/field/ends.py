"""Which grasp the arm goes for, and with which joints: looked for in slices while the arm moves."""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.arm.field.live import Live
from tandem.skills.arm.field.target import Target
from tandem.skills.arm.plan_move import MovePlanner
from tandem.skills.arm.planning.straight import Hand
from tandem.skills.arm.problem import Arm
from tandem.skills.arm.turned import nearest
from tandem.skills.kinematics.transforms import Array
from tandem.skills.ports.actions.approach import ApproachGoal
from tandem.skills.ports.failure import Failure, FailureKind

SAME: Final = (0.0005, 0.002)
"""Metres and radians by which an item may be believed elsewhere before the joints are solved for anew."""
FOLD: Final = 0.6
"""Radians that a joint may go to follow an item; more, and the arm would fold over: it is chosen anew."""
UNITS: Final = 60
"""Units of work in one period: about 1.5 ms."""
AGAIN_AFTER: Final = 20
"""Periods between a choice that found nothing and the next one."""
CLEARANCE: Final = 0.01
"""Metres that the arm must have there, at the least; less, and it is chosen anew."""


@dataclass(frozen=True)
class End:
    """A grasp (its number), the joints (n,) at its proximity pose, and the target they were found for.

    ``turn``: radians by which an arm of few joints has the grasp turned about the item.
    """

    grasp: int
    q: Array
    target: Target
    turn: float = 0.0


class Ends:
    """Keeps the end up to date.

    Args:
        arm: the group.
        planner: says which grasps can be reached.
        live: what is around.
        goal: what is approached.
    """

    def __init__(self, arm: Arm, planner: MovePlanner, live: Live, goal: ApproachGoal) -> None:
        self._arm, self._planner, self._live, self._goal = arm, planner, live, goal
        self._job: Generator[int, None, End | Failure] | None = None
        self.end: End | None = None
        self.failure: Failure | None = None
        """Why there is none, or none any more; None while there is one."""
        self.failures = 0
        """How often in a row nothing was found."""
        self._wait = 0
        self.aside = False
        """Whether the newest end was chosen anew, and not followed from the one before."""

    @property
    def busy(self) -> bool:
        """Whether it is being looked for."""
        return self._job is not None

    def take(self, end: End) -> None:
        """Go for this one from now on: a planner has found it."""
        self.end, self.failure, self._job = end, None, None

    def think(self, target: Target, q: Array) -> None:
        """Do one period's work: begin if the target has moved, and go on. ``q``: where the group is, (n,)."""
        self._wait = max(0, self._wait - 1)
        if self._job is None and self._wait == 0 and self._stale(target):
            self._job = self._look(target, q)
        if self._job is None:
            return
        units = 0
        try:
            while units < UNITS:
                units += max(1, next(self._job))
        except StopIteration as stop:
            self._job = None
            self._take(stop.value)

    def _take(self, found: End | Failure) -> None:
        if isinstance(found, Failure):
            self.failure, self.failures, self._wait = found, self.failures + 1, AGAIN_AFTER
        else:
            self.end, self.failure, self.failures = found, None, 0

    def _stale(self, target: Target) -> bool:
        if self.end is None or self.failure is not None:
            return True
        metres, radians = target.moved(self.end.target)
        return metres > SAME[0] or radians > SAME[1]

    def _look(self, target: Target, q: Array) -> Generator[int, None, End | Failure]:
        before = self.end
        if before is not None:  # if something was in its way: that may have gone
            followed = yield from self._follow(before, target)
            if followed is not None:
                self.aside = False
                return followed
        self.aside = True
        asked = target.as_move(self._goal)
        reached = yield from self._planner.reach(asked, self._live.moment(q))
        if isinstance(reached, Failure) and self._live.in_the_way(reached):
            # Where to go does not depend on who is there now; the guard sees to it that nobody is met.
            reached = yield from self._planner.reach(asked, self._live.moment(q, others_gone=True))
        return (
            reached
            if isinstance(reached, Failure)
            else End(reached.candidate, reached.q, target, reached.turned)
        )

    def _follow(self, before: End, target: Target) -> Generator[int, None, End | None]:
        """Return the joints at the same grasp, from the ones before; None when they would not do."""
        solver, hand = self._arm.solver, self._arm.hand
        assert solver is not None  # the skill is for groups with a hand
        assert hand is not None
        asked, moment = target.as_move(self._goal), self._live.moment(before.q)
        chain = self._arm.hulls.robot.chain(self._arm.group.joints, moment.positions)
        yield UNITS // 2
        found = yield from nearest(
            Hand(solver, hand.frame, chain), asked, moment, asked.candidates[before.grasp], before.q
        )
        if found is None or float(np.abs(found[0] - before.q).max()) > FOLD:
            return None
        q, turn = found
        near = self._live.proximity
        if near.hits(self._live.full(q), np.where(near.of_group, 0.002, CLEARANCE)) is not None:
            return None
        # What could be reached in a straight line from there may not be any more where the item is now.
        turned = target.as_move(self._goal, turn)
        goes_on = yield from self._planner.goes_on(turned, self._live.moment(q), before.grasp, q)
        return End(before.grasp, q, target, turn) if goes_on else None


def gone(where: str, item: int) -> Failure:
    """Return the failure of an item that is not believed to be anywhere, or is in a hand."""
    return Failure(
        kind=FailureKind.ITEM_GONE, message=f"item {item} is not believed to stand anywhere", where=where
    )
