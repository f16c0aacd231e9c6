"""When a process of skills turns calmly."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any
from unittest.mock import create_autospec

import pytest

from tandem.executive.system.roles.registry import role_named
from tandem.executive.system.skill_process import calm_now
from tandem.skills.limbs import Limb
from tandem.skills.server import ActionServer


def node(kind: type[ActionServer[Any, Any, Any] | Limb], *, busy: bool) -> Any:
    made = create_autospec(kind, instance=True)
    made.busy = busy
    return made


@pytest.mark.parametrize("kind", [ActionServer, Limb])
@pytest.mark.parametrize(
    ("name", "busy", "expected"),
    [
        ("arm_left", False, True),
        ("arm_left", True, False),
        ("bimanual", False, False),
        ("base", False, False),
        ("keeper", True, True),
    ],
)
def test_arms_are_calm_while_neither_a_goal_nor_a_reflex_has_them(
    kind: type[ActionServer[Any, Any, Any] | Limb], *, name: str, busy: bool, expected: bool
) -> None:
    role = role_named(name)
    assert role is not None
    assert calm_now(role, [SimpleNamespace(), node(kind, busy=busy)]) is expected  # type: ignore[list-item]
