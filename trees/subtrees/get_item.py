"""Get the item into a hand, with the order-picking paper's recoveries of arm and base: III-A.4, Fig. 4.

The arm fails: first the cheap ways (another grasp, another stand at the same place), then HOME, a new search,
a new estimate of the tag, at most twice; then the item is unreachable. The base fails: the
distance to the goal is changed, at most twice.
"""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from py_trees.decorators import FailureIsSuccess

from tandem.skills.geometry.poses import floor_distance
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.behaviours.interruptible import Interruptible
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.board import FetchBoard
from tandem.trees.conditions.item_held import item_held
from tandem.trees.context import TreeContext
from tandem.trees.leaves.edit_scene import forget
from tandem.trees.recovery_kinds import (
    another_grasp_helps,
    another_view_helps,
    looking_again_helps,
    searching_again_helps,
)
from tandem.trees.subtrees.arms_in import free_and_tuck
from tandem.trees.subtrees.home import drive_home
from tandem.trees.subtrees.pick import pick
from tandem.trees.subtrees.recovery_steps import another_way, localise_again, wait_back
from tandem.trees.subtrees.search import search
from tandem.trees.subtrees.see_the_way import see_the_way

WITHIN: Final = 420.0
"""Robot seconds after which nothing is tried again."""
VIEWS: Final = 3
"""Stands from which an item that something hides is looked at: from three sides of it at least one is open,
unless it is walled in."""
BESIDE: Final = 0.15
"""Metres about a stand within which another one shows the same: the camera moves by no more than the width of
what hides the item."""
LOOKS: Final = 2
GRASPS: Final = 2
SEARCHES: Final = 2
"""How often it looks around again, grasps another way, and searches anew from home. The last is at most twice
in the order-picking paper (III-A.4), the others are ours. More only put off ``ITEM_UNREACHABLE``; WITHIN
bounds them all."""


def get_item(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree: SUCCESS when the item is in a hand."""
    main = Selector(
        "item in hand",
        memory=True,
        children=[
            item_held(context, board),
            Sequence(
                "find and pick",
                memory=True,
                children=[
                    Phase("search", context, _search(context, board), begins=0.05, ends=0.30),
                    Phase("pick", context, pick(context, board), begins=0.30, ends=0.60),
                ],
            ),
        ],
    )
    steps = (
        wait_back("get", context),
        localise_again("get", context),
        another_way("get", context, board),
        *see_the_way("get", context, board.avoid.clear),
        RecoveryStep(
            "get: look from another stand", another_view_helps, VIEWS, _another_view(context, board)
        ),
        RecoveryStep("get: look around again", looking_again_helps, LOOKS, _look_around(context, board)),
        RecoveryStep("get: grasp another way", another_grasp_helps, GRASPS, _another_grasp(context, board)),
        RecoveryStep(
            "get: go home and search again", searching_again_helps, SEARCHES, _from_home(context, board)
        ),
    )
    return Recovery(
        "get item",
        context,
        main,
        steps,
        within=WITHIN,
        conclude=lambda failure: _unreachable(context, board, failure),
    )


def _search(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Search; a task of a higher priority may take over meanwhile: the item is in no hand yet."""
    return Interruptible("searching may wait", context, search(context, board))


def _look_around(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Forget the item, but tuck the arms in first: a hand may be around it, and what is forgotten is hit."""
    return Sequence(
        "get: forget and look",
        memory=True,
        children=[
            free_and_tuck(context, "get: before looking"),
            forget("get: forget it", context, board),
        ],
    )


def _another_view(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Stand neither here nor close beside it again. The arms are in: the item has only been looked at."""

    def decide() -> str:
        robot = context.knowledge.robot
        if robot is not None:
            here = robot.base_in_map
            board.avoid.append(here)
            board.avoid.extend(each for each in board.stands if floor_distance(each, here) < BESIDE)
        return f"{len(board.avoid)} stands are not tried again"

    return Note("get: avoid this view", decide)


def _another_grasp(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Draw back; the grasp that failed is not tried again, and the second time the stand neither."""

    def decide() -> str:
        if board.grasp is not None and board.grasp.pitch not in board.pitches_tried:
            board.pitches_tried.append(board.grasp.pitch)
        elif context.knowledge.robot is not None:
            board.avoid.append(context.knowledge.robot.base_in_map)
        return f"{len(board.pitches_tried)} grasps and {len(board.avoid)} stands are not tried again"

    return Sequence(
        "get: draw back",
        memory=True,
        children=[
            free_and_tuck(context, "get: draw back"),
            Note("get: avoid this grasp", decide),
        ],
    )


def _from_home(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Go home if there is a way, and forget all that was believed of the item; prefer the other arm.

    With an arm that does not come in nothing is forgotten, and this fails: a hand may be around the item.
    """

    def decide() -> str:
        board.forget_tries()
        board.grasp = None
        others = tuple(side for side in board.allowed if side != board.side)
        board.sides = (*others, *(side for side in board.allowed if side == board.side))
        return f"{' or '.join(board.sides)} arm"

    return Sequence(
        "get: from home",
        memory=True,
        children=[
            free_and_tuck(context, "get: home"),
            FailureIsSuccess("get: home if there is a way", drive_home(context, "get: home")),
            forget("get: forget where it is", context, board),
            Note("get: begin anew", decide),
        ],
    )


def _unreachable(context: TreeContext, board: FetchBoard, failure: Failure) -> Failure:
    """Return what is told when all that helps an arm has been tried."""
    told = {FailureKind.ITEM_UNREACHABLE, FailureKind.GRIPPER_STUCK}
    if failure.kind in told or not searching_again_helps(failure):
        return failure
    tried = f"could not be picked up, whatever was tried; the last was {failure.kind}"
    return Failure(
        kind=FailureKind.ITEM_UNREACHABLE,
        message=f"{context.called(board.item)} {tried}",
        where=failure.where,
        evidence=failure.evidence,
        causes=(failure,),
    )
