"""Places in the map that a request names, and whether they are within the site."""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.problems import Problem
from tandem.skills.ports.site import Site

FARTHEST: Final = 1000.0
"""Metres from the map's origin."""
MapX = Annotated[float, Field(ge=-FARTHEST, le=FARTHEST, examples=[0.0], description="m in the map")]
MapY = Annotated[float, Field(ge=-FARTHEST, le=FARTHEST, examples=[0.0], description="m in the map")]
Tolerance = Annotated[float, Field(ge=0.05, le=2.0, description="how far from the place it may end, in m")]


def outside(x: float, y: float, site: Site, path: str = "") -> tuple[Problem, ...]:
    """Return what is wrong with a place that is not on the site's floor; ``path``: of the place."""
    x_min, y_min, x_max, y_max = site.bounds
    axes = (("x", x, x_min, x_max), ("y", y, y_min, y_max))
    return tuple(
        Problem(path=f"{path}{axis}", expected=f"{low:g} to {high:g} m, the site's floor", found=f"{at:g}")
        for axis, at, low, high in axes
        if not low <= at <= high
    )
