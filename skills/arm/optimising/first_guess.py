"""Where an optimiser begins: on the straight line, or near a path that another planner has found."""

from __future__ import annotations

import numpy as np

from tandem.skills.arm.optimising.smoothness import Smoothness
from tandem.skills.kinematics.transforms import Array


def near(waypoints: Array, form: Smoothness, follow: float) -> Array:
    """Return a smooth path (N + 2, n) near the polyline through the waypoints (m, n).

    It is the x of the least smoothness cost + follow / 2 * |x - polyline|^2 h: corners are rounded.
    """
    line = resampled(waypoints, form.count + 2)
    weight = follow / (form.count + 1)
    path = line.copy()
    pulled = form.gradient(line)
    path[1:-1] -= np.linalg.solve(form.matrix + weight * np.eye(form.count), pulled)
    return path


def resampled(waypoints: Array, count: int) -> Array:
    """Return so many points, evenly spread over the length of the polyline through the waypoints."""
    lengths = np.linalg.norm(np.diff(waypoints, axis=0), axis=1)
    ends = np.concatenate(([0.0], np.cumsum(lengths)))
    at = np.linspace(0.0, ends[-1], count)
    columns = [np.interp(at, ends, column) for column in waypoints.T]
    return np.stack(columns, axis=1)
