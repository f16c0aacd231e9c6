"""Look all around when no way is free: what the map holds may be gone, or never was there.

The map of occupied space keeps what no picture shows. What was carried away behind the robot's back, or what
one wrong picture painted, stands in the way until it is looked at.
"""

from __future__ import annotations

from collections.abc import Callable

from py_trees.composites import Sequence

from tandem.trees.behaviours.each import Each
from tandem.trees.behaviours.note import Note
from tandem.trees.behaviours.recovery import RecoveryStep
from tandem.trees.context import TreeContext
from tandem.trees.leaves.look_round import look_round
from tandem.trees.leaves.rotate import ALL_AROUND, rotate
from tandem.trees.recovery_kinds import seeing_helps


def see_the_way(
    where: str, context: TreeContext, then: Callable[[], None] = lambda: None
) -> tuple[RecoveryStep, ...]:
    """Return the recovery, once; none where the site has no map of occupied space.

    Args:
        where: makes its names unique.
        context: of the tree.
        then: called when all has been looked at.
    """
    if context.site.occupancy is None:
        return ()

    def seen() -> str:
        then()
        return "what stands around is known anew"

    turn = Sequence(
        f"{where}: turn and see",
        memory=True,
        children=[
            rotate(f"{where}: turn 30 degrees", context),
            look_round(f"{where}: see what stands there", context, lambda _: None),
        ],
    )
    repair = Sequence(
        f"{where}: look all around",
        memory=True,
        children=[
            Each(f"{where}: all 360 degrees", turn, lambda: False, ALL_AROUND),
            Note(f"{where}: all is seen", seen),
        ],
    )
    return (RecoveryStep(f"{where}: see what is in the way", seeing_helps, 1, repair),)
