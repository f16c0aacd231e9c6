"""Is each item where its hand gets to? The workspace zones (two-arm thesis, 4.1.1) say so beforehand."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from tandem.skills.geometry.poses import compose, invert, to_pose, transform
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.message import HandName, Vector3
from tandem.trees.behaviours.decide import Decide
from tandem.trees.context import TreeContext
from tandem.trees.hand_board import HandBoard

OF: Final[Mapping[HandName, frozenset[str]]] = {"left": frozenset("LC"), "right": frozenset("RC")}
"""The zones that a hand of two reaches."""
WORDS = {
    "L": "only the left hand reaches it",
    "R": "only the right hand reaches it",
    "U": "no hand reaches it",
}


def within_reach(name: str, context: TreeContext, boards: tuple[HandBoard, ...]) -> Decide:
    """Return the leaf: FAILURE with ITEM_UNREACHABLE, naming the zone, when an item is out of its hand's."""

    def decide() -> str | Failure:
        zones = []
        for board in boards:
            if board.held(context):
                continue
            point = target_in_base(context, board)
            if isinstance(point, Failure):
                return point
            zone = zone_at(context, point)
            if not reaches(board.side, zone):
                return unreachable(context, board, zone, point)
            zones.append(f"{context.called(board.item)} in {zone} for the {board.side} hand")
        return ", ".join(zones) or "all is in the hands already"

    return Decide(name, context, decide)


def target_in_base(context: TreeContext, board: HandBoard) -> Vector3 | Failure:
    """Return where the hand takes hold (m in the base): the item's middle, or its grasp point."""
    item, robot = board.standing(context), context.knowledge.robot
    if isinstance(item, Failure):
        return item
    if robot is None:
        return Failure(kind=FailureKind.NOT_LOCALISED, message="the robot's pose has not been heard")
    known = board.site_item(context)
    in_item: Vector3 = (0.0, 0.0, 0.0)
    for point in known.grasp_points:
        if point.side == board.side:
            in_item = point.position
    return transform(compose(invert(to_pose(robot.base_in_map)), item), in_item)


def reaches(hand: HandName, zone: str) -> bool:
    """Say whether a hand gets to a zone."""
    return zone in OF.get(hand, frozenset("C"))


def zoned(context: TreeContext) -> bool:
    """Say whether the robot has the hands that zones are worked out for."""
    return OF.keys() <= set(context.knowledge.hands)


def zone_at(context: TreeContext, point: Vector3) -> str:
    """Return the zone's letter; the request has waited until the zones are known.

    For a robot without zones every point is within reach: the approach finds out.
    """
    if not zoned(context):
        return "C"
    zones = context.knowledge.zones
    return "U" if zones is None else zones.at(point)


def unreachable(context: TreeContext, board: HandBoard, zone: str, point: Vector3) -> Failure:
    """Return the failure of an item that stands where the hand can't go."""
    x, y, _ = point
    where = f"{WORDS[zone]} at ({x:.2f}, {y:.2f}) m"
    return Failure(
        kind=FailureKind.ITEM_UNREACHABLE,
        message=f"{context.called(board.item)} is for the {board.side} hand, but {where}",
        evidence={"item": board.item, "zone": zone, "x_m": round(x, 3), "y_m": round(y, 3)},
    )
