"""Numbers whose squares are beyond a float would end a skill in the middle of its sums: they are refused."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from tandem.skills.ports.actions.arm import MoveGoal
from tandem.skills.ports.actions.base import GoGoal
from tandem.skills.ports.message import FARTHEST, Message
from tandem.skills.ports.pose import FloorPose, Pose

AT_MOST = [
    (Pose, '{"position": [%s, 0.0, 0.0]}'),
    (FloorPose, '{"x": 0.0, "y": %s, "yaw": 0.0}'),
    (GoGoal, '{"x": %s, "y": 0.0}'),
    (MoveGoal, '{"joints": [0.0, %s]}'),
]


@pytest.mark.parametrize(("message", "document"), AT_MOST)
def test_a_place_or_joint_beyond_all_reckoning_is_refused(message: type[Message], document: str) -> None:
    assert message.model_validate_json(document % -FARTHEST)
    with pytest.raises(ValidationError, match="less than or equal to 1000000"):
        message.model_validate_json(document % "1e300")
