"""The depth image: its noise, and points out of it."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.skills.ports.hardware import RgbdHeader

Array = NDArray[np.float64]


def sigma(z: float) -> float:
    """Return the standard deviation in metres of one depth pixel at z metres.

    That of a structured-light camera (Nguyen, Izadi and Lovell, 3DIMPVT 2012, section 3).
    """
    return 0.0012 + 0.0019 * (z - 0.4) ** 2


def inside(
    header: RgbdHeader, depth: NDArray[np.uint16], quad: Array, *, shrink: float, limit: int
) -> tuple[Array, int]:
    """Return points measured inside a quadrilateral of the picture.

    Args:
        header: the picture's intrinsics.
        depth: (height, width) millimetres.
        quad: (4, 2) corners in pixels, in order.
        shrink: the share by which the quadrilateral is drawn in towards its middle.
        limit: how many points are wanted at the most; taken evenly.

    Returns:
        (n, 3) points in metres in the camera's frame, and how many pixels were measured in all.
    """
    middle = quad.mean(axis=0)
    drawn_in = middle + (quad - middle) * (1.0 - shrink)
    low = np.maximum(np.floor(drawn_in.min(axis=0)).astype(int), 0)
    high = np.minimum(np.ceil(drawn_in.max(axis=0)).astype(int) + 1, (header.width, header.height))
    if np.any(high <= low):
        return np.zeros((0, 3)), 0
    mask = np.zeros((high[1] - low[1], high[0] - low[0]), np.uint8)
    cv2.fillConvexPoly(mask, np.round(drawn_in - low).astype(np.int32), 1)
    window = depth[low[1] : high[1], low[0] : high[0]]
    rows, columns = np.nonzero((mask > 0) & (window > 0))
    count = len(rows)
    if count == 0:
        return np.zeros((0, 3)), 0
    chosen = np.unique(np.linspace(0, count - 1, min(limit, count)).astype(int))
    rows, columns = rows[chosen], columns[chosen]
    z = window[rows, columns].astype(np.float64) / 1000.0
    return back_project(header, columns + low[0], rows + low[1], z), count


def back_project(header: RgbdHeader, columns: NDArray[np.int64], rows: NDArray[np.int64], z: Array) -> Array:
    """Return (n, 3) points in metres in the camera's frame; ``z`` is metres along the optical axis."""
    return np.stack(
        ((columns - header.cx) / header.fx * z, (rows - header.cy) / header.fy * z, z),
        axis=-1,
    )
