"""Place: put what a hand holds into a slot of a depot."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence
from pydantic import Field

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Count, HandName, Message
from tandem.skills.ports.problems import Problem
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.site import Site
from tandem.skills.ports.world import HeldItem
from tandem.trees.behaviours.decide import Decide
from tandem.trees.behaviours.phase import Phase
from tandem.trees.board import FetchBoard
from tandem.trees.closing import where_all_is, where_robot_is
from tandem.trees.conditions.item_placed import item_placed
from tandem.trees.conditions.robot_heard import unheard
from tandem.trees.context import TreeContext
from tandem.trees.leaves.bind_slot import bind_slot, free_slots
from tandem.trees.needs import Needs, no_such_hand
from tandem.trees.subtrees.place import place
from tandem.trees.subtrees.request import know_where, ready
from tandem.trees.task import TaskType

NAME: Final = "place"
UNBOUND: Final = -1
"""The number of no item, until it is known what is in the hand."""


class PlaceRequest(Message):
    """Put down what a hand holds."""

    task: Literal["place"] = "place"
    to: Annotated[str, Field(max_length=64, description="name of the depot")] = "depot"
    slot: Annotated[
        int | None, Field(ge=0, le=999, description="number of the slot; default: the first free one")
    ] = None
    arm: Annotated[
        HandName | None, Field(description="which hand; default: the first that holds something")
    ] = None


class PlaceResult(Message):
    """What lies where now."""

    item: Count
    depot: str
    slot: Count


class PlaceNotes(Message):
    """Kept with the task (``TaskNotes.keep``): a tree of after a restart must know what was in the hand."""

    item: Count
    side: HandName


def problems(asked: PlaceRequest, site: Site) -> tuple[Problem, ...]:
    """Return what contradicts the site."""
    depot = site.depot(asked.to)
    if depot is None:
        known = ", ".join(each.name for each in site.depots) or "none"
        return (Problem(path="to", expected=f"one of the site's depots: {known}", found=asked.to),)
    if asked.slot is not None and asked.slot >= len(depot.slots):
        most = len(depot.slots) - 1
        return (Problem(path="slot", expected=f"a slot of {asked.to}, 0 to {most}", found=str(asked.slot)),)
    return ()


def misfits(asked: PlaceRequest, robot: RobotDescription) -> tuple[Problem, ...]:
    """Return what the robot can't do."""
    return no_such_hand("arm", asked.arm, robot)


def build(asked: PlaceRequest, context: TreeContext) -> Behaviour:
    """Return the tree."""
    board = FetchBoard(item=UNBOUND, destination=asked.to, wanted_arm=asked.arm)
    context.board = board
    if asked.slot is not None:
        board.slots_taken = set(range(len(board.depot(context).slots))) - {asked.slot}
    context.closing = lambda: _where_all_is(context, board)
    context.result = lambda: _result(context, board)
    take_up = Sequence(
        "take up request",
        memory=True,
        children=[
            ready(context),
            Decide("bind hand", context, lambda: _bind_hand(context, board)),
            know_where(context),
        ],
    )
    bring = Sequence(
        "bring to slot",
        memory=True,
        children=[
            Decide("slot asked for is free?", context, lambda: _wanted_is_free(context, board, asked.slot)),
            bind_slot("bind slot", context, board),
            place(context, board),
        ],
    )
    return Sequence(
        "place",
        memory=True,
        children=[
            Phase("request", context, take_up, begins=0.0, ends=0.10),
            Phase(
                "place",
                context,
                Selector("item is placed", memory=True, children=[item_placed(context, board), bring]),
                begins=0.10,
                ends=1.0,
            ),
        ],
    )


def _where_all_is(context: TreeContext, board: FetchBoard) -> dict[str, str]:
    return where_robot_is(context) if board.item == UNBOUND else where_all_is(context, board)


def _bind_hand(context: TreeContext, board: FetchBoard) -> str | Failure:
    world, noted = context.knowledge.world, context.notes.kept(NAME, PlaceNotes)
    held = () if world is None else world.held
    found = _chosen(held, board.wanted_arm, noted)
    if found is None:
        which = "no hand holds" if board.wanted_arm is None else f"the {board.wanted_arm} hand does not hold"
        return Failure(kind=FailureKind.HAND_EMPTY, message=f"{which} anything")
    if context.site.item(found.item) is None:
        message = f"the {found.side} hand holds item {found.item}, which the site does not have"
        return Failure(kind=FailureKind.ITEM_UNKNOWN, message=message)
    board.item, board.side = found.item, found.side
    board.sides = board.allowed = (found.side,)
    context.notes.keep(NAME, PlaceNotes(item=found.item, side=found.side))
    return f"{context.called(found.item)} of the {found.side} hand"


def _chosen(
    held: tuple[HeldItem, ...], wanted: HandName | None, noted: PlaceNotes | None
) -> PlaceNotes | None:
    """Return what is to be put down: what was begun with, or else what a hand holds."""
    if noted is not None:
        return noted
    return next(
        (PlaceNotes(item=hand.item, side=hand.side) for hand in held if wanted in {None, hand.side}), None
    )


def _wanted_is_free(context: TreeContext, board: FetchBoard, slot: int | None) -> str | Failure:
    if slot is None or slot in free_slots(context, board, context.knowledge.world):
        return "any" if slot is None else f"slot {slot}"
    return Failure(
        kind=FailureKind.DESTINATION_FULL,
        message=f"slot {slot} of {board.destination} is taken",
        evidence={"slot": slot},
    )


def _result(context: TreeContext, board: FetchBoard) -> PlaceResult | None:
    world = context.knowledge.world
    for each in () if world is None else world.placed:
        if each.item == board.item:
            return PlaceResult(item=each.item, depot=each.depot, slot=each.slot)
    return None


TASK = TaskType(
    name="place",
    summary="Put what a hand holds into a slot of a depot.",
    request=PlaceRequest,
    problems=problems,
    build=build,
    waits=unheard,
    result=PlaceResult,
    needs=Needs(hands=1),
    misfits=misfits,
)
