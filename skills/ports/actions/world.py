"""Change what is believed: the planning scene and what is in which hand."""

from __future__ import annotations

from enum import StrEnum
from typing import Final

from tandem.skills.ports.message import Count, HandName, Message
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.skill import ActionType


class SceneEdit(StrEnum):
    """The order-picking paper's changes to the scene (III-D)."""

    ADD = "add"
    ATTACH = "attach"
    DETACH = "detach"
    REMOVE = "remove"
    FORGET = "forget"
    SELECT = "select"


class EditGoal(Message):
    """Apply ``edit`` to the item.

    ADD: the item, where it was last seen, becomes an obstacle. ATTACH: it is now in the hand of
    ``side``, at ``item_in_tool``.
    DETACH: it was put down at ``item_in_map``, into ``slot`` of ``depot`` if that is given.
    REMOVE: it is no longer an obstacle.
    FORGET: its place is unknown until it is seen again; an item in a hand can't be forgotten.
    SELECT: of several objects with that number, the one nearest to ``near`` is the item.
    """

    edit: SceneEdit
    item: Count
    side: HandName | None = None
    item_in_tool: Pose | None = None
    item_in_map: Pose | None = None
    depot: str | None = None
    slot: Count | None = None
    near: tuple[float, float] | None = None
    """x, y in the map (m)."""


class EditFeedback(Message):
    """Empty: edits take effect at once."""


class EditResult(Message):
    """The scene's version after the edit."""

    version: Count


EDIT: Final = ActionType("world/edit", EditGoal, EditFeedback, EditResult, timeout=5.0)
