"""What a checker's bodies are to the distance field: balls on joints, and who may not meet whom."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from tandem.skills.kinematics.pair_tables import PairTable
from tandem.skills.kinematics.spheres import SphereModel, Spheres


@dataclass(frozen=True)
class Body:
    """A body of the checker: pinocchio's number of its joint (0: it stands), its place there, and its balls.

    ``may_touch``: a contact with the world is no proof, as some contacts of it are permitted.
    """

    joint: int
    placement: pin.SE3
    balls: SphereModel
    may_touch: bool = False

    def placed(self, spheres: Spheres) -> Spheres:
        """Return balls of the body in its joint's frame."""
        turn, shift = np.asarray(self.placement.rotation), np.asarray(self.placement.translation)
        return Spheres(spheres.centres @ turn.T + shift, spheres.radii)


@dataclass(frozen=True)
class Meeting:
    """Two bodies that may not touch, by their places in the list of bodies; at most one of them stands.

    ``table`` answers for them if two joints at the most part them. ``may_touch``: a contact is no proof.
    """

    first: int
    second: int
    table: PairTable | None = None
    may_touch: bool = False
