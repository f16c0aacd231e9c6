"""What a leaf that moves a hand needs of a board, whether a fetch's or one hand's."""

from __future__ import annotations

from typing import Protocol

from tandem.skills.ports.message import HandName
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.site import SiteItem
from tandem.trees.context import TreeContext


class HandTask(Protocol):
    """A hand and the item that it is for. A board derives from it, and leaves ask for nothing more."""

    item: int

    def chosen_side(self) -> HandName:
        """Return the arm."""
        ...

    def node(self, what: str) -> str:
        """Return the name of a node that does ``what``: unique among all hands of a tree."""
        ...

    def item_in_tool(self) -> Pose:
        """Return the item's centre frame in the tool as it was grasped."""
        ...

    def attached(self) -> None:
        """Note that the item is in the hand."""
        ...

    def site_item(self, context: TreeContext) -> SiteItem:
        """Return what the site says of the item; the request has checked that it is known."""
        known = context.site.item(self.item)
        assert known is not None, "the request is checked against the site first"
        return known
