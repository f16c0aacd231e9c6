"""How hard two hands press: from the wrists' forces to how far each hand is pushed inwards.

Each hand first advances until it feels the thing, and waits for the other one; then both press as one. The
law is an admittance: the hands' distance shrinks at a speed in proportion to the force that is missing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

TOUCH: Final = 3.0
"""Newtons at which a hand is said to feel the thing."""
ADVANCE: Final = 0.04
"""m/s at which a hand that feels nothing comes nearer."""
GAIN: Final = 2e-4
"""m/s of each hand for a newton that is missing."""
FASTEST: Final = 0.01
"""m/s of each hand at the most while it presses."""
AGREE: Final = 0.25
"""Share of the wanted force by which each hand's may be off."""


@dataclass(frozen=True)
class Grasp:
    """Both hands' squeeze: metres inwards (left, right), and whether each has felt the thing."""

    inwards: tuple[float, float] = (0.0, 0.0)
    felt: tuple[bool, bool] = (False, False)

    @property
    def holds(self) -> bool:
        """Whether both hands have felt it."""
        return all(self.felt)

    def pressed(self, forces: tuple[float, float], wanted: float, period: float) -> Grasp:
        """Return the squeeze one period (s) later.

        Args:
            forces: newtons with which the left and the right hand press.
            wanted: newtons of each.
            period: seconds.
        """
        if not self.holds:
            felt = (self.felt[0] or forces[0] >= TOUCH, self.felt[1] or forces[1] >= TOUCH)
            inwards = (
                self.inwards[0] + (0.0 if felt[0] else ADVANCE * period),
                self.inwards[1] + (0.0 if felt[1] else ADVANCE * period),
            )
            return Grasp(inwards, felt)
        missing = wanted - 0.5 * (forces[0] + forces[1])
        step = period * max(-FASTEST, min(FASTEST, GAIN * missing))
        return replace(self, inwards=(self.inwards[0] + step, self.inwards[1] + step))


def agree(forces: tuple[float, float], wanted: float) -> bool:
    """Say whether both hands press as hard as wanted."""
    return all(abs(force - wanted) <= AGREE * wanted for force in forces)
