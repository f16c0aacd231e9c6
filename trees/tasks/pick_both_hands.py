"""Pick one thing with both hands, and put it down again: two-arm thesis, 4.1.2, coordinated bimanual."""

from __future__ import annotations

from typing import Annotated, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence
from pydantic import Field

from tandem.skills.ports.actions.bimanual import PAIR
from tandem.skills.ports.message import Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.phase import Phase
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.hand_requests import item_problems
from tandem.trees.item_number import ItemNumber
from tandem.trees.leaves.coordinate import Mode
from tandem.trees.leaves.two_hands import BothBoard
from tandem.trees.leaves.within_reach import within_reach
from tandem.trees.needs import Needs
from tandem.trees.subtrees.both_pick import HOLD, both_pick
from tandem.trees.subtrees.hand_pick import Method
from tandem.trees.subtrees.two_arms import take_up, watched, where_hands_are
from tandem.trees.task import TaskType


class PickBothHandsRequest(Message):
    """Lift an item that needs both hands, hold it, and put it down where it stood."""

    task: Literal["pick_both_hands"] = "pick_both_hands"
    item: ItemNumber
    parallel_pick: Annotated[bool, Field(description="always true for an item that needs both hands")] = True
    hold: Annotated[float, Field(ge=0.0, le=60.0, description="robot seconds to hold it up")] = HOLD
    mode: Annotated[Mode, Field(description="when a stopped arm continues")] = "eager"
    method: Annotated[Method, Field(description="how the hands approach it")] = "apf_rrtconnect"


def problems(asked: PickBothHandsRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site, or the item."""
    found = list(item_problems(site, "item", asked.item, two=True))
    if not asked.parallel_pick:
        expected = "true: both hands grasp this item at once"
        found.append(Problem(path="parallel_pick", expected=expected, found="false"))
    return tuple(found)


def build(asked: PickBothHandsRequest, context: TreeContext) -> Behaviour:
    """Return the tree."""
    board = BothBoard(HandBoard("left", asked.item), HandBoard("right", asked.item))
    context.board = board
    context.closing = lambda: where_hands_are(context, board.hands)
    pick = both_pick(context, board, asked.method, asked.hold)
    return Sequence(
        "pick_both_hands",
        memory=True,
        children=[
            Phase("request", context, take_up(context, board.hands), begins=0.0, ends=0.10),
            within_reach("grasp points are within reach", context, board.hands),
            Phase(
                "pick", context, watched(context, pick, board.hands, mode=asked.mode), begins=0.10, ends=1.0
            ),
        ],
    )


TASK = TaskType(
    name="pick_both_hands",
    summary="Lift one item with both hands, and put it down again.",
    request=PickBothHandsRequest,
    problems=problems,
    build=build,
    waits=unheard,
    needs=Needs(named=PAIR, camera=True),
)
