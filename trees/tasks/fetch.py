"""Fetch an item: find it, pick it up, put it down in the depot, go home.

Written backwards from what must be true: placed? held? located? So a tree that starts again in the middle
picks up where the world is.
"""

from __future__ import annotations

from typing import Annotated, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from skills.ports.message import Message
from skills.ports.site import Site
from skills.ports.tasks import Problem
from skills.ports.world import Side
from trees.behaviours.phase import Phase
from trees.behaviours.remember import afterwards
from trees.board import FetchBoard
from trees.conditions.item_held import item_held
from trees.conditions.item_placed import item_placed
from trees.context import TreeContext
from trees.subtrees.home import home
from trees.subtrees.pick import pick
from trees.subtrees.place import place
from trees.subtrees.request import request
from trees.subtrees.search import search
from trees.task import TaskType


class FetchRequest(Message):
    """Bring an item to a depot."""

    task: Literal["fetch"] = "fetch"
    item: Annotated[int, Field(ge=0, le=586, description="number of the item's tag (AprilTag 36h11)")]
    to: Annotated[str, Field(max_length=64, description="name of the depot")] = "depot"
    arm: Annotated[Side | None, Field(description="which arm; the robot chooses unless given")] = None


def problems(asked: FetchRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site."""
    found = []
    item = site.item(asked.item)
    if item is None:
        known = ", ".join(str(each.item) for each in site.items)
        found.append(
            Problem(path="item", expected=f"one of the site's items: {known}", found=str(asked.item))
        )
    elif asked.arm is not None and asked.arm not in item.hands:
        found.append(
            Problem(path="arm", expected=f"a hand for item {item.item}: {item.hands}", found=asked.arm)
        )
    if site.depot(asked.to) is None:
        known = ", ".join(each.name for each in site.depots)
        found.append(Problem(path="to", expected=f"one of the site's depots: {known}", found=asked.to))
    return tuple(found)


def build(asked: FetchRequest, context: TreeContext) -> Behaviour:
    """Return the tree of one fetch."""
    board = FetchBoard(item=asked.item, destination=asked.to, wanted_arm=asked.arm)
    in_hand = Selector(
        "item in hand",
        memory=True,
        children=[
            item_held(context, board),
            Sequence(
                "get item",
                memory=True,
                children=[
                    Phase("search", context, search(context, board), begins=0.05, ends=0.30),
                    Phase("pick", context, pick(context, board), begins=0.30, ends=0.60),
                ],
            ),
        ],
    )
    delivered = Selector(
        "item delivered",
        memory=True,
        children=[
            item_placed(context, board),
            Sequence(
                "deliver item",
                memory=True,
                children=[
                    in_hand,
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
                delivered,
                Phase("home", context, home(context), begins=0.90, ends=1.0),
            ),
        ],
    )


TASK = TaskType(
    name="fetch", summary="Bring an item to a depot.", request=FetchRequest, problems=problems, build=build
)
