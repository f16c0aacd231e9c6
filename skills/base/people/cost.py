"""What it costs to be near people: a Gaussian around where each will be, larger in front of them.

The shape is that of asymmetric Gaussians as social costmaps have them (Kirby 2010): one sigma ahead of the
person, which grows with their speed, one behind, one to the sides.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from tandem.skills.base.floor import FloatArray
from tandem.skills.base.people.forecast import Forecast

AHEAD: Final = (0.45, 0.35)
"""Metres, and metres for each m/s."""
BEHIND: Final = 0.35
"""Metres, at any speed."""
ASIDE: Final = 0.35
"""Metres to both sides. All are standard deviations, chosen."""


def costs(points: FloatArray, times: FloatArray, forecast: Forecast) -> FloatArray:
    """Return the costs, 0 to 1, of being at the points, shape (k, 2), each at its time (s after the scan)."""
    if not len(forecast.sigmas):
        return np.zeros(len(points))
    places, velocities = forecast.at(times)
    speed = np.hypot(velocities[..., 0], velocities[..., 1])
    ahead = velocities / np.maximum(speed, 1e-6)[..., None]
    off = points[None, :, :] - places
    along = (off * ahead).sum(axis=-1)
    square = (off**2).sum(axis=-1)
    aside = np.maximum(square - along**2, 0.0)
    sigma = np.where(along > 0.0, AHEAD[0] + AHEAD[1] * speed, BEHIND)
    # Who stands has no front.
    turned = speed > 1e-3  # noqa: PLR2004 - 1 mm/s
    exponent = np.where(turned, along**2 / sigma**2 + aside / ASIDE**2, square / AHEAD[0] ** 2)
    return np.asarray(np.exp(-exponent / 2.0).max(axis=0))
