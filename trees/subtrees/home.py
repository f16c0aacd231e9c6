"""Go home: arms tucked in, base at the site's home pose."""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from skills.ports.geometry import FloorPose
from skills.ports.world import SIDES, Side
from trees.behaviours.recovery import Recovery
from trees.conditions.arm_tucked import arm_tucked
from trees.conditions.at_pose import at_any
from trees.conditions.hand_full import hand_full
from trees.context import TreeContext
from trees.leaves.drive import drive
from trees.leaves.open_hand import open_hand
from trees.leaves.retreat import retreat
from trees.leaves.tuck_arm import tuck_arm
from trees.subtrees.rungs import let_pass, localise_again, wait_back

WITHIN: Final = 180.0
"""Robot seconds after which a way home is not tried again."""


def tuck(context: TreeContext, where: str) -> Behaviour:
    """Return the subtree that has both arms tucked in; ``where`` in the tree makes its names unique."""
    arms = [
        Selector(f"{where}: {side} arm in", memory=True, children=_straight_in(context, side, where))
        for side in SIDES
    ]
    return Sequence(f"{where}: arms in", memory=True, children=arms)


def free_and_tuck(context: TreeContext, where: str) -> Behaviour:
    """Return the subtree that tucks both arms in whatever they are at.

    An arm that can't be tucked in as it is opens its hand, unless that holds something, draws back and is
    tucked in then: fingers may be around an item that nobody has grasped yet.
    """
    arms = [
        Selector(
            f"{where}: {side} arm in",
            memory=True,
            children=[*_straight_in(context, side, where), _free(context, side, where)],
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
    return Sequence(f"{where}: go", memory=True, children=[free_and_tuck(context, where), base])


def home_at_last(context: TreeContext) -> Behaviour:
    """Return the way home at a task's end, with what may be tried when it fails."""
    return Recovery(
        "get home",
        context,
        home(context),
        (
            wait_back("home", context),
            localise_again("home", context),
            let_pass("home", context, seconds=5.0, times=3),
        ),
        within=WITHIN,
    )


def _straight_in(context: TreeContext, side: Side, where: str) -> list[Behaviour]:
    return [arm_tucked(context, side, where), tuck_arm(f"{where}: tuck {side} arm", context, side)]


def _free(context: TreeContext, side: Side, where: str) -> Behaviour:
    hand = Selector(
        f"{where}: {side} hand free",
        memory=True,
        children=[
            hand_full(f"{where}: {side} hand full?", context, side),
            open_hand(f"{where}: open {side} hand", context, side),
        ],
    )
    return Sequence(
        f"{where}: free {side} arm",
        memory=True,
        children=[
            hand,
            retreat(f"{where}: draw {side} hand back", context, side),
            tuck_arm(f"{where}: tuck {side} arm then", context, side),
        ],
    )
