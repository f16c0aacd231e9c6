"""Pick one item from the table before the robot with one hand, whichever is nearer unless one is named."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from tandem.skills.ports.message import HandName, Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.trees.behaviours.check import Check
from tandem.trees.behaviours.phase import Phase
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard
from tandem.trees.hand_requests import hand_problems, item_problems
from tandem.trees.item_number import ItemNumber
from tandem.trees.leaves.choose_arm import Choice, choose_arm
from tandem.trees.needs import Needs, no_such_hand
from tandem.trees.subtrees.hand_pick import Method, hand_pick
from tandem.trees.subtrees.two_arms import take_up, watched, where_hands_are
from tandem.trees.task import TaskType


class PickRequest(Message):
    """Pick an item that stands on the table before the robot."""

    task: Literal["pick"] = "pick"
    item: ItemNumber
    arm: Annotated[HandName | None, Field(description="which arm; default: the nearer one")] = None
    method: Annotated[Method, Field(description="how the hand approaches it")] = "apf_rrtconnect"


def problems(asked: PickRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site."""
    found = list(item_problems(site, "item", asked.item))
    if asked.arm is not None:
        found += hand_problems(site, "arm", asked.item, asked.arm)
    return tuple(found)


def misfits(asked: PickRequest, robot: RobotDescription) -> tuple[Problem, ...]:
    """Return what the robot can't do."""
    return no_such_hand("arm", asked.arm, robot)


def build(asked: PickRequest, context: TreeContext) -> Behaviour:
    """Return the tree: a pick for each arm, of which the chosen one is run."""
    boards = tuple(HandBoard(hand, asked.item) for hand in context.knowledge.hands)
    context.board = boards
    choice = Choice()
    context.closing = lambda: where_hands_are(context, boards)
    picks = [
        Sequence(
            f"{board.who}: if chosen",
            memory=True,
            children=[
                Check(f"{board.who}: chosen?", partial(_is_chosen, choice, board.side)),
                hand_pick(context, board, asked.method),
            ],
        )
        for board in boards
    ]
    chosen = Selector("with the chosen arm", memory=True, children=list(picks))
    return Sequence(
        "pick",
        memory=True,
        children=[
            Phase("request", context, take_up(context, boards[:1], check=False), begins=0.0, ends=0.10),
            choose_arm("choose arm", context, boards, asked.arm, choice),
            Phase("hand", context, watched(context, chosen, boards, mode=None), begins=0.10, ends=1.0),
        ],
    )


def _is_chosen(choice: Choice, side: HandName) -> bool:
    return choice.side == side


TASK = TaskType(
    name="pick",
    summary="Pick one item with one hand.",
    request=PickRequest,
    problems=problems,
    build=build,
    waits=unheard,
    needs=Needs(hands=1, camera=True),
    misfits=misfits,
)
