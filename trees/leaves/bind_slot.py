"""Choose the slot of the destination into which the item goes."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.world import WorldState
from tandem.trees.behaviours.decide import Decide
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext

TAKEN: Final = 0.10
"""Metres around a slot within which an item seen there takes it."""


def bind_slot(name: str, context: TreeContext, board: FetchBoard) -> Decide:
    """Return the leaf: the slot in which the item lies already, or else the first that is free."""

    def decide() -> str | Failure:
        world = context.knowledge.world
        placed = () if world is None else world.placed
        mine = [p.slot for p in placed if p.item == board.item and p.depot == board.destination]
        if mine:
            board.slot = mine[0]
            return f"{context.called(board.item)} lies in slot {board.slot} of {board.destination}"
        free = free_slots(context, board, world)
        if not free:
            return Failure(
                kind=FailureKind.DESTINATION_FULL,
                message=f"no slot of {board.destination} is free",
                evidence={"slots": len(board.depot(context).slots)},
            )
        board.slot = free[0]
        return f"slot {board.slot} of {board.destination}"

    return Decide(name, context, decide)


def free_slots(context: TreeContext, board: FetchBoard, world: WorldState | None) -> list[int]:
    """Return the indices of the destination's slots on which nothing is known to stand."""
    placed = () if world is None else world.placed
    items = () if world is None else world.items
    taken = {each.slot for each in placed if each.depot == board.destination} | board.slots_taken
    standing = [fact.tag_in_map.position for fact in items if fact.held is None and fact.item != board.item]
    return [
        index
        for index, slot in enumerate(board.depot(context).slots)
        if index not in taken
        and all((x - slot.position[0]) ** 2 + (y - slot.position[1]) ** 2 > TAKEN**2 for x, y, _ in standing)
    ]
