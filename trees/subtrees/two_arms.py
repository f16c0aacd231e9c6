"""What the tasks of two arms begin with, and what goes on beside them."""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.decide import Decide
from tandem.trees.behaviours.meanwhile import Meanwhile
from tandem.trees.behaviours.pause import Pause
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.wait_for import WaitFor
from tandem.trees.branch import branch
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.leaves.coordinate import Mode, coordinate
from tandem.trees.leaves.look_at_table import look_at_table
from tandem.trees.leaves.track import track
from tandem.trees.leaves.within_reach import zoned
from tandem.trees.recovery_kinds import unseen
from tandem.trees.subtrees.arms_in import free_and_tuck
from tandem.trees.subtrees.recovery_steps import wait_back
from tandem.trees.subtrees.request import localised_by, ready

ZONES_WITHIN: Final = 20.0
"""Robot seconds in which the workspace zones must be known: they are computed once at the start."""
WITHIN: Final = 60.0
"""Robot seconds after which the table is not looked at again."""
LOOKS: Final = 2
"""How often the table is looked at again: one picture may be blurred, or something in its way. More only put
off the failure of an item that is not there."""
ANOTHER_MOMENT: Final = 0.5
"""Robot seconds before the table is looked at again."""


def take_up(context: TreeContext, boards: tuple[HandBoard, ...], *, check: bool = True) -> Behaviour:
    """Return the subtree: the robot is ready, the hands are free, the items are in view.

    No arm moves unless one that is out may hide an item. Without ``check`` the hands are not looked at: the
    arm is chosen later.
    """
    items = tuple(dict.fromkeys(board.item for board in boards))
    where = localised_by(context, (wait_back("request", context),), within=WITHIN)
    look = Recovery(
        "see the items",
        context,
        look_at_table("look at table", context, items),
        (
            wait_back("look", context),
            RecoveryStep("look: once more", unseen, LOOKS, Pause("look: a moment", context, ANOTHER_MOMENT)),
            # After a restart an arm may stand before what it was about to pick.
            RecoveryStep("look: arms out of the sight", unseen, 1, free_and_tuck(context, "look")),
        ),
        within=WITHIN,
    )
    return Sequence(
        "take up request",
        memory=True,
        children=[
            ready(context),
            _zones_known(context),
            *((hands_free(context, boards),) if check else ()),
            where,
            look,
        ],
    )


def hands_free(context: TreeContext, boards: tuple[HandBoard, ...]) -> Decide:
    """Return the leaf: FAILURE when a hand holds something else than its item."""

    def decide() -> str | Failure:
        world = context.knowledge.world
        for board in boards:
            held = None if world is None else world.in_hand(board.side)
            if held is not None and held.item != board.item:
                holds = context.called(held.item)
                message = (
                    f"the {board.side} hand holds {holds}, and is asked for {context.called(board.item)}"
                )
                return Failure(
                    kind=FailureKind.HAND_FULL,
                    message=message,
                    evidence={"holds": held.item},
                )
        return ", ".join(f"the {board.side} hand for {context.called(board.item)}" for board in boards)

    return Decide("hands are free", context, decide)


def watched(
    context: TreeContext, main: Behaviour, boards: tuple[HandBoard, ...], *, mode: Mode | None = "eager"
) -> Behaviour:
    """Return main with tracking, and with the coordination unless there is no mode for it, beside it.

    The head follows the boards' items.
    """
    items = tuple(dict.fromkeys(board.item for board in boards))
    beside = []
    seeing = branch(context, "tracking")
    beside.append(
        Recovery(
            "keep tracking",
            seeing,
            track("track", seeing, items),
            (wait_back("track", seeing),),
            within=ALWAYS,
        )
    )
    if mode is not None:
        ruling = branch(context, "coordination")
        beside.append(
            Recovery(
                "keep coordinating",
                ruling,
                coordinate("coordinate", ruling, mode),
                (wait_back("coordinate", ruling),),
                within=ALWAYS,
            )
        )
    return Meanwhile("watch meanwhile", context, main, *beside)


ALWAYS: Final = 3600.0
"""Robot seconds: longer than any task."""


def _zones_known(context: TreeContext) -> WaitFor:
    def otherwise() -> Failure:
        return Failure(kind=FailureKind.NOT_READY, message="not heard yet: world/zones")

    return WaitFor(
        "zones are known",
        context,
        lambda: context.knowledge.zones is not None or not zoned(context),
        otherwise,
        patience=ZONES_WITHIN,
    )


def where_hands_are(context: TreeContext, boards: tuple[HandBoard, ...]) -> dict[str, str]:
    """Return where hands and items are, in words, as far as anybody knows."""
    out = [board.side for board in boards if not board.safe]
    arms = f"; {' and '.join(out)} arm not in its safe zone" if out else "; both arms in their safe zones"
    items = dict.fromkeys(board.item for board in boards)
    return {
        "robot_is": f"at the table{arms}",
        "item_is": "; ".join(f"{context.site.called(item)}: {_where(context, item)}" for item in items),
    }


def _where(context: TreeContext, item: int) -> str:
    world = context.knowledge.world
    held = [] if world is None else [side for side in context.knowledge.hands if _holds(context, side, item)]
    fact = None if world is None else world.item(item)
    if held:
        return f"in the {held[0]} hand"
    if fact is None:
        return "unknown"
    x, y, z = fact.tag_in_map.position
    return f"last seen at ({x:.2f}, {y:.2f}, {z:.2f}) m in the map"


def _holds(context: TreeContext, side: str, item: int) -> bool:
    world = context.knowledge.world
    return world is not None and any(hand.side == side and hand.item == item for hand in world.held)
