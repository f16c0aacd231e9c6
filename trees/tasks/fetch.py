"""Fetch an item: find it, pick it up, put it down in the depot, go home.

Written backwards from what must be true: placed? held? located? So a tree that starts again in the middle
picks up where the world is.
"""

from __future__ import annotations

from typing import Annotated, Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from tandem.skills.ports.message import HandName, Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.phase import Phase
from tandem.trees.behaviours.recovery import Recovery, RecoveryStep
from tandem.trees.behaviours.remember import afterwards
from tandem.trees.board import FetchBoard
from tandem.trees.closing import where_all_is
from tandem.trees.conditions.item_placed import item_placed
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.item_number import ItemNumber
from tandem.trees.needs import Needs, no_such_hand
from tandem.trees.recovery_kinds import fetching_again_helps
from tandem.trees.subtrees.get_item import get_item
from tandem.trees.subtrees.home import home_at_last
from tandem.trees.subtrees.place import place
from tandem.trees.subtrees.put_back import put_back
from tandem.trees.subtrees.request import request
from tandem.trees.task import TaskType

DROPS: Final = 2
"""How often an item that has fallen is fetched again."""
WITHIN: Final = 900.0
"""Robot seconds after which it is not."""


Coordinate = Annotated[float, Field(ge=-1000.0, le=1000.0)]
"""Metres; no site is larger."""


class FetchRequest(Message):
    """Bring an item to a depot."""

    task: Literal["fetch"] = "fetch"
    item: ItemNumber
    to: Annotated[str, Field(max_length=64, description="name of the depot")] = "depot"
    near: Annotated[
        tuple[Coordinate, Coordinate] | None,
        Field(
            description="x, y in the map (m); of several things with that number, the one within 0.5 m of it "
            "is meant"
        ),
    ] = None
    arm: Annotated[HandName | None, Field(description="which arm; default: the robot chooses")] = None
    on_cancel: Annotated[
        Literal["hold", "put_down"],
        Field(description="with the item in the hand: keep it there, or put it back where it stood"),
    ] = "hold"


def problems(asked: FetchRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site."""
    found = []
    item = site.item(asked.item)
    if item is None:
        known = site.item_words()
        found.append(
            Problem(path="item", expected=f"one of the site's items: {known}", found=str(asked.item))
        )
    elif asked.arm is not None and not item.is_for(asked.arm):
        found.append(
            Problem(
                path="arm", expected=f"a hand for item {item.words}: {', '.join(item.hands)}", found=asked.arm
            )
        )
    if site.depot(asked.to) is None:
        known = ", ".join(each.name for each in site.depots)
        found.append(Problem(path="to", expected=f"one of the site's depots: {known}", found=asked.to))
    return tuple(found)


def misfits(asked: FetchRequest, robot: RobotDescription) -> tuple[Problem, ...]:
    """Return what the robot can't do."""
    return no_such_hand("arm", asked.arm, robot)


def build(asked: FetchRequest, context: TreeContext) -> Behaviour:
    """Return the tree of one fetch."""
    board = FetchBoard(item=asked.item, destination=asked.to, wanted_arm=asked.arm, near=asked.near)
    context.board = board
    context.closing = lambda: where_all_is(context, board)
    if asked.on_cancel == "put_down":
        context.wind_down = put_back(context, board)
    delivered = Selector(
        "item delivered",
        memory=True,
        children=[
            item_placed(context, board),
            Sequence(
                "deliver item",
                memory=True,
                children=[
                    get_item(context, board),
                    Phase("place", context, place(context, board), begins=0.60, ends=0.90),
                ],
            ),
        ],
    )
    return Sequence(
        "fetch",
        memory=True,
        children=[
            Phase("request", context, request(context, board), begins=0.0, ends=0.05),
            afterwards(
                "deliver and go home",
                context,
                Recovery(
                    "deliver, whatever falls",
                    context,
                    delivered,
                    (RecoveryStep("fetch it again", fetching_again_helps, DROPS, _again(board)),),
                    within=WITHIN,
                ),
                Phase("home", context, home_at_last(context), begins=0.90, ends=1.0),
            ),
        ],
    )


def _again(board: FetchBoard) -> Note:
    """Begin anew with any arm that is allowed: the item has fallen, and lies nobody knows where."""

    def decide() -> str:
        board.forget_tries()
        board.grasp, board.place = None, None
        board.sides = board.allowed
        return f"{' or '.join(board.sides)} arm"

    return Note("begin the fetch anew", decide)


TASK = TaskType(
    name="fetch",
    summary="Bring an item to a depot.",
    request=FetchRequest,
    problems=problems,
    build=build,
    waits=unheard,
    needs=Needs(hands=1, drive=True, camera=True),
    misfits=misfits,
)
