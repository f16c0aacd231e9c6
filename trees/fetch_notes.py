"""What a fetch's wind-down must know after a restart: which hand closed on the item, and where it stood."""

from __future__ import annotations

from typing import Final

from tandem.skills.geometry.poses import compose
from tandem.skills.ports.message import HandName, Message
from tandem.skills.ports.site import Slot
from tandem.trees.board import FetchBoard
from tandem.trees.context import TreeContext

NAME: Final = "fetch"


class FetchNotes(Message):
    """Kept with the task (``TreeContext.keep``)."""

    closed: HandName | None = None
    """The hand that was told to close on the item, until it is told to let go; it need not hold it yet."""
    origin: Slot | None = None
    """Where the item stood before."""


def closes(context: TreeContext, board: FetchBoard) -> None:
    """Note that the chosen hand is about to close on the item where it stands."""
    grasp = board.chosen_grasp()
    # The hand goes to the item's middle; it stands half its height below.
    x, y, z = compose(grasp.grasp, grasp.item_in_tool).position
    bottom = (x, y, z - board.site_item(context).size[2] / 2.0)
    board.origin = Slot(position=bottom, facing=board.facing or 0.0)
    context.notes.keep(NAME, FetchNotes(closed=board.chosen_side(), origin=board.origin))


def lets_go(context: TreeContext, board: FetchBoard) -> None:
    """Note that the hand is about to let go of the item."""
    context.notes.keep(NAME, FetchNotes(origin=board.origin))


def recall(context: TreeContext) -> FetchNotes:
    """Return what is noted, by this tree or by the one of before a restart."""
    return context.notes.kept(NAME, FetchNotes) or FetchNotes()
