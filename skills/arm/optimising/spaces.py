"""What the optimisers ask of the world: distances, and where the robot's spheres are."""

from __future__ import annotations

from typing import Protocol

from tandem.skills.kinematics.transforms import Array


class DistanceField(Protocol):
    """Signed distances to everything that stands around, in the base frame."""

    def distances(self, points: Array) -> Array:
        """Return the metres (m,) from points (m, 3) to the nearest surface; below zero inside."""
        ...

    def gradients(self, points: Array) -> Array:
        """Return how the distances grow, (m, 3): unit vectors, or zero where nothing is near."""
        ...


class Spheres(Protocol):
    """A robot as its spheres."""

    @property
    def radii(self) -> Array:
        """Metres, (s,)."""
        ...

    def centres(self, q: Array) -> Array:
        """Return the centres (m, s, 3) in the base at joint positions (m, n)."""
        ...

    def pull(self, q: Array, forces: Array) -> Array:
        """Return J^T f: what forces (m, s, 3) at the centres do to the joints, (m, n)."""
        ...
