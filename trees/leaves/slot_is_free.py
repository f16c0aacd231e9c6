"""Is the slot free, as far as it has been seen?"""

from __future__ import annotations

from typing import Final

from tandem.skills.geometry.poses import invert, transform
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.occupancy import Occupancy
from tandem.skills.ports.world import Box
from tandem.trees.behaviours.decide import Decide
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext

ROOM: Final = 0.02
"""Metres between what is put down and what stands beside it, in plan."""
ABOVE: Final = 0.01
"""Metres above the slot from which on something stands on it: lower is the depot's own top."""


HIGH: Final = 0.5
"""Metres above the slot from which on something does not stand on it."""


def slot_is_free(name: str, context: TreeContext, board: FetchBoard) -> Decide:
    """Return the leaf: SLOT_TAKEN when an item or clutter stands where the item would be put."""

    def decide() -> str | Failure:
        slot, size = board.chosen_slot(context), board.site_item(context).size
        around = max(size[0], size[1]) / 2.0 + ROOM
        scene = context.knowledge.scene
        for thing in () if scene is None else scene.objects:
            loose = thing.kind != "furniture" and thing.attached_to is None and thing.item != board.item
            if loose and _covers(thing.box, slot.position, around):
                return Failure(
                    kind=FailureKind.SLOT_TAKEN,
                    message=f"{thing.name} stands in slot {board.slot} of {board.destination}",
                    evidence={"thing": thing.name, "slot": -1 if board.slot is None else board.slot},
                )
        if (
            scene is not None
            and scene.occupied is not None
            and _occupied(scene.occupied, slot.position, around)
        ):
            return Failure(
                kind=FailureKind.SLOT_TAKEN,
                message=f"something unknown stands in slot {board.slot} of {board.destination}",
                evidence={"thing": "unknown", "slot": -1 if board.slot is None else board.slot},
            )
        return "nothing stands there"

    return Decide(name, context, decide)


def _occupied(cells: Occupancy, point: Vector3, around: float) -> bool:
    """Say whether the middle of a cell lies within ``around`` metres of the point in plan, and above it."""
    half = cells.resolution / 2.0
    return any(
        abs(x + half - point[0]) < around
        and abs(y + half - point[1]) < around
        and ABOVE < z + half - point[2] < HIGH
        for x, y, z in cells.corners()
    )


def _covers(box: Box, point: Vector3, around: float) -> bool:
    """Say whether the box comes within ``around`` metres of the point in plan, and rises above it."""
    x, y, _ = transform(invert(box.pose), point)
    height = box.pose.position[2] + box.size[2] / 2.0 - point[2]
    within = abs(x) < box.size[0] / 2.0 + around and abs(y) < box.size[1] / 2.0 + around
    return within and height > ABOVE and box.pose.position[2] - box.size[2] / 2.0 < point[2] + HIGH
