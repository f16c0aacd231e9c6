"""Get the base to where the arm reaches: the order-picking paper's neighbourhood (III-A.3).

See docs/decisions/003-survey-before-driving.md.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName, Vector3
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.meanwhile import Meanwhile
from tandem.trees.board import FetchBoard
from tandem.trees.branch import branch
from tandem.trees.conditions.at_pose import at_any
from tandem.trees.context import TreeContext
from tandem.trees.leaves.survey import Reach, survey_stands
from tandem.trees.leaves.turn_head import turn_head
from tandem.trees.subtrees.arms_in import free_and_tuck, tuck
from tandem.trees.subtrees.travel import drive_and_give_way

FACES: Final = {0: "", 1: ", left face", -1: ", right face"}
"""Names of an item's faces by quarter turns, seen from above, from the one that is seen."""


def stand_near(
    what: str,
    context: TreeContext,
    board: FetchBoard,
    reach: Callable[[HandName, int], Reach | Failure],
    *,
    faces: tuple[int, ...] = (0,),
    touch_support: bool = False,
    unreachable: FailureKind = FailureKind.ITEM_UNREACHABLE,
    look: Callable[[str], Behaviour] | None = None,
    sight: Callable[[], Vector3 | Failure] | None = None,
) -> Behaviour:
    """Return the subtree: SUCCESS when the base stands where the arm reaches.

    Args:
        what: "item" or "slot", a part of the nodes' names.
        context: the task's surroundings.
        board: gets the arm and the stands.
        reach: for a side and a face, the base poses worth a look and what the hand shall do there.
        faces: the faces of the item to go for, in quarter turns from the one that is seen.
        unreachable: the kind of failure when no arm reaches.
        touch_support: whether what is held will touch what it is put on.
        look: makes the leaf that looks closely from there; what it shows may ask for another face, arm or
            stand, so the survey is made once more, with the place where the robot stands first.
        sight: the point in the map (m) that ``look`` looks at; the head turns to it while the base drives.
    """
    go = partial(
        _go,
        context=context,
        board=board,
        reach=reach,
        faces=faces,
        touch_support=touch_support,
        unreachable=unreachable,
        sight=sight,
    )
    if look is None:
        return go(what)
    return Sequence(
        f"get near {what}",
        memory=True,
        children=[
            go(what),
            look(f"look closely at {what}"),
            go(f"{what} again", here_first=True, then=look(f"look once more at {what}")),
        ],
    )


def _go(
    what: str,
    *,
    context: TreeContext,
    board: FetchBoard,
    reach: Callable[[HandName, int], Reach | Failure],
    faces: tuple[int, ...],
    touch_support: bool,
    unreachable: FailureKind,
    sight: Callable[[], Vector3 | Failure] | None,
    here_first: bool = False,
    then: Behaviour | None = None,
) -> Behaviour:
    """Survey with each arm and face, and drive unless the robot is there; ``then`` comes after driving."""
    surveys = [
        Sequence(
            f"with {side} arm{FACES[turns]} to {what}",
            memory=True,
            children=[
                Check(f"{side} arm{FACES[turns]} may be used for {what}?", partial(_may_use, board, side)),
                survey_stands(
                    f"survey {what}, {side} arm{FACES[turns]}",
                    context,
                    board,
                    side,
                    partial(reach, side, turns),
                    touch_support=touch_support,
                    unreachable=unreachable,
                    here_first=here_first,
                ),
            ],
        )
        for turns in faces
        for side in context.knowledge.hands
    ]
    return Sequence(
        f"approach {what}",
        memory=True,
        children=[
            Selector(f"where to stand for {what}", memory=True, children=list(surveys)),
            Selector(
                f"near {what}",
                memory=True,
                children=[
                    at_any(f"near {what}?", context, lambda: board.stands),
                    Sequence(
                        f"go to {what}",
                        memory=True,
                        children=[
                            (tuck if here_first else free_and_tuck)(context, f"before {what}"),
                            _drive(what, context, board, sight),
                            *(() if then is None else (then,)),
                        ],
                    ),
                ],
            ),
        ],
    )


def _drive(
    what: str, context: TreeContext, board: FetchBoard, sight: Callable[[], Vector3 | Failure] | None
) -> Behaviour:
    """Drive to the first stand that there is a way to; the head turns meanwhile, if it can."""
    way = drive_and_give_way(f"drive to {what}", context, lambda: board.stands, serves=lambda: board.item)
    if sight is None:
        return way
    head = turn_head(f"turn head to {what}", branch(context, "head"), sight, lambda: board.stands[0])
    return Meanwhile(f"drive to {what}, head ahead", context, way, head)


def _may_use(board: FetchBoard, side: HandName) -> bool:
    return side in board.sides


def unknown(context: TreeContext, item: int) -> Failure:
    """Return the failure of a tree that was sent to an item nobody has seen."""
    return Failure(kind=FailureKind.ITEM_GONE, message=f"{context.called(item)} has not been seen")
