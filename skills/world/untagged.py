"""What stands about without a number: boxes of clutter that looks show, and cells that depth shows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from tandem.skills.ports.occupancy import Occupancy
from tandem.skills.ports.world import Box, Clutter
from tandem.skills.world import clutter, occupied


class Untagged:
    """Both, as they are believed.

    Args:
        boxes: of clutter, with their names, as a journal gave them back.
        cells_for_clutter: whether occupied cells take the place of boxes at this site.
    """

    def __init__(self, boxes: tuple[tuple[str, Box], ...], *, cells_for_clutter: bool) -> None:
        self.boxes = boxes
        """The boxes of clutter, with their names."""
        self._cells_for_clutter, self._named = cells_for_clutter, 0
        self._occupied: Occupancy | None = None

    def look(self, seen: Clutter, standing: Sequence[Box]) -> bool:
        """Take in the clutter of a look, among items that stand there; say whether it changed anything."""
        measured: list[tuple[str, Box]] = []
        for box in () if self._cells_for_clutter else seen.boxes:
            if any(clutter.contains(item, box.pose.position, clutter.ITEM_MARGIN) for item in standing):
                continue
            measured.append((self._new_name({name for name, _ in (*self.boxes, *measured)}), box))
        before, self.boxes = self.boxes, clutter.after_look(self.boxes, seen.view, measured)
        return self.boxes != before

    def recognise(self, item: Box) -> None:
        """Forget the boxes in an item's place: they were the item, unrecognised."""
        self.boxes = clutter.without_item(self.boxes, item)

    def occupy(self, told: Occupancy) -> bool:
        """Take in which space is occupied; say whether that changed anything."""
        before, self._occupied = self._occupied, told
        return before is None or not _same_cells(before, told)

    def occupied_but_for(self, things: Iterable[Box]) -> Occupancy | None:
        """Return the occupied cells that none of the things explains."""
        return None if self._occupied is None else occupied.without(self._occupied, things)

    def forget(self) -> None:
        """Believe in nothing of it: the hardware was off, and anything may have happened."""
        self.boxes, self._occupied = (), None

    def _new_name(self, taken: set[str]) -> str:
        """Return a name for a box of clutter; those that a journal gave back are taken."""
        while True:
            self._named += 1
            name = f"clutter_{self._named}"
            if name not in taken:
                return name


def _same_cells(one: Occupancy, other: Occupancy) -> bool:
    return (one.origin, one.shape, one.resolution, one.cells) == (
        other.origin,
        other.shape,
        other.resolution,
        other.cells,
    )
