"""Where everything is at a task's end: what an operator asks first when it has failed."""

from __future__ import annotations

from tandem.trees.board import FetchBoard
from tandem.trees.conditions.arm_tucked import tucked
from tandem.trees.conditions.at_pose import near
from tandem.trees.context import TreeContext


def where_all_is(context: TreeContext, board: FetchBoard) -> dict[str, str]:
    """Return where robot and item are, in words, as far as anybody knows."""
    return {**where_robot_is(context), "item_is": _item(context, board)}


def where_robot_is(context: TreeContext) -> dict[str, str]:
    """Return where the robot is, in words: for tasks that are about no item."""
    return {"robot_is": _robot(context)}


def _robot(context: TreeContext) -> str:
    robot = context.knowledge.robot
    out = [side for side in context.knowledge.hands if not tucked(context, side)]
    arms = "" if not out else f", {' and '.join(out)} arm not tucked in"
    if robot is None or not robot.localised:
        return f"unknown{arms}"
    if near(context, context.site.home):
        return f"at home{arms}"
    pose = robot.base_in_map
    return f"at ({pose.x:.2f}, {pose.y:.2f}) m in the map{arms}"


def _item(context: TreeContext, board: FetchBoard) -> str:
    world, fact = context.knowledge.world, board.fact(context)
    for hand in () if world is None else world.held:
        if hand.item == board.item:
            return f"in the {hand.side} hand"
    for placed in () if world is None else world.placed:
        if placed.item == board.item:
            return f"in slot {placed.slot} of {placed.depot}"
    if fact is None:
        return "unknown"
    x, y, z = fact.tag_in_map.position
    return f"last seen at ({x:.2f}, {y:.2f}, {z:.2f}) m in the map"
