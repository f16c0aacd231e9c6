"""Stands of the base, before item and slot."""

from __future__ import annotations

from tandem.trees.conditions.at_pose import POSITION_TOLERANCE, YAW_TOLERANCE
from tandem.trees.leaves.survey import SAME_STAND, SAME_YAW


def test_where_the_base_need_not_be_driven_again_is_no_other_stand() -> None:
    """Else a stand tried in vain is offered again as one 5 cm away, and the base is said to be there."""
    assert SAME_STAND >= POSITION_TOLERANCE
    assert SAME_YAW >= YAW_TOLERANCE
