"""What is told of an item that a hand has lost, or can't take hold of: the same in all trees."""

from __future__ import annotations

from skills.ports.failure import Failure, FailureKind
from skills.ports.grasping import upright_in_map
from skills.ports.world import ItemFact, Side


def fallen_over(fact: ItemFact) -> Failure | None:
    """Return the failure of an item that is not upright, or None for one that is."""
    return None if upright_in_map(fact.tag_in_map, fact.size[0]) is not None else lies(fact)


def lies(fact: ItemFact) -> Failure:
    """Return the failure of an item that has fallen over."""
    return Failure(
        kind=FailureKind.ITEM_UNREACHABLE,
        message=f"item {fact.item} has fallen over: hands take hold of what stands upright",
        evidence={"item": fact.item},
    )


def no_longer_held(item: int, side: Side) -> Failure:
    """Return the failure of an item that was in a hand."""
    return Failure(
        kind=FailureKind.GRASP_LOST,
        message=f"item {item} is no longer in the {side} hand",
        evidence={"item": item, "side": side},
    )
