"""Which arm shall it be? The one that reaches the item; of two, the one with the least way."""

from __future__ import annotations

from dataclasses import dataclass

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.trees.behaviours.decide import Decide
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.within_reach import reaches, target_in_base, unreachable, zone_at


@dataclass(eq=False)
class Choice:
    """What was chosen; None before."""

    side: HandName | None = None


def choose_arm(
    name: str,
    context: TreeContext,
    boards: tuple[HandBoard, ...],
    wanted: HandName | None,
    choice: Choice,
) -> Decide:
    """Return the leaf.

    Args:
        name: unique in the tree.
        context: what is known.
        boards: one for each hand, all for the same item.
        wanted: the arm that the request names; None leaves the choice.
        choice: gets the side.
    """

    def decide() -> str | Failure:
        holding = next((board.side for board in boards if board.held(context)), None)
        if holding is not None:
            choice.side = holding
            return f"the {holding} hand holds it already"
        item = boards[0].site_item(context)
        may = tuple(each.side for each in boards if item.is_for(each.side)) if wanted is None else (wanted,)
        free = [board for board in boards if board.side in may and not context.knowledge.may_hold(board.side)]
        if not free:
            return Failure(
                kind=FailureKind.HAND_FULL,
                message=f"no free hand for {context.called(boards[0].item)}: {' and '.join(may)} asked for",
            )
        return _nearest(context, free, choice)

    return Decide(name, context, decide)


def _nearest(context: TreeContext, free: list[HandBoard], choice: Choice) -> str | Failure:
    point = target_in_base(context, free[0])
    if isinstance(point, Failure):
        return point
    zone = zone_at(context, point)
    able = [board for board in free if reaches(board.side, zone)]
    if not able:
        return unreachable(context, free[0], zone, point)
    robot = context.knowledge.description
    if robot is not None:
        # In the base y is to the left: the hand on the item's own side has the least way and crosses nothing.
        able.sort(key=lambda board: abs(point[1] - robot.end_effector(board.side).work_point[1]))
    choice.side = able[0].side
    return f"{choice.side} arm: {context.called(free[0].item)} is in {zone} at y = {point[1]:.2f} m"
