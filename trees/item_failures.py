"""What is told of an item that a hand has lost, or can't take hold of: the same in all trees."""

from __future__ import annotations

from collections.abc import Iterable

from tandem.skills.grasping.item_frames import upright_in_map
from tandem.skills.ports.actions.perception import LookResult
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName
from tandem.skills.ports.world import ItemFact, Sighting
from tandem.trees.context import TreeContext


def evidence_of(item: int, result: LookResult) -> dict[str, int | float]:
    """Return what a look that has not shown an item has to say: also that the head was held up."""
    short = {"head_short_rad": round(result.head_short, 3)} if result.head_short else {}
    return {"item": item, **short}


def ambiguous(context: TreeContext, item: int, sightings: Iterable[Sighting] = ()) -> Failure | None:
    """Return the failure of an item of which several are known or have just been seen, or None for one."""
    world = context.knowledge.world
    known = () if world is None else world.those(item)
    if any(fact.held is not None for fact in known):
        return None
    seen = [each.tag_in_map for each in sightings if each.item == item]
    tags = max(seen, [fact.tag_in_map for fact in known], key=len)
    if len(tags) < 2:  # noqa: PLR2004 - one is no choice
        return None
    places = ", ".join(f"({tag.position[0]:.2f}, {tag.position[1]:.2f})" for tag in tags)
    return Failure(
        kind=FailureKind.ITEM_AMBIGUOUS,
        message=f"{len(tags)} things are {context.called(item)}, at {places}; `near` of a fetch says which",
        evidence={"item": item, "things": len(tags)},
    )


def fallen_over(context: TreeContext, fact: ItemFact) -> Failure | None:
    """Return the failure of an item that is not upright, or None for one that is."""
    return None if upright_in_map(fact.tag_in_map, fact.size[0]) is not None else lies(context, fact)


def lies(context: TreeContext, fact: ItemFact) -> Failure:
    """Return the failure of an item that has fallen over."""
    return Failure(
        kind=FailureKind.ITEM_UNREACHABLE,
        message=f"{context.called(fact.item)} has fallen over: hands take hold of what stands upright",
        evidence={"item": fact.item},
    )


def no_longer_held(context: TreeContext, item: int, side: HandName) -> Failure:
    """Return the failure of an item that was in a hand."""
    return Failure(
        kind=FailureKind.GRASP_LOST,
        message=f"{context.called(item)} is no longer in the {side} hand",
        evidence={"item": item, "side": side},
    )
