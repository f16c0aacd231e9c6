"""One picture of a moving one: a photograph of the room, and beside it the tree as it was then.

OpenCV draws it, which is loaded only when this is.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.executive.render.text import Line, lines_within
from tandem.skills.ports.tasks import NodeStatus, TreeNode

Picture = NDArray[np.uint8]
Colour = tuple[int, int, int]
TREE_WIDTH: Final = 330
"""Pixels of the tree's column: its longest names in the fetch's tree, at this size of letters."""
ROW: Final = 19
"""Pixels from line to line."""
INDENT: Final = 13
"""Pixels by which a child stands farther right than its parent."""
LETTERS: Final = 0.42
"""OpenCV's scale: about 12 pixels high."""
MARGIN: Final = 12
"""Pixels around the tree."""
WEBP_QUALITY: Final = 70
"""Of 100: letters stay sharp, and a fetch takes 0.4 MB."""
_INK: Final[Colour] = (40, 38, 34)
_FAINT: Final[Colour] = (150, 148, 144)
_DOTS: Final = MappingProxyType(
    {
        NodeStatus.INVALID: (205, 203, 200),
        NodeStatus.RUNNING: (20, 160, 240),
        NodeStatus.SUCCESS: (80, 160, 60),
        NodeStatus.FAILURE: (60, 60, 210),
    }
)
"""Colours of a node's dot, by status (blue, green, red)."""


def frame(photograph: bytes, root: TreeNode, title: str) -> Picture:
    """Return the room beside the tree, shape (height, width + ``TREE_WIDTH``, 3).

    Args:
        photograph: PNG of the room.
        root: the tree; as much of it is drawn as the picture has lines for, with what runs.
        title: a line above it.

    Raises:
        ValueError: when the photograph is no picture.
    """
    room = cv2.imdecode(np.frombuffer(photograph, np.uint8), cv2.IMREAD_COLOR)
    if room is None:
        raise ValueError(f"expected a PNG of the room, found {len(photograph)} bytes that are none")
    height = room.shape[0]
    column: Picture = np.full((height, TREE_WIDTH, 3), 250, dtype=np.uint8)
    rows = (height - 2 * MARGIN) // ROW
    _write(column, title, MARGIN, MARGIN + ROW - 6, _INK)
    for row, line in enumerate(lines_within(root, rows - 2), start=2):
        _draw_line(column, line, MARGIN + row * ROW + ROW - 6)
    return np.concatenate((room.astype(np.uint8), column), axis=1)


def save(path: Path, frames: Sequence[Picture], seconds: float) -> None:
    """Write a moving picture that repeats; its kind follows from the file's ending.

    Args:
        path: where to.
        frames: at least one, all of one shape.
        seconds: that each is shown; the last one is shown for ten times as long.

    Raises:
        OSError: when it can't be written.
    """
    animation = cv2.Animation()
    animation.frames = list(frames)
    durations = np.full(len(frames), round(seconds * 1000), dtype=np.int32)
    durations[-1] *= 10
    animation.durations = durations.tolist()
    path.parent.mkdir(parents=True, exist_ok=True)
    path.touch()  # says why it can't be written, which OpenCV does not
    if not cv2.imwriteanimation(str(path), animation, [cv2.IMWRITE_WEBP_QUALITY, WEBP_QUALITY]):
        raise OSError(f"{path}: OpenCV could not write the moving picture")


def _draw_line(column: Picture, line: Line, baseline: int) -> None:
    """Draw a node: a dot of its status' colour, its name, and how much is folded below it."""
    left = MARGIN + INDENT * (len(line.lead) // 3)
    middle = (left + 4, baseline - 4)
    thickness = 1 if line.status is NodeStatus.INVALID or line.past else cv2.FILLED
    cv2.circle(column, middle, 4, _DOTS[line.status], thickness, cv2.LINE_AA)
    runs = line.status is NodeStatus.RUNNING and not line.past
    faint = line.past or line.status is NodeStatus.INVALID
    after = _write(column, line.name, left + 14, baseline, _FAINT if faint else _INK)
    if runs:
        cv2.line(column, (left + 14, baseline + 3), (after, baseline + 3), _DOTS[line.status], 2)
    if line.note:
        _write(column, f"({line.note})", after + 6, baseline, _FAINT)


def _write(column: Picture, text: str, left: int, baseline: int, colour: Colour) -> int:
    """Write a line, cut at the column's edge; return where it ends."""
    plain = text.encode("ascii", "replace").decode()
    room = TREE_WIDTH - MARGIN - left
    while plain and _width(plain) > room:
        plain = plain[:-1]
    cv2.putText(
        column, plain, (left, baseline), cv2.FONT_HERSHEY_SIMPLEX, LETTERS, colour, 1, cv2.LINE_AA
    )  # fmt: skip
    return left + _width(plain)


def _width(text: str) -> int:
    (width, _), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, LETTERS, 1)
    return int(width)
