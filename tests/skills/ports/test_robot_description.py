"""A description that contradicts itself is refused by name, before anything moves."""

from __future__ import annotations

import pytest
from pydantic import JsonValue, ValidationError

from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.testing.mock_description import mock_description

WHOLE = mock_description().model_dump(mode="json")
HAND, GROUP, POSTURE = WHOLE["end_effectors"][0], WHOLE["groups"][0], WHOLE["postures"][0]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"groups": [*WHOLE["groups"], GROUP]}, f"groups: expected unique names.*{GROUP['name']}"),
        ({"end_effectors": [HAND, HAND]}, f"end_effectors: expected unique sides.*{HAND['side']}"),
        ({"postures": [POSTURE | {"positions": []}]}, "expected [0-9]+ positions, found 0"),
    ],
)
def test_what_is_there_twice_or_does_not_fit_is_named(change: dict[str, JsonValue], said: str) -> None:
    assert RobotDescription.model_validate(WHOLE)
    with pytest.raises(ValidationError, match=said):
        RobotDescription.model_validate(WHOLE | change)
