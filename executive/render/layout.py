"""Where the boxes of a drawn tree stand: the root on the left, children in their order from top to bottom.

The tidy layout of Reingold and Tilford (1981, "Tidier Drawings of Trees") with depth along x: a parent stands
in the middle of its children, boxes of a depth never come closer than a row, and subtrees are pushed
together as far as their outlines allow.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from tandem.executive.render.folded import note_of
from tandem.skills.ports.tasks import TreeNode

BOX_HEIGHT: Final = 24.0
"""Pixels of a box with one line."""
NOTED_HEIGHT: Final = 36.0
"""Pixels of a box with a second line, which says what is left out."""
BETWEEN: Final = 8.0
"""Pixels between a box and the one below."""
GAP: Final = 26.0
"""Pixels between two columns, for the edges."""
MARGIN: Final = 16.0
"""Pixels around the drawing."""
CHARACTER: Final = 6.6
"""Pixels that a character takes, about, at a size of 12."""
NOTE_CHARACTER: Final = 5.5
"""Pixels that a character takes, about, at a size of 10."""
PADDING: Final = 34.0
"""Pixels of a box beside its name: the sign of the kind, and room."""


@dataclass(frozen=True)
class PlacedNode:
    """A node's box: left edge and vertical centre, in pixels."""

    node: TreeNode
    x: float
    y: float
    width: float

    @property
    def height(self) -> float:
        """Its height; that of a box with a note is larger."""
        return NOTED_HEIGHT if note_of(self.node) else BOX_HEIGHT


@dataclass(frozen=True)
class Layout:
    """All boxes, the edges as pairs of indices (parent, child), and the size of the whole, in pixels."""

    boxes: tuple[PlacedNode, ...]
    edges: tuple[tuple[int, int], ...]
    width: float
    height: float


@dataclass
class _Shape:
    """A subtree laid out with its root at 0: offsets of its children, lowest and highest row by depth."""

    node: TreeNode
    children: list[tuple[float, _Shape]]
    top: list[float]
    bottom: list[float]


def lay_out(root: TreeNode) -> Layout:
    """Place the boxes of the tree."""
    shape = _shape(root)
    widths: list[float] = []
    _measure(root, 0, widths)
    lefts = [MARGIN]
    for width in widths[:-1]:
        lefts.append(lefts[-1] + width + GAP)
    box = NOTED_HEIGHT if _has_notes(root) else BOX_HEIGHT
    first_row = MARGIN + box / 2.0 - min(shape.top) * (box + BETWEEN)
    drawing = _Drawing(lefts, box + BETWEEN, [], [])
    drawing.place(shape, 0, first_row)
    height = first_row + max(shape.bottom) * drawing.row + box / 2.0 + MARGIN
    return Layout(tuple(drawing.boxes), tuple(drawing.edges), lefts[-1] + widths[-1] + MARGIN, height)


def _shape(node: TreeNode) -> _Shape:
    below = [_shape(child) for child in node.children]
    rows: list[float] = []
    bottom: list[float] = []
    top: list[float] = []
    for shape in below:
        shared = zip(bottom, shape.top, strict=False)
        row = max((deep - high + 1.0 for deep, high in shared), default=0.0)
        rows.append(row)
        high, low = [each + row for each in shape.top], [each + row for each in shape.bottom]
        top += high[len(top) :]
        bottom = low + bottom[len(low) :]
    middle = (rows[0] + rows[-1]) / 2.0 if rows else 0.0
    return _Shape(
        node,
        [(row - middle, shape) for row, shape in zip(rows, below, strict=True)],
        [0.0, *(each - middle for each in top)],
        [0.0, *(each - middle for each in bottom)],
    )


def _measure(node: TreeNode, depth: int, widths: list[float]) -> None:
    if depth == len(widths):
        widths.append(0.0)
    widths[depth] = max(widths[depth], box_width(node))
    for child in node.children:
        _measure(child, depth + 1, widths)


def box_width(node: TreeNode) -> float:
    """Return the pixels that a node's box needs for its name and its note."""
    return max(len(node.name) * CHARACTER, len(note_of(node)) * NOTE_CHARACTER) + PADDING


def _has_notes(node: TreeNode) -> bool:
    return bool(note_of(node)) or any(_has_notes(child) for child in node.children)


@dataclass
class _Drawing:
    """The boxes and edges so far, the left edge of each column, and pixels between centres of neighbours."""

    lefts: list[float]
    row: float
    boxes: list[PlacedNode]
    edges: list[tuple[int, int]]

    def place(self, shape: _Shape, depth: int, y: float) -> None:
        here = len(self.boxes)
        self.boxes.append(PlacedNode(shape.node, self.lefts[depth], y, box_width(shape.node)))
        for offset, child in shape.children:
            self.edges.append((here, len(self.boxes)))
            self.place(child, depth + 1, y + offset * self.row)


def overlaps(layout: Layout) -> list[tuple[str, str]]:
    """Return the paths of boxes of one column that touch; empty in a good layout."""
    ordered = sorted(layout.boxes, key=lambda box: (box.x, box.y))
    return [
        (above.node.path, below.node.path)
        for above, below in pairwise(ordered)
        if above.x == below.x and below.y - above.y < (above.height + below.height) / 2.0
    ]
