"""Recoveries that several parts of a task share, from cheap to dear; ``where`` makes their names unique."""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.pause import Pause
from tandem.trees.behaviours.recovery import RecoveryStep
from tandem.trees.behaviours.wait_for import WaitFor
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.localise import localise
from tandem.trees.recovery_kinds import another_way_helps, localising_helps, waiting_helps

WAITS: Final = 4
"""How often what passes by itself is waited for. A process, a sensor and a time-out share these, so one of
each leaves one over; a skill that goes down each time still ends the task."""
BACK_WITHIN: Final = 30.0
"""Seconds, of the robot and of the host, in which a skill that is gone must be back."""
A_MOMENT: Final = 1.0
"""Robot seconds that are waited in any case: what passes by itself takes a while."""
LOCALISES: Final = 2
"""How often the robot looks anew where it is. Whoever hides the map may have gone by the second time; where
that fails too, the place is the cause, and more only put off the failure."""
WAYS: Final = 2
"""How often the distance to a goal is changed (order-picking paper, III-A.4)."""
LET_PASS: Final = 2.0
"""Robot seconds in which whoever stands in the way may leave."""


def wait_back(where: str, context: TreeContext, times: int = WAITS) -> RecoveryStep:
    """Return the recovery "wait until all skills are there": for what passes by itself."""

    def otherwise() -> Failure:
        gone, taken = ", ".join(context.clients.gone()), context.knowledge.base_taken
        if not gone and taken:
            return Failure(kind=FailureKind.OVERRIDDEN, message=f"waits: {taken}")
        return Failure(
            kind=FailureKind.SKILL_LOST,
            message=f"nobody serves {gone}, not even after {BACK_WITHIN:.0f} s",
            evidence={"waited_s": BACK_WITHIN},
        )

    repair = WaitFor(
        f"{where}: all skills are there",
        context,
        lambda: not context.clients.gone(),
        otherwise,
        patience=BACK_WITHIN,
        at_least=A_MOMENT,
        for_a_process=True,
    )
    return RecoveryStep(f"{where}: wait until it is back", waiting_helps, times, repair)


def localise_again(where: str, context: TreeContext, times: int = LOCALISES) -> RecoveryStep:
    """Return the recovery "find out anew where the robot is"."""
    repair = localise(context, f"{where}: localise anew")
    return RecoveryStep(f"{where}: find out where I am", localising_helps, times, repair)


def let_pass(where: str, context: TreeContext, *, seconds: float, times: int) -> RecoveryStep:
    """Return the recovery "wait, and take the same way": for goals that have no other."""
    return RecoveryStep(
        f"{where}: let them pass",
        another_way_helps,
        times,
        Pause(f"{where}: wait for them", context, seconds),
    )


def another_way(where: str, context: TreeContext, board: FetchBoard, times: int = WAYS) -> RecoveryStep:
    """Return the recovery "wait, then change the distance to the goal" (order-picking paper, III-A.4).

    What failed is not tried again, so the survey offers stands at other distances and angles.
    """

    def decide() -> str:
        board.avoid.extend(board.stands)
        return f"{len(board.avoid)} base poses are not tried again"

    repair = Sequence(
        f"{where}: change the distance",
        memory=True,
        children=[
            Pause(f"{where}: wait for them", context, LET_PASS),
            Note(f"{where}: avoid these stands", decide),
        ],
    )
    return RecoveryStep(f"{where}: another way", another_way_helps, times, repair)


def a_moment(where: str, context: TreeContext) -> Behaviour:
    """Return a repair that does nothing but wait a moment: what failed is just tried again."""
    return Pause(f"{where}: a moment", context, A_MOMENT)
