"""Have both hands do one thing with what is between them: two-arm thesis, 4.1.2, eq. 4.2."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from tandem.skills.geometry.poses import add
from tandem.skills.ports.actions.bimanual import (
    TWO_HANDS,
    TwoHands,
    TwoHandsFeedback,
    TwoHandsGoal,
    TwoHandsResult,
)
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.pose import Pose
from tandem.trees.behaviours.act import Act, accept
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard

BothHands = Act[TwoHandsGoal, TwoHandsFeedback, TwoHandsResult]
RISE: Final = 0.10
"""Metres by which it is lifted."""
LEVEL: Final = 0.0524
"""Radians (3 degrees) that it may be tilted while it is held."""


@dataclass(eq=False)
class BothBoard:
    """An item for both hands: where it stood, and whether they have it."""

    left: HandBoard
    right: HandBoard
    stood_at: Pose | None = None
    """Its centre in the map when the hands closed in."""
    between: bool = False
    """Whether it is between the hands."""

    @property
    def hands(self) -> tuple[HandBoard, HandBoard]:
        """Left and right."""
        return self.left, self.right


def squeeze(context: TreeContext, board: BothBoard) -> BothHands:
    """Return the leaf: close in until both wrists feel the thing."""

    def goal() -> TwoHandsGoal | Failure:
        stands = board.left.standing(context)
        if isinstance(stands, Failure):
            return stands
        board.stood_at = stands
        return TwoHandsGoal(do=TwoHands.SQUEEZE, item=board.left.item)

    def judge(_: TwoHandsResult) -> Failure | None:
        board.between = True
        return None

    return _act("squeeze", context, goal, judge)


def lift_together(context: TreeContext, board: BothBoard) -> BothHands:
    """Return the leaf: straight up, the hands as one; FAILURE when it is not level then."""

    def judge(result: TwoHandsResult) -> Failure | None:
        if abs(result.tilt) <= LEVEL:
            return None
        return Failure(
            kind=FailureKind.TILTED,
            message=f"{context.called(board.left.item)} is tilted by {result.tilt:.3f} rad between the hands",
            evidence={"tilt_rad": round(result.tilt, 4), "most_rad": LEVEL},
        )

    return _move("lift together", context, board, RISE, judge)


def put_down_together(what: str, context: TreeContext, board: BothBoard) -> BothHands:
    """Return the leaf: to where it stood."""
    return _move(what, context, board, 0.0, accept)


def let_go_together(what: str, context: TreeContext, board: BothBoard) -> BothHands:
    """Return the leaf: both hands draw back at once."""

    def judge(_: TwoHandsResult) -> Failure | None:
        board.between = False
        return None

    return _act(what, context, lambda: TwoHandsGoal(do=TwoHands.RELEASE, item=board.left.item), judge)


def _move(
    what: str,
    context: TreeContext,
    board: BothBoard,
    rise: float,
    judge: Callable[[TwoHandsResult], Failure | None],
) -> BothHands:
    def goal() -> TwoHandsGoal | Failure:
        stood = board.stood_at
        if stood is None:
            return Failure(kind=FailureKind.INVALID_GOAL, message="nothing is between the hands")
        to = Pose(position=add(stood.position, (0.0, 0.0, rise)), orientation=stood.orientation)
        return TwoHandsGoal(do=TwoHands.MOVE, item=board.left.item, to=to, touch_support=True)

    return _act(what, context, goal, judge)


def _act(
    what: str,
    context: TreeContext,
    goal: Callable[[], TwoHandsGoal | Failure],
    judge: Callable[[TwoHandsResult], Failure | None],
) -> BothHands:
    return Act(
        f"both hands: {what}", context, TWO_HANDS, goal, resources=("arm_left", "arm_right"), judge=judge
    )
