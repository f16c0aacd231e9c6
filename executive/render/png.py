"""A tree as PNG: the same layout as the SVG's, drawn with OpenCV, which is loaded only when this is."""

from __future__ import annotations

from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.executive.render.folded import note_of
from tandem.executive.render.layout import BOX_HEIGHT, GAP, Layout, PlacedNode, lay_out
from tandem.executive.render.signs import EDGES, FILLS, KIND_SIGNS_ASCII
from tandem.skills.ports.tasks import TreeNode

SCALE: Final = 2.0
"""Pixels of the picture for one of the layout."""
NAME_SIZE: Final = 0.38
NOTE_SIZE: Final = 0.32
"""Scales of OpenCV's font: about 12 and 10 pixels of the layout."""
_SHIFT: Final = 4
"""Bits behind the point in OpenCV's coordinates."""
Picture = NDArray[np.uint8]
Colour = tuple[int, int, int]


def png(root: TreeNode) -> bytes:
    """Return the tree as a PNG file's content."""
    layout = lay_out(root)
    shape = (round(layout.height * SCALE), round(layout.width * SCALE), 3)
    picture: Picture = np.full(shape, 255, dtype=np.uint8)
    _draw_edges(picture, layout)
    for box in layout.boxes:
        _draw_box(picture, box)
    done, content = cv2.imencode(".png", picture)
    if not done:
        raise OSError("OpenCV could not make a PNG of the tree")
    return bytes(content)


def _draw_edges(picture: Picture, layout: Layout) -> None:
    share = np.linspace(0.0, 1.0, 24)
    eased = share * share * (3.0 - 2.0 * share)
    for parent, child in layout.edges:
        a, b = layout.boxes[parent], layout.boxes[child]
        xs = np.concatenate(([a.x + a.width], b.x - GAP + GAP * share))
        ys = np.concatenate(([a.y], a.y + (b.y - a.y) * eased))
        points = np.rint(np.stack((xs, ys), axis=1) * SCALE * (1 << _SHIFT)).astype(np.int32)
        cv2.polylines(
            picture, [points], isClosed=False, color=(176, 184, 184), thickness=2, lineType=cv2.LINE_AA,
            shift=_SHIFT,
        )  # fmt: skip


def _draw_box(picture: Picture, box: PlacedNode) -> None:
    node = box.node
    edge = _colour(EDGES[node.kind])
    corner = {"condition": BOX_HEIGHT / 2.0, "action": 3.0}.get(node.kind, 7.0)
    outline = _rounded(box, corner)
    cv2.fillPoly(picture, [outline], _colour(FILLS[node.shown]), lineType=cv2.LINE_AA, shift=_SHIFT)
    cv2.polylines(
        picture, [outline], isClosed=True, color=edge, thickness=2, lineType=cv2.LINE_AA, shift=_SHIFT
    )
    note = note_of(node)
    baseline = box.y + (-1.5 if note else 4.5)
    _write(picture, KIND_SIGNS_ASCII[node.kind], (box.x + 6.0, baseline), edge, 18.0)
    name = node.name.encode("ascii", "replace").decode()
    _write(picture, name, (box.x + 26.0, baseline), (34, 34, 34), box.width - 30.0)
    if note:
        _write(picture, note, (box.x + 26.0, baseline + 13.0), (90, 95, 95), box.width - 30.0, size=NOTE_SIZE)


def _rounded(box: PlacedNode, radius: float) -> NDArray[np.int32]:
    """Return a box with round corners as a polygon, clockwise from its upper left."""
    left, top, width = box.x, box.y - box.height / 2.0, box.width
    turn = np.linspace(0.0, np.pi / 2.0, 8)
    centres = (
        (left + radius, top + radius, np.pi),
        (left + width - radius, top + radius, 1.5 * np.pi),
        (left + width - radius, top + box.height - radius, 0.0),
        (left + radius, top + box.height - radius, 0.5 * np.pi),
    )
    corners = [
        np.stack((x + radius * np.cos(start + turn), y + radius * np.sin(start + turn)), axis=1)
        for x, y, start in centres
    ]
    outline: NDArray[np.int32] = np.rint(np.concatenate(corners) * SCALE * (1 << _SHIFT)).astype(np.int32)
    return outline


def _write(
    picture: Picture,
    text: str,
    at: tuple[float, float],
    colour: Colour,
    room: float,
    *,
    size: float = NAME_SIZE,
) -> None:
    """Write from the lower left corner ``at``, smaller where the text would be wider than ``room``."""
    size *= SCALE
    (wide, _), _ = cv2.getTextSize(text, cv2.FONT_HERSHEY_SIMPLEX, size, 1)
    size *= min(1.0, room * SCALE / max(wide, 1))
    corner = (round(at[0] * SCALE), round(at[1] * SCALE))
    cv2.putText(picture, text, corner, cv2.FONT_HERSHEY_SIMPLEX, size, colour, 1, cv2.LINE_AA)


def _colour(text: str) -> Colour:
    """Return "#rrggbb" as OpenCV's blue, green, red."""
    return (int(text[5:7], 16), int(text[3:5], 16), int(text[1:3], 16))
