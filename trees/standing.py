"""Does an item stand? What has fallen over has its tag on top, and no hand takes hold of it like that."""

from __future__ import annotations

from skills.ports.failure import Failure, FailureKind
from skills.ports.grasping import upright_in_map
from skills.ports.world import ItemFact


def fallen_over(fact: ItemFact) -> Failure | None:
    """Return the failure of an item whose tag lies flat, or None for one that stands."""
    if upright_in_map(fact.tag_in_map, fact.size[0]) is not None:
        return None
    return Failure(
        kind=FailureKind.ITEM_UNREACHABLE,
        message=f"item {fact.item} has fallen over: hands take hold of what stands upright",
        evidence={"item": fact.item},
    )
