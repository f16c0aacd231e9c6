"""Go home: arms tucked in, base at the site's home pose."""

from __future__ import annotations

from typing import Final

from py_trees.behaviour import Behaviour
from py_trees.composites import Selector, Sequence

from tandem.skills.ports.pose import FloorPose
from tandem.trees.behaviours.recovery import Recovery
from tandem.trees.conditions.at_pose import at_any
from tandem.trees.context import TreeContext
from tandem.trees.subtrees.arms_in import free_and_tuck
from tandem.trees.subtrees.recovery_steps import let_pass, localise_again, wait_back
from tandem.trees.subtrees.see_the_way import see_the_way
from tandem.trees.subtrees.travel import drive_and_give_way

WITHIN: Final = 180.0
"""Robot seconds after which a way home is not tried again."""


def home(context: TreeContext, where: str = "home") -> Behaviour:
    """Return the subtree that tucks the arms in and drives home."""
    return Sequence(
        f"{where}: go", memory=True, children=[free_and_tuck(context, where), drive_home(context, where)]
    )


def drive_home(context: TreeContext, where: str) -> Behaviour:
    """Return the subtree of the way home with arms that are in; it asks first whether the robot is there."""

    def poses() -> tuple[FloorPose, ...]:
        return (context.site.home,)

    return Selector(
        f"{where}: base",
        memory=True,
        children=[
            at_any(f"{where}: at home?", context, poses),
            drive_and_give_way(f"{where}: drive", context, poses),
        ],
    )


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
            *see_the_way("home", context),
        ),
        within=WITHIN,
    )
