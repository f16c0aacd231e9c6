"""Take up a request: check it against what is known, bind arm and slot, before anything moves."""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from skills.ports.failure import Failure, FailureKind
from skills.ports.world import WorldState
from trees.behaviours.decide import Decide
from trees.behaviours.wait_for import WaitFor
from trees.board import FetchBoard
from trees.conditions.localised import localised
from trees.context import TreeContext
from trees.leaves.localise import localise

PATIENCE: Final = 10.0
"""Robot seconds to wait for skills that have not been heard yet."""
SLOT_TAKEN: Final = 0.10
"""Metres around a slot within which an item seen there takes it."""


def request(context: TreeContext, board: FetchBoard) -> Behaviour:
    """Return the subtree."""
    where = Selector("know where I am", memory=True, children=[localised(context), localise(context)])
    return Sequence(
        "take up request",
        memory=True,
        children=[_ready(context), _bind_arm(context, board), _bind_slot(context, board), where],
    )


def _ready(context: TreeContext) -> WaitFor:
    def otherwise() -> Failure:
        if context.knowledge.stopped.stopped:
            stop = context.knowledge.stopped
            return Failure(kind=FailureKind.HARDWARE_STOPPED, message=f"stopped by {stop.by}: {stop.reason}")
        missing = ", ".join(context.knowledge.missing())
        return Failure(kind=FailureKind.NOT_READY, message=f"not heard yet: {missing}")

    def ready() -> bool:
        return not context.knowledge.missing() and not context.knowledge.stopped.stopped

    return WaitFor("robot is ready", context, ready, otherwise, patience=PATIENCE)


def _bind_arm(context: TreeContext, board: FetchBoard) -> Decide:
    def decide() -> str | Failure:
        world = context.knowledge.world or _nothing()
        holding = next((hand.side for hand in world.held if hand.item == board.item), None)
        if holding is not None:
            board.side, board.sides = holding, (holding,)
            return f"the {holding} hand holds item {board.item} already"
        hands = board.site_item(context).hands
        wanted = (board.wanted_arm,) if board.wanted_arm is not None else hands
        free = tuple(side for side in wanted if world.in_hand(side) is None)
        if not free:
            held = ", ".join(f"{hand.side}: item {hand.item}" for hand in world.held)
            return Failure(kind=FailureKind.HAND_FULL, message=f"no free hand for item {board.item} ({held})")
        board.side, board.sides = free[0], free
        return f"{' or '.join(free)} arm for item {board.item}"

    return Decide("bind arm", context, decide)


def _bind_slot(context: TreeContext, board: FetchBoard) -> Decide:
    def decide() -> str | Failure:
        world = context.knowledge.world or _nothing()
        mine = [p.slot for p in world.placed if p.item == board.item and p.depot == board.destination]
        if mine:
            board.slot = mine[0]
            return f"item {board.item} lies in slot {board.slot} of {board.destination}"
        free = free_slots(context, board, world)
        if not free:
            return Failure(
                kind=FailureKind.DESTINATION_FULL,
                message=f"no slot of {board.destination} is free",
                evidence={"slots": len(board.depot(context).slots)},
            )
        board.slot = free[0]
        return f"slot {board.slot} of {board.destination}"

    return Decide("bind slot", context, decide)


def free_slots(context: TreeContext, board: FetchBoard, world: WorldState) -> list[int]:
    """Return the indices of the destination's slots on which no item is known to stand."""
    taken = {each.slot for each in world.placed if each.depot == board.destination}
    standing = [fact.tag_in_map.position for fact in world.items if fact.held is None]
    return [
        index
        for index, slot in enumerate(board.depot(context).slots)
        if index not in taken
        and all(
            (x - slot.position[0]) ** 2 + (y - slot.position[1]) ** 2 > SLOT_TAKEN**2 for x, y, _ in standing
        )
    ]


def _nothing() -> WorldState:
    raise AssertionError("the robot is ready only when the world has been heard")
