"""Go home: arms tucked in, base at the site's home pose."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from skills.ports.geometry import FloorPose
from skills.ports.world import SIDES
from trees.conditions.arm_tucked import arm_tucked
from trees.conditions.at_pose import at_any
from trees.context import TreeContext
from trees.leaves.drive import drive
from trees.leaves.tuck_arm import tuck_arm


def tuck(context: TreeContext, where: str) -> Behaviour:
    """Return the subtree that has both arms tucked in; ``where`` in the tree makes its names unique."""
    arms = [
        Selector(
            f"{where}: {side} arm in",
            memory=True,
            children=[arm_tucked(context, side, where), tuck_arm(f"{where}: tuck {side} arm", context, side)],
        )
        for side in SIDES
    ]
    return Sequence(f"{where}: arms in", memory=True, children=arms)


def home(context: TreeContext, where: str = "home") -> Behaviour:
    """Return the subtree; it asks first whether the robot is there already."""

    def poses() -> tuple[FloorPose, ...]:
        return (context.site.home,)

    base = Selector(
        f"{where}: base",
        memory=True,
        children=[at_any(f"{where}: at home?", context, poses), drive(f"{where}: drive", context, poses)],
    )
    return Sequence(f"{where}: go", memory=True, children=[tuck(context, where), base])
